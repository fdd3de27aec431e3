// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace core {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Largest slope that two one-sided differences support: the larger of the two, but not far more than the smaller,
/// which is the one that does not cross a discontinuity. `floor` is a slope that is always allowed.
float slopeLimit(std::optional<float> left, std::optional<float> right, float floor) {
    if (!left && !right) return floor;
    if (!left || !right) return 1.5f * std::abs(left ? *left : *right) + floor;
    const float a = std::abs(*left);
    const float b = std::abs(*right);
    return std::min(std::max(a, b), 3 * std::min(a, b)) + floor;
}

/// value + slope·s.
struct Linear {
    double value, slope;
    [[nodiscard]] double at(double s) const { return value + slope * s; }

    /// Cuts [a, b] to where this is ≥ 0, given that only s in [s0, s1] matters; a > b when it is nowhere. True when
    /// that moved the beginning.
    bool clip(double s0, double s1, double& a, double& b) const {
        const double first = at(s0);
        if (slope >= 0 && first >= 0) return false;
        if (slope < 0) {
            if (first < 0) {
                b = -kInfinity;
            } else if (s1 == kInfinity || at(s1) < 0) {
                b = std::min(b, -value / slope);
            }
            return false;
        }
        if (slope == 0 || (s1 != kInfinity && at(s1) < 0)) {
            b = -kInfinity;
            return false;
        }
        const double root = -value / slope;
        if (root <= a) return false;
        a = root;
        return true;
    }
};

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
        const float limitU = slopeLimit(difference(x - 1, y, -1), difference(x + 1, y, 1), w / camera.fx);
        const float limitV = slopeLimit(difference(x, y - 1, -1), difference(x, y + 1, 1), w / camera.fy);
        result.gu = std::clamp(result.gu, -limitU, limitU);
        result.gv = std::clamp(result.gv, -limitV, limitV);
        keepPositive(result);
        return result;
    }

    /// Flattens a patch that would reach w ≤ 0, infinity, inside its pixel.
    static void keepPositive(DepthLayers::Patch& patch) {
        const float drop = 0.5f * (std::abs(patch.gu) + std::abs(patch.gv));
        const float allowed = 0.9f * patch.w;
        if (drop <= allowed) return;
        patch.gu *= allowed / drop;
        patch.gv *= allowed / drop;
    }
};

}  // namespace

DepthLayers buildDepthLayers(const Camera& camera, const LabelImage& labels, const Surface& front,
                             const Surface& back) {
    CORE_ASSERT(front.depth.sameSize(labels) && back.depth.sameSize(labels), "layers of one size");
    DepthLayers layers;
    layers.camera = camera;
    layers.labels = labels;
    layers.front = Image<DepthLayers::Patch>(labels.width(), labels.height());
    layers.back = Image<DepthLayers::Patch>(labels.width(), labels.height());
    const LayerBuilder builder{camera, labels};
    layers.minW = std::numeric_limits<float>::infinity();
    layers.maxW = 0;
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            DepthLayers::Patch near = builder.patch(front, x, y);
            if (near.w <= 0) continue;
            DepthLayers::Patch far = builder.patch(back, x, y);
            if (far.w <= 0) far = near;
            far.w = std::min(far.w, near.w);
            // Both planes are linear, so they do not cross inside the pixel when they do not at its corners.
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
            // The float sums of the march may round a corner outwards.
            const float above = near.w + 0.5f * (std::abs(near.gu) + std::abs(near.gv));
            const float below = far.w - 0.5f * (std::abs(far.gu) + std::abs(far.gv));
            layers.maxW = std::max(layers.maxW, above * (1 + 1e-5f));
            layers.minW = std::min(layers.minW, below * (1 - 1e-5f));
        }
    }
    return layers;
}

float marchBias(const Camera& camera, float z) { return z / (camera.fx + camera.fy); }

std::optional<MarchHit> march(const DepthLayers& layers, const Vector3f& origin, const Vector3f& direction) {
    const Camera& camera = layers.camera;
    const int width = layers.front.width();
    const int height = layers.front.height();
    const Eigen::Vector3d p = origin.cast<double>();
    const Eigen::Vector3d d = direction.cast<double>();
    if (!(p.z() > 0)) return std::nullopt;

    const double u0 = camera.fx * p.x() / p.z() + camera.cx;
    const double v0 = camera.fy * p.y() / p.z() + camera.cy;
    const double w0 = 1 / p.z();
    const double slopeU = camera.fx * (d.x() - d.z() * p.x() / p.z());
    const double slopeV = camera.fy * (d.y() - d.z() * p.y() / p.z());
    const double slopeW = -d.z() / p.z();
    double end = d.z() > 0 ? 1 / d.z() : kInfinity;
    double begin = 0;
    const auto clip = [&](double start, double slope, double size) {
        if (slope == 0) {
            if (!(start >= 0 && start < size)) end = -1;
            return;
        }
        const double a = -start / slope;
        const double b = (size - start) / slope;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    };
    if (slopeW > 0) end = std::min(end, (layers.maxW - w0) / slopeW);
    if (slopeW < 0) end = std::min(end, (layers.minW - w0) / slopeW);
    clip(u0, slopeU, width);
    clip(v0, slopeV, height);
    if (!(begin <= end)) return std::nullopt;

    int x = std::clamp(static_cast<int>(std::floor(u0 + slopeU * begin)), 0, width - 1);
    int y = std::clamp(static_cast<int>(std::floor(v0 + slopeV * begin)), 0, height - 1);
    const int stepX = slopeU > 0 ? 1 : -1;
    const int stepY = slopeV > 0 ? 1 : -1;
    const double inverseU = slopeU != 0 ? 1 / slopeU : 0;
    const double inverseV = slopeV != 0 ? 1 / slopeV : 0;

    bool escaping = begin <= 0;
    double s0 = begin;
    while (true) {
        const double nextU = slopeU != 0 ? ((slopeU > 0 ? x + 1 : x) - u0) * inverseU : kInfinity;
        const double nextV = slopeV != 0 ? ((slopeV > 0 ? y + 1 : y) - v0) * inverseV : kInfinity;
        const double s1 = std::max(s0, std::min({nextU, nextV, end}));

        const DepthLayers::Patch& front = layers.front(x, y);
        bool leavesInside = false;
        if (front.w > 0) {
            const DepthLayers::Patch& back = layers.back(x, y);
            const double du = u0 - (x + 0.5);
            const double dv = v0 - (y + 0.5);
            // Room below the front and above the back plane: linear in s, the solid is where both are ≥ 0.
            const Linear room{front.w + front.gu * du + front.gv * dv - w0,
                              front.gu * slopeU + front.gv * slopeV - slopeW};
            const Linear depth{w0 - (back.w + back.gu * du + back.gv * dv),
                               slopeW - (back.gu * slopeU + back.gv * slopeV)};
            double a = s0;
            double b = s1;
            const bool throughFront = room.clip(s0, s1, a, b);
            const bool throughBack = depth.clip(s0, s1, a, b);
            if (a <= b) {
                if (!escaping || a > s0) {
                    const bool sideWall = !throughFront && !throughBack;
                    const bool isBack = sideWall ? room.at(a) > depth.at(a) : throughBack;
                    return MarchHit{x, y, isBack, static_cast<float>(a / (w0 + slopeW * a))};
                }
                leavesInside = b >= s1;
            }
        }
        escaping = escaping && leavesInside;

        if (s1 >= end || s1 == kInfinity) return std::nullopt;
        if (nextU <= nextV) x += stepX;
        if (nextV <= nextU) y += stepY;
        if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
        s0 = s1;
    }
}

}  // namespace core
