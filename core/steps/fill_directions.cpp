// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/fill_directions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"

namespace core::steps {
namespace {

constexpr float kOpening = 0.2f;

/// A group of observed texels.
struct Node {
    Vector3f direction{0, 0, 0};  ///< unit, weighted mean; before `finish` the weighted sum
    Vector3f radiance{0, 0, 0};   ///< weighted sum
    float weight = 0;
    float radius = 0;  ///< [rad], from `direction` to the farthest texel centre
};

float angleBetween(const Vector3f& a, const Vector3f& b) {
    return 2 * std::asin(std::min(1.0f, 0.5f * (a - b).norm()));
}

/// Quadtree over the texels of the map, stored as a pyramid of images.
class DirectionTree {
  public:
    explicit DirectionTree(const DirectionalMap& map) {
        const int width = map.radiance.width();
        const int height = map.radiance.height();
        levels_.emplace_back(width, height);
        for (int y = 0; y < height; ++y) {
            const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
            for (int x = 0; x < width; ++x) {
                const float count = map.coverage(x, y);
                if (count <= 0) continue;
                Node& node = levels_[0](x, y);
                node.weight = solidAngle * count / (count + 1);
                node.radiance = node.weight * map.radiance(x, y);
                node.direction = DirectionalMap::directionFromTexel(
                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height);
            }
        }
        while (levels_.back().width() > 1 || levels_.back().height() > 1) levels_.push_back(merge(levels_.back()));
    }

    [[nodiscard]] bool empty() const { return levels_.back()(0, 0).weight <= 0; }

    [[nodiscard]] Vector3f interpolate(const Vector3f& direction) const {
        Vector3f sum = Vector3f::Zero();
        float weight = 0;
        gather(static_cast<int>(levels_.size()) - 1, 0, 0, direction, sum, weight);
        return sum / weight;
    }

  private:
    static Image<Node> merge(const Image<Node>& fine) {
        Image<Node> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
        for (int y = 0; y < coarse.height(); ++y) {
            for (int x = 0; x < coarse.width(); ++x) {
                Node& node = coarse(x, y);
                forChildren(fine, x, y, [&](const Node& child) {
                    node.direction += child.weight * child.direction;
                    node.radiance += child.radiance;
                    node.weight += child.weight;
                });
                if (node.weight <= 0) continue;
                const float norm = node.direction.norm();
                node.direction = norm > 0 ? Vector3f(node.direction / norm) : Vector3f(0, 0, 1);
                forChildren(fine, x, y, [&](const Node& child) {
                    node.radius = std::max(node.radius, angleBetween(node.direction, child.direction) + child.radius);
                });
            }
        }
        return coarse;
    }

    template <class Visit>
    static void forChildren(const Image<Node>& fine, int x, int y, const Visit& visit) {
        for (int k = 0; k < 4; ++k) {
            const int fx = 2 * x + (k & 1);
            const int fy = 2 * y + (k >> 1);
            if (fine.contains(fx, fy) && fine(fx, fy).weight > 0) visit(fine(fx, fy));
        }
    }

    void gather(int level, int x, int y, const Vector3f& direction, Vector3f& sum, float& weight) const {
        const Node& node = levels_[static_cast<std::size_t>(level)](x, y);
        const float distance = angleBetween(direction, node.direction);
        if (level == 0 || node.radius < kOpening * distance) {
            const float k = 1 / std::max(distance * distance * distance, 1e-12f);
            sum += k * node.radiance;
            weight += k * node.weight;
            return;
        }
        const Image<Node>& fine = levels_[static_cast<std::size_t>(level) - 1];
        for (int k = 0; k < 4; ++k) {
            const int fx = 2 * x + (k & 1);
            const int fy = 2 * y + (k >> 1);
            if (fine.contains(fx, fy) && fine(fx, fy).weight > 0) gather(level - 1, fx, fy, direction, sum, weight);
        }
    }

    std::vector<Image<Node>> levels_;
};

}  // namespace

void DirectionalAccumulator::add(const Vector3f& direction, const Vector3f& radiance) {
    const Vector2f texel = DirectionalMap::texelFromDirection(direction, sum_.width(), sum_.height());
    const int x = static_cast<int>(std::floor(texel.x()));
    const int y = std::clamp(static_cast<int>(texel.y()), 0, sum_.height() - 1);
    const std::size_t i = sum_.index((x % sum_.width() + sum_.width()) % sum_.width(), y);
    sum_[i] += radiance;
    count_[i] += 1;
}

void DirectionalAccumulator::add(const DirectionalAccumulator& other, const Vector3f& scale) {
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        sum_[i] += other.sum_[i].cwiseProduct(scale);
        count_[i] += other.count_[i];
    }
}

DirectionalMap DirectionalAccumulator::map() const {
    DirectionalMap result{sum_, count_};
    for (std::size_t i = 0; i < sum_.size(); ++i)
        if (count_[i] > 0) result.radiance[i] /= count_[i];
    return result;
}

void fillDirections(DirectionalMap& map, const Vector3f& fallback, const char* stepName, const StepContext& context,
                    float from, float to) {
    const DirectionTree tree(map);
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    parallelFor(
        context, stepName, height,
        [&](int y) {
            for (int x = 0; x < width; ++x) {
                if (map.coverage(x, y) > 0) continue;
                map.radiance(x, y) =
                    tree.empty() ? fallback
                                 : tree.interpolate(DirectionalMap::directionFromTexel(
                                       {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height));
            }
        },
        from, to);
}

}  // namespace core::steps
