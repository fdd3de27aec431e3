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

namespace core::analysis {
namespace {

/// Relative noise below which filtered depth is not taken to be: it is never exact, however smooth.
constexpr float kMinRemainingNoise = 2e-6f;

/// The photograph's depth, 0 wherever it is not a positive number.
ImageF validDepth(const ImageF& stored) {
    ImageF depth = stored;
    for (float& z : depth.pixels())
        if (!(z > 0) || !std::isfinite(z)) z = 0;
    if (std::ranges::none_of(depth.pixels(), [](float z) { return z > 0; }))
        throw Error(ErrorKind::Input,
                    Message("messages",
                            "The depth map has no valid pixel: all of its %1 values are zero or not finite, but at "
                            "least one positive depth is needed. Load a depth map that belongs to the photograph, or "
                            "check its unit and kind.")
                        .with(depth.size()));
    return depth;
}

/// 1 where there is depth.
Image<std::uint8_t> hasDepth(const ImageF& depth) {
    Image<std::uint8_t> valid(depth.width(), depth.height());
    for (std::size_t i = 0; i < depth.size(); ++i) valid[i] = depth[i] > 0 ? 1 : 0;
    return valid;
}

/// Relative noise that the filter left.
float remainingNoise(const ImageF& filtered, const LabelImage& labels, const Progress& progress) {
    const ImageF w = inverseOf(filtered);
    return std::max(kMinRemainingNoise, relativeNoise(measureNoise(w, labels, 1, Differences::Fourth, progress), w));
}

}  // namespace

RecoveredDepth recoverDepth(const Scene& scene, const StepContext& context) {
    const Photo& photo = *scene.photo;
    const Progress& progress = context.progress;
    const bool filtered = scene.depthFilter.enabled;
    RecoveredDepth result;
    result.depth = validDepth(photo.depth);
    const DepthNoise noise =
        estimateDepthNoise(inverseOf(result.depth), photo.labels, photo.depthSampleSpacing, progress);
    result.relativeNoise = noise.relative;
    if (filtered && (noise.relative > 0 || photo.depthSampleSpacing > 1))
        removeFlyingPixels(result.depth, photo.labels, photo.camera, photo.depthSampleSpacing, progress);
    const Image<std::uint8_t> measured = hasDepth(result.depth);
    if (filtered) result.depth = filterDepth(result.depth, photo, scene.depthFilter, noise, context);
    if (filtered && noise.relative > 0) result.relativeNoise = remainingNoise(result.depth, photo.labels, progress);
    fillDepth(result.depth, photo, filtered ? scene.depthFilter.holeRadius : 0, progress);
    if (filtered) {
        const std::vector<SurfaceSmoothing> smoothing = chooseSmoothing(result.depth, scene, noise);
        smoothSurfaces(result.depth, measured, photo.labels, photo.camera, smoothing, progress);
        for (const SurfaceSmoothing& segment : smoothing) result.smoothing[segment.label] = segment.bumpWidth();
    }
    result.distant = findDistantPixels(result.depth);
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
