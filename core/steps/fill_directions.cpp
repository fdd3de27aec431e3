// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/fill_directions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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

/// Laplace's equation, or with `screen` > 0 [rad] the screened one, Δu = u/screen², on the sphere of the map's texels:
/// u is given where coverage > 0. From coarse to fine, so that every level only has to settle its own detail.
void solveMembrane(const ImageF& coverage, ImageRgb& values, float screen, const StepContext& context,
                   const char* stepName, float fraction) {
    const int width = values.width();
    const int height = values.height();
    if (height >= 16 && height % 2 == 0) {
        ImageF coarseCoverage(width / 2, height / 2, 0.0f);
        ImageRgb coarse(width / 2, height / 2, Vector3f::Zero());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (!(coverage(x, y) > 0)) continue;
                coarse(x / 2, y / 2) += values(x, y);
                coarseCoverage(x / 2, y / 2) += 1;
            }
        }
        for (std::size_t i = 0; i < coarse.size(); ++i)
            if (coarseCoverage[i] > 0) coarse[i] /= coarseCoverage[i];
        solveMembrane(coarseCoverage, coarse, screen, context, stepName, fraction);
        const DirectionalMap guess{std::move(coarse), {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (!(coverage(x, y) > 0))
                    values(x, y) = guess.lookupTexel(
                        {0.5f * (static_cast<float>(x) + 0.5f), 0.5f * (static_cast<float>(y) + 0.5f)});
    }

    const double step = std::numbers::pi / height;
    struct Row {
        float up, down, side, scale;
    };
    // Finite volumes: fluxes over the four edges of a texel; the poles have no edge.
    std::vector<Row> rows(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const double middle = std::sin((y + 0.5) * step);
        const double up = std::sin(y * step);
        const double down = std::sin((y + 1) * step);
        const double side = 1 / middle;
        const double absorbed = screen > 0 ? middle * step * step / static_cast<double>(screen * screen) : 0;
        rows[static_cast<std::size_t>(y)] = {static_cast<float>(up), static_cast<float>(down), static_cast<float>(side),
                                             static_cast<float>(1 / (up + down + 2 * side + absorbed))};
    }
    constexpr int kSweeps = 60;
    constexpr float kOverRelaxation = 1.7f;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        context.checkpoint(stepName, fraction);
        for (int parity = 0; parity < 2; ++parity) {
            tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const tbb::blocked_range<int>& range) {
                for (int y = range.begin(); y != range.end(); ++y) {
                    const Row& row = rows[static_cast<std::size_t>(y)];
                    for (int x = (y + parity) % 2; x < width; x += 2) {
                        if (coverage(x, y) > 0) continue;
                        Vector3f sum = row.side * (values((x + 1) % width, y) + values((x + width - 1) % width, y));
                        if (y > 0) sum += row.up * values(x, y - 1);
                        if (y + 1 < height) sum += row.down * values(x, y + 1);
                        values(x, y) += kOverRelaxation * (row.scale * sum - values(x, y));
                    }
                }
            });
        }
    }
}

void fillShepard(DirectionalMap& map, const DirectionTree& tree, const char* stepName, const StepContext& context,
                 float from, float to) {
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    parallelFor(
        context, stepName, height,
        [&](int y) {
            for (int x = 0; x < width; ++x)
                if (!(map.coverage(x, y) > 0))
                    map.radiance(x, y) = tree.interpolate(DirectionalMap::directionFromTexel(
                        {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height));
        },
        from, to);
}

void fillMembrane(DirectionalMap& map, const StepContext& context, const char* stepName, float fraction) {
    // Logarithms need a floor: a thousandth of the mean of what was observed.
    const Vector3f floor = (map.mean(std::numeric_limits<float>::min()) * 1e-3f).cwiseMax(1e-9f);
    DirectionalMap logarithms{ImageRgb(map.radiance.width(), map.radiance.height(), Vector3f::Zero()), map.coverage};
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (map.coverage[i] > 0) logarithms.radiance[i] = map.radiance[i].cwiseMax(floor).array().log();
    solveMembrane(map.coverage, logarithms.radiance, 0, context, stepName, fraction);
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (!(map.coverage[i] > 0)) map.radiance[i] = logarithms.radiance[i].array().exp();
}

}  // namespace

DirectionalAccumulator::DirectionalAccumulator(int height)
    : sum_(2 * height, height, Vector3f::Zero()),
      weight_(2 * height, height, Vector3f::Zero()),
      total_(2 * height, height, 0.0f),
      clipped_(2 * height, height, 7) {}

void DirectionalAccumulator::add(const Vector3f& direction, const Vector3f& radiance, float weight, unsigned clipped) {
    const Vector2f texel = DirectionalMap::texelFromDirection(direction, sum_.width(), sum_.height());
    const int x = static_cast<int>(std::floor(texel.x()));
    const int y = std::clamp(static_cast<int>(texel.y()), 0, sum_.height() - 1);
    const std::size_t i = sum_.index((x % sum_.width() + sum_.width()) % sum_.width(), y);
    total_[i] += weight;
    for (int c = 0; c < 3; ++c) {
        const unsigned bit = 1u << c;
        const bool onlyClipped = (clipped_[i] & bit) != 0;
        if ((clipped & bit) != 0 && !onlyClipped) continue;
        if ((clipped & bit) == 0 && onlyClipped) {
            sum_[i][c] = weight_[i][c] = 0;
            clipped_[i] = static_cast<std::uint8_t>(clipped_[i] & ~bit);
        }
        sum_[i][c] += weight * radiance[c];
        weight_[i][c] += weight;
    }
}

DirectionalMap DirectionalAccumulator::map() const {
    DirectionalMap result{sum_, total_};
    Image<std::uint8_t> clipped(sum_.width(), sum_.height(), 0);
    bool any = false;
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        if (!(total_[i] > 0)) continue;
        result.radiance[i] = sum_[i].cwiseQuotient(weight_[i]);
        clipped[i] = clipped_[i];
        any = any || clipped_[i] != 0;
    }
    if (any) result.clipped = std::move(clipped);
    return result;
}

void fillDirections(DirectionalMap& map, EnvironmentFill method, const Vector3f& fallback, const char* stepName,
                    const StepContext& context, float from, float to) {
    const DirectionTree tree(map);
    if (tree.empty()) {
        std::ranges::fill(map.radiance.pixels(), fallback);
    } else if (method == EnvironmentFill::Shepard) {
        fillShepard(map, tree, stepName, context, from, to);
    } else {
        fillMembrane(map, context, stepName, 0.5f * (from + to));
    }
}

void completeDirections(DirectionalMap& map, const ImageRgb& user, const char* stepName, const StepContext& context,
                        float fraction) {
    CORE_ASSERT(map.radiance.sameSize(user), "maps of one size");
    constexpr float kBlend = 0.06f;  // [rad]: the difference falls to a twentieth within ten degrees
    ImageRgb difference(user.width(), user.height(), Vector3f::Zero());
    for (std::size_t i = 0; i < user.size(); ++i)
        if (map.coverage[i] > 0) difference[i] = map.radiance[i] - user[i];
    solveMembrane(map.coverage, difference, kBlend, context, stepName, fraction);
    for (std::size_t i = 0; i < user.size(); ++i)
        if (!(map.coverage[i] > 0)) map.radiance[i] = (user[i] + difference[i]).cwiseMax(0.0f);
}

}  // namespace core::steps
