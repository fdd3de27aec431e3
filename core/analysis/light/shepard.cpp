// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/shepard.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace core::analysis {
namespace {

float angleBetween(const Vector3f& a, const Vector3f& b) {
    return 2 * std::asin(std::min(1.0f, 0.5f * (a - b).norm()));
}

template <class Visit>
void forChildren(const Image<DirectionNode>& fine, int x, int y, const Visit& visit) {
    for (int k = 0; k < 4; ++k) {
        const int fx = 2 * x + (k & 1);
        const int fy = 2 * y + (k >> 1);
        if (fine.contains(fx, fy) && fine(fx, fy).weight > 0) visit(fx, fy);
    }
}

Image<DirectionNode> merge(const Image<DirectionNode>& fine) {
    Image<DirectionNode> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
    for (int y = 0; y < coarse.height(); ++y) {
        for (int x = 0; x < coarse.width(); ++x) {
            DirectionNode& node = coarse(x, y);
            forChildren(fine, x, y, [&](int fx, int fy) {
                const DirectionNode& child = fine(fx, fy);
                node.direction += child.weight * child.direction;
                node.radiance += child.radiance;
                node.weight += child.weight;
            });
            if (node.weight <= 0) continue;
            const float norm = node.direction.norm();
            node.direction = norm > 0 ? Vector3f(node.direction / norm) : Vector3f(0, 0, 1);
            forChildren(fine, x, y, [&](int fx, int fy) {
                const DirectionNode& child = fine(fx, fy);
                node.radius = std::max(node.radius, angleBetween(node.direction, child.direction) + child.radius);
            });
        }
    }
    return coarse;
}

}  // namespace

DirectionTree::DirectionTree(const DirectionalMap& map) {
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    levels_.emplace_back(width, height);
    for (int y = 0; y < height; ++y) {
        const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
        for (int x = 0; x < width; ++x) {
            const float count = map.coverage(x, y);
            if (count <= 0) continue;
            DirectionNode& node = levels_[0](x, y);
            node.weight = solidAngle * count / (count + 1);
            node.radiance = node.weight * map.radiance(x, y);
            node.direction = DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height);
        }
    }
    while (levels_.back().width() > 1 || levels_.back().height() > 1) levels_.push_back(merge(levels_.back()));
}

Vector3f DirectionTree::interpolate(const Vector3f& direction) const {
    Vector3f sum = Vector3f::Zero();
    float weight = 0;
    gather(static_cast<int>(levels_.size()) - 1, 0, 0, direction, sum, weight);
    return sum / weight;
}

void DirectionTree::gather(int level, int x, int y, const Vector3f& direction, Vector3f& sum, float& weight) const {
    const DirectionNode& node = levels_[static_cast<std::size_t>(level)](x, y);
    const float distance = angleBetween(direction, node.direction);
    if (level == 0 || node.radius < kOpening * distance) {
        const float k = 1 / std::max(distance * distance * distance, kMinCube);
        sum += k * node.radiance;
        weight += k * node.weight;
        return;
    }
    forChildren(levels_[static_cast<std::size_t>(level) - 1], x, y,
                [&](int fx, int fy) { gather(level - 1, fx, fy, direction, sum, weight); });
}

void fillShepard(const DirectionTree& tree, DirectionalMap& map, const Progress& progress) {
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    parallelFor(progress, height, [&](int y) {
        for (int x = 0; x < width; ++x)
            if (!(map.coverage(x, y) > 0))
                map.radiance(x, y) = tree.interpolate(DirectionalMap::directionFromTexel(
                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height));
    });
}

}  // namespace core::analysis
