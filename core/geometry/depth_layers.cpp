// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/depth_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.h"

namespace core {
namespace {

/// Limits a slope by the differences to the neighbours on either side (van Leer's limiter): 0 at ridges and in valleys,
/// otherwise at most twice the smaller difference, which is also the one that crosses no discontinuity. A steeper patch
/// would stand above its neighbour like a saw tooth and catch rays that start beside it. `floor` is the limit without
/// neighbours.
float limitedSlope(float slope, std::optional<float> left, std::optional<float> right, float floor) {
    if (left && right) {
        if (*left * *right <= 0) return 0;
        const float largest = 2 * std::min(std::abs(*left), std::abs(*right));
        return *left > 0 ? std::clamp(slope, 0.0f, largest) : std::clamp(slope, -largest, 0.0f);
    }
    const float largest = floor + (left || right ? 1.5f * std::abs(left ? *left : *right) : 0.0f);
    return std::clamp(slope, -largest, largest);
}

struct LayerBuilder {
    const Camera& camera;
    const LabelImage& labels;

    [[nodiscard]] DepthLayers::Patch patch(const Surface& surface, int x, int y) const {
        const float z = surface.depth(x, y);
        if (z <= 0) return {};
        const float w = 1 / z;
        const auto difference = [&](int nx, int ny, float sign) -> std::optional<float> {
            if (!labels.contains(nx, ny) || labels(nx, ny) != labels(x, y) || surface.depth(nx, ny) <= 0)
                return std::nullopt;
            return sign * (1 / surface.depth(nx, ny) - w);
        };
        // Plane n·p = c: w = n·ray(u, v)/c.
        const Vector3f& n = surface.normal(x, y);
        const float c = n.dot(camera.backProject(x, y, z));
        DepthLayers::Patch result{w, 0, 0};
        if (std::abs(c) > 1e-6f * z) {
            result.gu = n.x() / (camera.fx * c);
            result.gv = n.y() / (camera.fy * c);
        }
        result.gu = limitedSlope(result.gu, difference(x - 1, y, -1), difference(x + 1, y, 1), w / camera.fx);
        result.gv = limitedSlope(result.gv, difference(x, y - 1, -1), difference(x, y + 1, 1), w / camera.fy);
        keepPositive(result);
        return result;
    }

    /// Flattens a patch that would reach w ≤ 0 (infinity) inside its pixel.
    static void keepPositive(DepthLayers::Patch& patch) {
        const float drop = 0.5f * (std::abs(patch.gu) + std::abs(patch.gv));
        const float allowed = 0.9f * patch.w;
        if (drop <= allowed) return;
        patch.gu *= allowed / drop;
        patch.gv *= allowed / drop;
    }
};

}  // namespace

DepthLayers buildDepthLayers(const Camera& camera, const LabelImage& labels, const Surface& front, const Surface& back,
                             const Progress& progress) {
    constexpr float kAllocating = 0.2f;  // share of the time
    CORE_ASSERT(front.depth.sameSize(labels) && back.depth.sameSize(labels), "layers of one size");
    DepthLayers layers;
    layers.camera = camera;
    layers.labels = labels;
    layers.front = Image<DepthLayers::Patch>(labels.width(), labels.height());
    layers.back = Image<DepthLayers::Patch>(labels.width(), labels.height());
    const LayerBuilder builder{camera, labels};
    struct Range {
        float min = std::numeric_limits<float>::infinity(), max = 0;
    };
    std::vector<Range> rows(static_cast<std::size_t>(labels.height()));
    parallelFor(progress.part(kAllocating, 1), labels.height(), [&](int y) {
        Range& row = rows[static_cast<std::size_t>(y)];
        for (int x = 0; x < labels.width(); ++x) {
            DepthLayers::Patch near = builder.patch(front, x, y);
            if (near.w <= 0) continue;
            DepthLayers::Patch far = builder.patch(back, x, y);
            if (far.w <= 0) far = near;
            far.w = std::min(far.w, near.w);
            // Planes that do not cross at the corners of the pixel do not cross inside it.
            const float gap = near.w - far.w;
            const float tilt = 0.5f * (std::abs(near.gu - far.gu) + std::abs(near.gv - far.gv));
            if (tilt > gap) {
                far.gu = near.gu;
                far.gv = near.gv;
                const float drop = 0.5f * (std::abs(far.gu) + std::abs(far.gv));
                const float allowed = 0.9f * far.w;
                if (drop > allowed) {
                    near.gu = far.gu *= allowed / drop;
                    near.gv = far.gv *= allowed / drop;
                }
            }
            layers.front(x, y) = near;
            layers.back(x, y) = far;
            // The marching kernel may round a corner outwards.
            const float above = near.w + 0.5f * (std::abs(near.gu) + std::abs(near.gv));
            const float below = far.w - 0.5f * (std::abs(far.gu) + std::abs(far.gv));
            row.max = std::max(row.max, above * (1 + 1e-5f));
            row.min = std::min(row.min, below * (1 - 1e-5f));
        }
    });
    layers.minW = std::ranges::min(rows, {}, &Range::min).min;
    layers.maxW = std::ranges::max(rows, {}, &Range::max).max;
    return layers;
}

float marchBias(const Camera& camera, float z) { return z / (camera.fx + camera.fy); }

}  // namespace core
