// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/recover_depth.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/depth/distant_pixels.h"
#include "core/analysis/depth/fill_depth.h"
#include "core/analysis/depth/filter_depth.h"
#include "core/analysis/depth/flying_pixels.h"
#include "core/analysis/depth/smooth_surfaces.h"
#include "core/base/staged_progress.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Lower bound of the relative noise of filtered depth, which never counts as exact, however smooth it is.
constexpr float kMinRemainingNoise = 2e-6f;

/// The photograph's depth, 0 wherever it is not a positive number.
ImageF validDepth(const ImageF& stored) {
    ImageF depth = stored;
    for (float& z : depth.pixels())
        if (!(z > 0) || !std::isfinite(z)) z = 0;
    return depth;
}

/// 1 where there is depth.
Image<std::uint8_t> hasDepth(const ImageF& depth) {
    Image<std::uint8_t> valid(depth.width(), depth.height());
    for (std::size_t i = 0; i < depth.size(); ++i) valid[i] = depth[i] > 0 ? 1 : 0;
    return valid;
}

/// Relative noise that the filter left, between neighbouring pixels, because that is what normals are fitted to.
float remainingNoise(const ImageF& filtered, const LabelImage& labels, const Progress& progress) {
    const ImageF w = inverseOf(filtered);
    return std::max(kMinRemainingNoise, relativeNoise(measureNoise(w, labels, 1, Differences::Fourth, progress), w));
}

/// Whether depth seems to be exact: it hardly bends from pixel to pixel, which rounded depth does at every step. A
/// guess for the progress only, before the noise is measured.
bool seemsExact(const ImageF& depth) {
    constexpr float kMaxBend = 1e-4f;
    constexpr std::size_t kSamples = 10000;
    std::vector<float> bends;
    const std::size_t stride = depth.size() / kSamples + 1;
    for (std::size_t i = 1; i + 1 < depth.size(); i += stride) {
        if (depth[i - 1] <= 0 || depth[i] <= 0 || depth[i + 1] <= 0) continue;
        bends.push_back(std::abs(depth[i] / depth[i - 1] - 2 + depth[i] / depth[i + 1]));
    }
    return !bends.empty() && quantile(bends, 0.8) < kMaxBend;
}

/// Share of the time that goes into measuring the noise. Exact depth needs little else.
float expectedMeasuringShare(const Photo& photo, const ImageF& depth) {
    return photo.depthSampleSpacing <= 1 && seemsExact(depth) ? 0.7f : 0.03f;
}

/// Which stages a photograph needs, and their expected times [ns on two cores]: progress follows them.
struct RecoveryPlan {
    bool removeFlying = false, filter = false, remeasure = false, smooth = false;
    double flyingTime = 0, filterTime = 0, noiseTime = 0, fillTime = 0, smoothTime = 0, distantTime = 0;

    [[nodiscard]] double time() const {
        return flyingTime + filterTime + noiseTime + fillTime + smoothTime + distantTime;
    }
};

RecoveryPlan planRecovery(const ImageF& depth, const Scene& scene, const DepthNoise& noise) {
    const Photo& photo = *scene.photo;
    const auto pixels = static_cast<double>(depth.size());
    RecoveryPlan plan;
    plan.removeFlying = scene.depthFilter.enabled && (noise.relative > 0 || photo.depthSampleSpacing > 1);
    plan.filter = scene.depthFilter.enabled && (noise.relative > 0 || !scene.depthFilter.automatic);
    plan.smooth = scene.depthFilter.enabled;
    if (plan.removeFlying) plan.flyingTime = 50 * pixels;
    if (plan.filter) plan.filterTime = 600 * pixels;
    plan.remeasure = plan.filter && noise.relative > 0;
    if (plan.remeasure) plan.noiseTime = 17 * pixels;
    plan.fillTime = expectedFillTime(depth, photo);
    if (plan.smooth) plan.smoothTime = expectedSmoothingTime(depth, photo.labels, chooseSmoothing(depth, scene, noise));
    plan.distantTime = 5 * pixels;
    return plan;
}

}  // namespace

RecoveredDepth recoverDepth(const Scene& scene, const StepContext& context) {
    const Photo& photo = *scene.photo;
    RecoveredDepth result;
    ImageF& depth = result.depth;
    depth = validDepth(photo.depth);
    if (std::ranges::none_of(depth.pixels(), [](float z) { return z > 0; })) {
        // A photograph without depth: all of it is distant.
        result.distant = findDistantPixels(depth);
        return result;
    }
    const float measuringShare = expectedMeasuringShare(photo, depth);
    const DepthNoise noise = estimateDepthNoise(inverseOf(depth), photo.labels, photo.depthSampleSpacing,
                                                context.progress.part(0, measuringShare));
    const RecoveryPlan plan = planRecovery(depth, scene, noise);
    StagedProgress stages(context.progress.part(measuringShare, 1), plan.time());
    if (plan.removeFlying)
        removeFlyingPixels(depth, photo.labels, photo.camera, photo.depthSampleSpacing, stages.next(plan.flyingTime));
    const Image<std::uint8_t> hadDepth = hasDepth(depth);
    if (plan.filter)
        depth = filterDepth(depth, photo, scene.depthFilter, noise, context.with(stages.next(plan.filterTime)));
    result.relativeNoise =
        plan.remeasure ? remainingNoise(depth, photo.labels, stages.next(plan.noiseTime)) : noise.relative;
    fillDepth(depth, photo, noise.relative <= 0, stages.next(plan.fillTime));
    if (plan.smooth) {
        const std::vector<SurfaceSmoothing> smoothing = chooseSmoothing(depth, scene, noise);
        smoothSurfaces(depth, hadDepth, photo.labels, photo.camera, smoothing, stages.next(plan.smoothTime));
        result.smoothing = bumpWidths(smoothing);
    }
    result.distant = findDistantPixels(depth);
    return result;
}

Step recoverDepthStep() {
    Step step;
    step.task = Task::RecoverDepth;
    step.reads = {Item::Photo};
    step.writes = Item::Depth;
    step.params = [](const Scene& scene, Hash& hash) {
        addParams(hash, Stage::Geometry, scene);
        for (const Segment& segment : scene.segments) addParams(hash.add(segment.label), Stage::Geometry, segment);
    };
    step.run = [](Board& board, const StepContext& context) {
        board.depth = std::make_shared<const RecoveredDepth>(recoverDepth(*board.scene, context));
    };
    return step;
}

}  // namespace core::analysis
