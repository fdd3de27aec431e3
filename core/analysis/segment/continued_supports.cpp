// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/segment/continued_supports.h"

#include <algorithm>
#include <cmath>

#include "core/base/label_table.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Number of points of a support that its plane is fitted to, about.
constexpr std::size_t kMaxPoints = 4000;
/// Fraction of the distance: a pixel that shows something farther than this beyond the plane shows the plane's end.
constexpr float kSeenThrough = 0.02f;
/// Quantile of the points' distances that counts as the reach of a support.
constexpr double kReachQuantile = 0.98;

}  // namespace

ContinuedSupports::ContinuedSupports(const Camera& camera, const LabelImage& labels, const Surface& front)
    : camera_(camera), front_(front) {
    const std::vector<bool> isSupport = findSupports(labels);
    LabelTable<std::vector<Vector3f>> pointsOf;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (isSupport[labels(x, y)] && front.depth(x, y) > 0)
                pointsOf[labels(x, y)].push_back(front.position(x, y));
    for (std::size_t label = 0; label < pointsOf.size(); ++label) {
        const std::vector<Vector3f>& all = pointsOf[label];
        std::vector<Vector3f> points;
        const std::size_t stride = all.size() / kMaxPoints + 1;
        for (std::size_t i = 0; i < all.size(); i += stride) points.push_back(all[i]);
        const auto plane = fitPlane(points, 2 / (camera.fx + camera.fy));
        if (!plane) continue;
        std::vector<float> distances;
        for (const Vector3f& p : points) distances.push_back(p.norm());
        supports_.push_back({*plane, quantile(distances, kReachQuantile)});
    }
}

bool ContinuedSupports::continuesAt(const Vector3f& point) const {
    if (!(point.z() > 0)) return true;
    const Vector2f pixel = camera_.project(point);
    if (!(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < static_cast<float>(camera_.width) &&
          pixel.y() < static_cast<float>(camera_.height)))
        return true;
    const float seen = front_.depth(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    return seen > 0 && seen <= (1 + kSeenThrough) * point.z();
}

bool ContinuedSupports::meets(const Vector3f& origin, const Vector3f& direction) const {
    return std::ranges::any_of(supports_, [&](const Support& support) {
        const float slope = support.plane.normal.dot(direction);
        const float height = support.plane.offset - support.plane.normal.dot(origin);
        if (!(slope > 1e-6f) || !(height > 0)) return false;
        const Vector3f point = origin + height / slope * direction;
        return point.norm() <= support.reach && continuesAt(point);
    });
}

}  // namespace core::analysis
