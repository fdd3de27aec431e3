// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/analysis/depth/plane_fit.h"
#include "core/analysis/depth/repair_normals.h"
#include "core/analysis/kernels.h"
#include "core/base/parallel.h"
#include "core/base/robust.h"
#include "shaders/shared/fit_surface_block.h"

namespace core::analysis {
namespace {

/// Slope at the last pixel before an occluding contour, from the steps to its first three neighbours inside. Near it a
/// smooth surface varies as sqrt(d), where d is the distance to the contour. The first two steps determine d: their
/// ratio is 0.41 at the contour and 1 far from it. The third must agree, otherwise there is no such contour.
std::optional<float> contourSlope(float first, float second, float third) {
    const float ratio = second / first;
    if (!(ratio > 0) || !(ratio < kernel::kMaxContourRatio)) return std::nullopt;
    float low = kernel::kMinContourDistance;
    float high = kernel::kMaxContourDistance;
    const auto step = [](float d) { return 1 / (std::sqrt(d + 1) + std::sqrt(d)); };  // sqrt(d+1) − sqrt(d)
    for (int i = 0; i < kernel::kContourBisections; ++i) {
        const float d = std::sqrt(low * high);
        (step(d + 1) < ratio * step(d) ? low : high) = d;
    }
    if (std::abs(third - first * step(low + 2) / step(low)) > kernel::kContourTolerance * std::abs(first))
        return std::nullopt;
    return first * 0.5f * (1 + std::sqrt(1 + 1 / low));
}

/// Fits the plane of one pixel. Plain arithmetic on arrays, the same on every device.
struct NormalFit {
    static constexpr int kMaxTaps = 25;

    const Camera& camera;
    const ImageF& depth;
    const LabelImage& labels;
    float relativeNoise;
    std::vector<NormalTap> taps;

    /// Inverse depth of a pixel of the segment, 0 if there is none.
    [[nodiscard]] float inverseDepth(int x, int y, std::uint16_t label) const {
        if (!depth.contains(x, y)) return 0;
        const std::size_t i = depth.index(x, y);
        const float z = depth[i];
        return z > 0 && labels[i] == label ? 1 / z : 0;
    }

    /// Slope along (dx, dy): from the side where inverse depth continues more linearly where the sides disagree, from
    /// both where they agree.
    [[nodiscard]] float guessSlope(int x, int y, int dx, int dy, std::uint16_t label, float w) const {
        const float before2 = inverseDepth(x - 2 * dx, y - 2 * dy, label);
        const float before = inverseDepth(x - dx, y - dy, label);
        const float after = inverseDepth(x + dx, y + dy, label);
        const float after2 = inverseDepth(x + 2 * dx, y + 2 * dy, label);
        if (before <= 0 && after <= 0) return 0;
        if (before <= 0) return after - w;
        if (after <= 0) return w - before;
        const float floor = w * (2 * relativeNoise + 1e-7f);
        const float errorBefore = floor + std::abs(before2 > 0 ? w - 2 * before + before2 : w - before);
        const float errorAfter = floor + std::abs(after2 > 0 ? w - 2 * after + after2 : w - after);
        if (errorBefore > kernel::kMaxSideRatio * errorAfter) return after - w;
        if (errorAfter > kernel::kMaxSideRatio * errorBefore) return w - before;
        return 0.5f * (after - before);
    }

    /// Slope along (dx, dy) where the segment, or what of it is in sight, ends beside the pixel; nothing elsewhere.
    [[nodiscard]] std::optional<float> slopeAtContour(int x, int y, int dx, int dy, std::uint16_t label,
                                                      float w) const {
        for (const int inside : {-1, 1}) {
            const float outer = inverseDepth(x - inside * dx, y - inside * dy, label);
            const float one = inverseDepth(x + inside * dx, y + inside * dy, label);
            const float two = inverseDepth(x + 2 * inside * dx, y + 2 * inside * dy, label);
            const float three = inverseDepth(x + 3 * inside * dx, y + 3 * inside * dy, label);
            if (one <= 0 || two <= 0 || three <= 0 || one <= w) continue;
            if (outer > 0 && std::abs(w - outer) < kernel::kContourJump * (one - w)) continue;
            const auto slope = contourSlope(one - w, two - one, three - two);
            if (slope) return static_cast<float>(inside) * *slope;
        }
        return std::nullopt;
    }

