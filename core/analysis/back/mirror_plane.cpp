// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/mirror_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/segment/principal_axes.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Quantile of the outline's depth at which a parallel mirror plane lies.
constexpr double kOutlineQuantile = 0.8;
/// Maximum number of points about (within a factor of two) that a plane is tested with.
constexpr std::size_t kMaxTestedPoints = 20000;
/// Bisections of the plane's offset.
constexpr int kBisections = 24;

/// True if the mirror image of a point projects into the segment's silhouette or behind a nearer object.
bool staysInside(const SegmentPixels& segment, const Vector3f& point, const Vector3f& mirrored) {
    if (!(mirrored.z() > 0)) return false;
    const Vector2f uv = segment.camera.project(mirrored);
    const auto x = static_cast<int>(std::floor(std::clamp(uv.x(), -1.0f, 1e6f)));
    const auto y = static_cast<int>(std::floor(std::clamp(uv.y(), -1.0f, 1e6f)));
    if (!segment.labels.contains(x, y)) return false;
    const std::uint16_t there = segment.labels(x, y);
    const float z = segment.front.depth(x, y);
    return there == segment.label || (there != 0 && !segment.supports[there] && z > 0 && z < point.z());
}

}  // namespace

std::optional<Vector3f> mirrorAxis(std::span<const Vector3f> points) {
    if (points.size() < 3) return std::nullopt;
    const auto axes = principalAxes(points);
    // On a line the two smaller eigenvalues vanish and their axes are arbitrary.
    if (!axes || axes->eigenvalues[1] <= 1e-9 * axes->eigenvalues[2]) return std::nullopt;
    Eigen::Index best = 0;
    axes->eigenvectors.row(2).cwiseAbs().maxCoeff(&best);
    const Eigen::Vector3d axis = axes->eigenvectors.col(best);
    return (axis.z() < 0 ? -axis : axis).cast<float>();
}

MirrorErrors mirrorErrors(const SegmentPixels& segment, const MirrorPlane& plane) {
    const std::size_t stride = segment.pixels.size() / kMaxTestedPoints + 1;
    std::size_t count = 0, behind = 0, outside = 0;
    for (std::size_t i = 0; i < segment.pixels.size(); i += stride) {
        const Vector3f& p = segment.front.position(segment.pixels[i].x, segment.pixels[i].y);
        ++count;
        if (plane.normal.dot(p) > plane.offset)
            ++behind;
        else if (!staysInside(segment, p, plane.mirrored(p)))
            ++outside;
    }
    const auto total = static_cast<float>(count);
    return {static_cast<float>(behind) / total, static_cast<float>(outside) / total};
}

MirrorPlane fitMirrorPlane(const SegmentPixels& segment, const Vector3f& axis) {
    CORE_ASSERT(!segment.pixels.empty(), "points to mirror");
    float nearest = std::numeric_limits<float>::max();
    float farthest = std::numeric_limits<float>::lowest();
    for (const auto& [x, y] : segment.pixels) {
        nearest = std::min(nearest, axis.dot(segment.front.position(x, y)));
        farthest = std::max(farthest, axis.dot(segment.front.position(x, y)));
    }
    MirrorPlane best{axis, farthest, 2};
    float low = nearest;
    float high = farthest;
    float offset = farthest;
    for (int iteration = 0; iteration < kBisections; ++iteration) {
        const auto [behind, outside] = mirrorErrors(segment, {axis, offset, 0});
        if (const float error = std::max(behind, outside); error < best.error) best = {axis, offset, error};
        if (behind < outside) {
            high = offset;
        } else {
            low = offset;
        }
        if (low >= farthest) break;
        offset = 0.5f * (low + high);
    }
    return best;
}

MirrorPlane parallelMirrorPlane(const SegmentPixels& segment) {
    std::vector<float> outline;
    for (const auto& [x, y] : segment.pixels) {
        const bool edge = std::ranges::any_of(kNeighbors, [&, px = x, py = y](Pixel step) {
            const int nx = px + step.x;
            const int ny = py + step.y;
            return !segment.labels.contains(nx, ny) || segment.labels(nx, ny) != segment.label;
        });
        if (edge) outline.push_back(segment.front.depth(x, y));
    }
    // An outline without depth leaves the whole segment.
    if (outline.empty())
        for (const auto& [x, y] : segment.pixels) outline.push_back(segment.front.depth(x, y));
    MirrorPlane plane{{0, 0, 1}, quantile(outline, kOutlineQuantile), 0};
    const auto [behind, outside] = mirrorErrors(segment, plane);
    plane.error = std::max(behind, outside);
    return plane;
}

}  // namespace core::analysis
