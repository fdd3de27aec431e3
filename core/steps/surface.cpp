// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace core::steps {
namespace {

constexpr const char* kName = "Surface";
constexpr float kMinCosine = 0.02f;
constexpr float kNothing = 1e9f;  ///< inverse depth [1/m] that is on no plane

/// Fit of one pixel's plane. Plain arithmetic on arrays, the same on every device.
struct NormalFit {
    static constexpr int kMaxTaps = 25;
    struct Tap {
        int dx, dy;          ///< [px]
        float weight;        ///< by distance
        float inverseLimit;  ///< 1 / residual relative to the centre that no longer counts
    };

    const Camera& camera;
    const ImageF& depth;
    const LabelImage& labels;
    float relativeNoise;
    int radius = 1;  ///< of the window [px]
    int tapCount = 0;
    Tap taps[kMaxTaps];

    NormalFit(const Camera& c, const ImageF& z, const LabelImage& l, float noise)
        : camera(c), depth(z), labels(l), relativeNoise(noise) {
        // Detail of exact depth is true; of what was measured it is what the filter left of the noise.
        if (relativeNoise > 0) radius = 2;
        const float footprint = 1 / std::min(camera.fx, camera.fy);
        constexpr float kLimit = 1.54f;  // biweight that is close to exp(−r²)
        for (int dy = -radius; dy <= radius; ++dy) {
            for (int dx = -radius; dx <= radius; ++dx) {
                const auto squared = static_cast<float>(dx * dx + dy * dy);
                const float tolerance = 3 * relativeNoise + footprint * std::sqrt(squared) + 1e-7f;
                taps[tapCount++] = {dx, dy, std::exp(-squared / static_cast<float>(2 * radius * radius)),
                                    1 / (kLimit * tolerance)};
            }
        }
    }

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
        if (errorBefore > 6 * errorAfter) return after - w;
        if (errorAfter > 6 * errorBefore) return w - before;
        return 0.5f * (after - before);
    }

    /// Normal of the fitted plane towards +z, not normalised: N with N·P = 1 on the plane.
    [[nodiscard]] Vector3f fit(int x, int y) const {
        const std::uint16_t label = labels(x, y);
        const float w = 1 / depth(x, y);
        float offset = 0;
        float gu = guessSlope(x, y, 1, 0, label, w);
        float gv = guessSlope(x, y, 0, 1, label, w);
        float difference[kMaxTaps];
        for (int i = 0; i < tapCount; ++i) {
            const float value = inverseDepth(x + taps[i].dx, y + taps[i].dy, label);
            difference[i] = value > 0 ? value - w : kNothing;
        }
        const float inverseW = 1 / w;
        for (int iteration = 0; iteration < 2; ++iteration) {
            float s = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0, sw = 0, suw = 0, svw = 0;
            for (int i = 0; i < tapCount; ++i) {
                const auto u = static_cast<float>(taps[i].dx);
                const auto v = static_cast<float>(taps[i].dy);
                const float residual = (difference[i] - (offset + gu * u + gv * v)) * inverseW * taps[i].inverseLimit;
                const float t = std::max(1 - residual * residual, 0.0f);
                const float k = t * t * taps[i].weight;
                const float ku = k * u;
                const float kv = k * v;
                s += k;
                su += ku;
                sv += kv;
                suu += ku * u;
                suv += ku * v;
                svv += kv * v;
                sw += k * difference[i];
                suw += ku * difference[i];
                svw += kv * difference[i];
            }
            if (s <= 0) break;
            // About the mean; a thin line of pixels says nothing about the slope across it: keep the guess there.
            const float regularization = 1e-4f * s;
            const float cuu = suu - su * su / s + regularization;
            const float cuv = suv - su * sv / s;
            const float cvv = svv - sv * sv / s + regularization;
            const float cuw = suw - su * sw / s + regularization * gu;
            const float cvw = svw - sv * sw / s + regularization * gv;
            const float determinant = cuu * cvv - cuv * cuv;
            if (!(determinant > 0)) break;
            gu = (cvv * cuw - cuv * cvw) / determinant;
            gv = (cuu * cvw - cuv * cuw) / determinant;
            offset = std::clamp((sw - gu * su - gv * sv) / s, -0.5f * w, w);
        }
        const float u = static_cast<float>(x) + 0.5f - camera.cx;
        const float v = static_cast<float>(y) + 0.5f - camera.cy;
        return {gu * camera.fx, gv * camera.fy, w + offset - gu * u - gv * v};
    }
};

}  // namespace

ImageV3 computeNormals(const Camera& camera, const ImageF& depth, const LabelImage& labels, Side side,
                       float relativeNoise, const char* stepName, const StepContext& context, float from, float to) {
    ImageV3 normals(depth.width(), depth.height(), Vector3f::Zero());
    const NormalFit fit(camera, depth, labels, relativeNoise);
    const float sign = side == Side::Front ? -1.0f : 1.0f;
    parallelFor(
        context, stepName, depth.height(),
        [&](int y) {
            for (int x = 0; x < depth.width(); ++x)
                if (depth(x, y) > 0) normals(x, y) = sign * fit.fit(x, y).normalized();
        },
        from, to);
    return normals;
}

float patchArea(const Camera& camera, const Vector3f& position, const Vector3f& normal) {
    const float z = position.z();
    const float cosine = std::max(std::abs(normal.dot(position)), kMinCosine * position.norm());
    return cosine > 0 ? z * z * z / (camera.fx * camera.fy * cosine) : 0.0f;
}

void completeSurface(const Camera& camera, Surface& surface) {
    const int width = surface.depth.width();
    const int height = surface.depth.height();
    surface.position = ImageV3(width, height, Vector3f::Zero());
    surface.area = ImageF(width, height, 0.0f);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (surface.depth(x, y) <= 0) continue;
            surface.position(x, y) = camera.backProject(x, y, surface.depth(x, y));
            surface.area(x, y) = patchArea(camera, surface.position(x, y), surface.normal(x, y));
        }
    }
}

Step surfaceStep() {
    Step step;
    step.name = kName;
    step.reads = {Item::Photo, Item::Depth};
    step.writes = Item::Front;
    step.params = [](const Scene&, Hash&) {};
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        auto surface = std::make_shared<Surface>();
        surface->depth = board.depth->depth;
        surface->color = photo.color;
        surface->normal = computeNormals(photo.camera, surface->depth, photo.labels, Side::Front,
                                         board.depth->relativeNoise, kName, context);
        completeSurface(photo.camera, *surface);
        board.front = std::move(surface);
    };
    return step;
}

}  // namespace core::steps
