// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/direction_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

namespace {

constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;

}  // namespace

DirectionCells::Point DirectionCells::pointOf(const kernel::vec4& direction) {
    float phi = std::atan2(direction.y, direction.x);
    if (phi < 0) phi += kTwoPi;
    return {std::clamp(direction.z, 0.0f, 1.0f), std::min(phi, kTwoPi)};
}

DirectionCells::DirectionCells(std::span<const kernel::vec4> directions, int levels)
    : levels_(levels), splits_((std::size_t{1} << levels) - 1), cells_(std::size_t{1} << levels) {
    std::vector<Point> points;
    for (const kernel::vec4& direction : directions)
        if (direction.z > 0) points.push_back(pointOf(direction));
    split(points, {0, 1, 0, kTwoPi}, 0, 0);
}

void DirectionCells::split(std::span<Point> points, const kernel::vec4& box, int level, std::size_t node) {
    if (level == levels_) {
        cells_[node - splits_.size()] = box;
        return;
    }
    const auto quantile = [&](auto member, double part) {
        const auto middle = points.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(points.size()));
        std::nth_element(points.begin(), middle, points.end(),
                         [&](const Point& a, const Point& b) { return a.*member < b.*member; });
        return *middle.*member;
    };
    // Splits in turn follow lobes of any shape; splits across the direction in which the box is wide compared with its
    // contents enclose narrow lobes early.
    Split cut{level % 4 == 2, 0};
    if (level % 2 == 1 && points.size() >= 4) {
        const auto spread = [&](auto member) { return quantile(member, 0.75) - quantile(member, 0.25); };
        cut.onZ = (box.y - box.x) * spread(&Point::phi) >= (box.w - box.z) * spread(&Point::z);
    }
    const float low = cut.onZ ? box.x : box.z;
    const float high = cut.onZ ? box.y : box.w;
    cut.at = 0.5f * (low + high);
    if (points.size() >= 2) {
        const float median = cut.onZ ? quantile(&Point::z, 0.5) : quantile(&Point::phi, 0.5);
        if (median > low && median < high) cut.at = median;
    }
    const auto middle =
        std::partition(points.begin(), points.end(), [&](const Point& p) { return (cut.onZ ? p.z : p.phi) < cut.at; });
    const auto count = static_cast<std::size_t>(middle - points.begin());
    splits_[node] = cut;
    kernel::vec4 below = box;
    kernel::vec4 above = box;
    (cut.onZ ? below.y : below.w) = cut.at;
    (cut.onZ ? above.x : above.z) = cut.at;
    split(points.first(count), below, level + 1, 2 * node + 1);
    split(points.subspan(count), above, level + 1, 2 * node + 2);
}

double DirectionCells::solidAngle(const kernel::vec4& cell) {
    return static_cast<double>(cell.y - cell.x) * static_cast<double>(cell.w - cell.z);
}

std::size_t DirectionCells::find(const kernel::vec4& direction) const {
    const Point p = pointOf(direction);
    std::size_t node = 0;
    while (node < splits_.size()) {
        const Split& cut = splits_[node];
        node = 2 * node + ((cut.onZ ? p.z : p.phi) < cut.at ? 1 : 2);
    }
    return node - splits_.size();
}

}  // namespace render
