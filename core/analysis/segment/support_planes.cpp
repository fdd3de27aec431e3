// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/segment/support_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <span>

#include "core/analysis/segment/principal_axes.h"

namespace core::analysis {
namespace {

constexpr int kOutlineReach = 12;  ///< [px] from the outline, in steps of `kReachStep`
constexpr int kReachStep = 3;
constexpr float kInlierWidths = 3;  ///< pixel widths off the plane
constexpr double kMinInliers = 0.5;
constexpr double kMaxBeyond = 0.1;  ///< part of the segment that may lie beyond its support
constexpr int kTrials = 60;
constexpr std::size_t kMinPoints = 12;

std::vector<Vector3f> supportPointsAround(const SegmentPixels& segment) {
    std::vector<Vector3f> points;
    for (const Pixel& pixel : segment.pixels) {
        for (const Pixel& step : kNeighbors) {
            if (segment.contains(pixel.x + step.x, pixel.y + step.y)) continue;
            for (int k = 1; k <= kOutlineReach; k += kReachStep) {
                const int x = pixel.x + k * step.x;
                const int y = pixel.y + k * step.y;
                if (!segment.labels.contains(x, y) || !segment.supports[segment.labels(x, y)]) continue;
                if (segment.front.depth(x, y) > 0) points.push_back(segment.front.position(x, y));
            }
        }
    }
    return points;
}

}  // namespace

std::vector<bool> findSupports(const LabelImage& labels) {
    struct Outline {
        std::size_t length = 0;
        std::array<std::size_t, 4> sides{};
    };
    std::vector<Outline> outlines(65536);
    const int width = labels.width();
    const int height = labels.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t label = labels(x, y);
            if (label == 0) continue;
            const std::array<bool, 4> border{x == 0, x == width - 1, y == 0, y == height - 1};
            const std::array<std::array<int, 2>, 4> neighbors{{{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}};
            for (std::size_t k = 0; k < 4; ++k) {
                if (border[k]) ++outlines[label].sides[k];
                if (border[k] || labels(neighbors[k][0], neighbors[k][1]) != label) ++outlines[label].length;
            }
        }
    }
    std::vector<bool> supports(outlines.size(), false);
    for (std::size_t label = 1; label < outlines.size(); ++label) {
        const auto& [length, sides] = outlines[label];
        const std::size_t touching = sides[0] + sides[1] + sides[2] + sides[3];
        const bool opposite = (sides[0] > 0 && sides[1] > 0) || (sides[2] > 0 && sides[3] > 0);
        supports[label] = touching > 0 && (touching * 5 >= length * 2 || (opposite && touching * 10 >= length));
    }
    return supports;
}

std::optional<SupportPlane> fitPlane(std::span<const Vector3f> points, float pixelWidth) {
    if (points.size() < kMinPoints) return std::nullopt;
    const auto distance = [](const SupportPlane& plane, const Vector3f& p) {
        return std::abs(plane.normal.dot(p) - plane.offset);
    };
    const auto isInlier = [&](const SupportPlane& plane, const Vector3f& p) {
        return distance(plane, p) < kInlierWidths * pixelWidth * p.z();
    };

    std::mt19937 random(1);
    SupportPlane best;
    std::size_t bestCount = 0;
    const std::size_t stride = points.size() / 2000 + 1;
    for (int trial = 0; trial < kTrials; ++trial) {
        const Vector3f& a = points[random() % points.size()];
        const Vector3f& b = points[random() % points.size()];
        const Vector3f& c = points[random() % points.size()];
        const Vector3f cross = (b - a).cross(c - a);
        if (!(cross.norm() > 1e-3f * (b - a).norm() * (c - a).norm())) continue;
        const SupportPlane plane{cross.normalized(), cross.normalized().dot(a)};
        std::size_t count = 0;
        for (std::size_t i = 0; i < points.size(); i += stride) count += isInlier(plane, points[i]) ? 1 : 0;
        if (count > bestCount) {
            bestCount = count;
            best = plane;
        }
    }
    std::vector<Vector3f> inliers;
    std::ranges::copy_if(points, std::back_inserter(inliers), [&](const Vector3f& p) { return isInlier(best, p); });
    if (inliers.size() < kMinPoints ||
        static_cast<double>(inliers.size()) < kMinInliers * static_cast<double>(points.size()))
        return std::nullopt;

    const auto axes = principalAxes(inliers);
    if (!axes) return std::nullopt;
    const Eigen::Vector3d normal = axes->eigenvectors.col(0);
    SupportPlane plane{normal.cast<float>(), static_cast<float>(normal.dot(axes->mean))};
    if (plane.offset < 0) plane = {-plane.normal, -plane.offset};
    return plane;
}

std::optional<SupportPlane> fitSupportPlane(const SegmentPixels& segment) {
    const auto plane = fitPlane(supportPointsAround(segment), segment.footprint(1));
    if (!plane) return std::nullopt;
    const auto beyondCount = std::ranges::count_if(segment.pixels, [&](const Pixel& pixel) {
        const Vector3f& p = segment.front.position(pixel.x, pixel.y);
        return plane->normal.dot(p) > plane->offset + kInlierWidths * segment.footprint(p.z());
    });
    if (static_cast<double>(beyondCount) > kMaxBeyond * static_cast<double>(segment.pixels.size())) return std::nullopt;
    return plane;
}

}  // namespace core::analysis
