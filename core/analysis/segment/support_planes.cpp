// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/segment/support_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <span>

#include "core/analysis/segment/principal_axes.h"
#include "core/base/label_table.h"
#include "core/base/pixel.h"

namespace core::analysis {
namespace {

/// Largest distance [px] from the outline at which points of the support are taken, and their spacing.
constexpr int kOutlineReach = 12;
constexpr int kReachStep = 3;
/// Largest distance of an inlier from the plane [pixel widths].
constexpr float kInlierWidths = 3;
constexpr double kMinInlierFraction = 0.5;
/// Largest fraction of a segment that may lie beyond the support it stands on.
constexpr double kMaxBeyond = 0.1;
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
    /// Sides of pixels along the outline of a segment.
    struct Outline {
        std::size_t length = 0;
        std::array<std::size_t, 4> atBorder{};  ///< left, right, top, bottom
    };
    LabelTable<Outline> outlines;
    const int width = labels.width();
    const int height = labels.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t label = labels(x, y);
            if (label == 0) continue;
            const std::array<bool, 4> border{x == 0, x == width - 1, y == 0, y == height - 1};
            for (std::size_t k = 0; k < 4; ++k) {
                if (border[k]) ++outlines[label].atBorder[k];
                if (border[k] || labels(x + kNeighbors[k].x, y + kNeighbors[k].y) != label) ++outlines[label].length;
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

namespace {

bool isInlier(const SupportPlane& plane, const Vector3f& p, float pixelWidth) {
    return std::abs(plane.normal.dot(p) - plane.offset) < kInlierWidths * pixelWidth * p.z();
}

/// The plane through three of the points with the most inliers among a subset.
SupportPlane bestOfTrials(std::span<const Vector3f> points, float pixelWidth) {
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
        for (std::size_t i = 0; i < points.size(); i += stride) count += isInlier(plane, points[i], pixelWidth) ? 1 : 0;
        if (count > bestCount) {
            bestCount = count;
            best = plane;
        }
    }
    return best;
}

}  // namespace

std::optional<SupportPlane> fitPlane(std::span<const Vector3f> points, float pixelWidth) {
    if (points.size() < kMinPoints) return std::nullopt;
    const SupportPlane best = bestOfTrials(points, pixelWidth);
    std::vector<Vector3f> inliers;
    std::ranges::copy_if(points, std::back_inserter(inliers),
                         [&](const Vector3f& p) { return isInlier(best, p, pixelWidth); });
    if (inliers.size() < kMinPoints ||
        static_cast<double>(inliers.size()) < kMinInlierFraction * static_cast<double>(points.size()))
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