    /// Normal of the fitted plane towards +z, not normalised: N with N·P = 1 on the plane.
    [[nodiscard]] Vector3f fit(int x, int y) const {
        const std::uint16_t label = labels(x, y);
        const float w = 1 / depth(x, y);
        float offset = 0;
        float gu = guessSlope(x, y, 1, 0, label, w);
        float gv = guessSlope(x, y, 0, 1, label, w);
        float difference[kMaxTaps];
        for (std::size_t i = 0; i < taps.size(); ++i) {
            const float value = inverseDepth(x + taps[i].dx, y + taps[i].dy, label);
            difference[i] = value > 0 ? value - w : kernel::kNothing;
        }
        const float inverseW = 1 / w;
        for (int iteration = 0; iteration < 2; ++iteration) {
            PlaneMoments<float> moments;
            for (std::size_t i = 0; i < taps.size(); ++i) {
                const auto u = static_cast<float>(taps[i].dx);
                const auto v = static_cast<float>(taps[i].dy);
                const float residual = (difference[i] - (offset + gu * u + gv * v)) * inverseW * taps[i].inverseLimit;
                moments.add(u, v, difference[i], biweight(residual * residual) * taps[i].weight);
            }
            // A line of pixels does not determine the slope across it, which keeps the guess.
            const auto plane = moments.solve(kernel::kSlopeStiffness, gu, gv);
            if (!plane) break;
            gu = plane->slopeU;
            gv = plane->slopeV;
            offset = std::clamp(plane->value, -0.5f * w, w);
        }
        if (relativeNoise <= 0) {
            const auto su = slopeAtContour(x, y, 1, 0, label, w);
            const auto sv = slopeAtContour(x, y, 0, 1, label, w);
            if (su || sv) offset = 0;
            gu = su.value_or(gu);
            gv = sv.value_or(gv);
        }
        const float u = static_cast<float>(x) + 0.5f - camera.cx;
        const float v = static_cast<float>(y) + 0.5f - camera.cy;
        return {gu * camera.fx, gv * camera.fy, w + offset - gu * u - gv * v};
    }
};

}  // namespace

std::vector<NormalTap> normalTaps(const Camera& camera, float relativeNoise) {
    // Detail of exact depth is real; in measured depth it is noise that the filter left.
    const int radius = relativeNoise > 0 ? 2 : 1;
    const float footprint = 1 / std::min(camera.fx, camera.fy);
    constexpr float kLimit = 1.54f;  // biweight that is close to exp(−r²)
    std::vector<NormalTap> taps;
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            const auto squared = static_cast<float>(dx * dx + dy * dy);
            const float tolerance = 3 * relativeNoise + footprint * std::sqrt(squared) + 1e-7f;
            taps.push_back(
                {dx, dy, std::exp(-squared / static_cast<float>(2 * radius * radius)), 1 / (kLimit * tolerance)});
        }
    }
    return taps;
}

float patchArea(const Camera& camera, const Vector3f& position, const Vector3f& normal) {
    const float z = position.z();
    const float cosine = std::max(std::abs(normal.dot(position)), kernel::kMinViewCosine * position.norm());
    return cosine > 0 ? z * z * z / (camera.fx * camera.fy * cosine) : 0.0f;
}

void computeSurface(const SurfaceInput& input, Surface& surface, const Progress& progress) {
    const int width = surface.depth.width();
    const int height = surface.depth.height();
    surface.normal = ImageV3(width, height, Vector3f::Zero());
    surface.position = ImageV3(width, height, Vector3f::Zero());
    surface.area = ImageF(width, height, 0.0f);
    const NormalFit fit{input.camera, surface.depth, input.labels, input.relativeNoise,
                        normalTaps(input.camera, input.relativeNoise)};
    const float sign = input.side == Side::Front ? -1.0f : 1.0f;
    const auto computeRow = [&](int y) {
        for (int x = 0; x < width; ++x) {
            if (!(surface.depth(x, y) > 0)) continue;
            const bool known = input.known != nullptr && !(*input.known)(x, y).isZero(0);
            const Vector3f normal = known ? (*input.known)(x, y) : Vector3f(sign * fit.fit(x, y).normalized());
            const Vector3f position = input.camera.backProject(x, y, surface.depth(x, y));
            surface.normal(x, y) = normal;
            surface.position(x, y) = position;
            surface.area(x, y) = patchArea(input.camera, position, normal);
        }
    };
    parallelFor(progress, height, computeRow);
}

Step computeNormalsStep() {
    Step step;
    step.task = Task::ComputeNormals;
    step.reads = {Item::Photo, Item::Depth};
    step.writes = Item::Front;
    step.params = [](const Scene&, Hash&) {};
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        const float noise = board.depth->relativeNoise;
        auto surface = std::make_shared<Surface>();
        surface->depth = board.depth->depth;
        surface->color = photo.color;
        const float fitted = noise > 0 ? 0.45f : 1.0f;
        context.kernels.computeSurface({photo.camera, photo.labels, Side::Front, noise}, *surface,
                                       context.progress.part(0, fitted));
        if (noise > 0)
            repairNormals(*surface, photo.labels, photo.camera, photo.depthSampleSpacing,
                          context.progress.part(fitted, 1));
        board.front = std::move(surface);
    };
    return step;
}

}  // namespace core::analysis
