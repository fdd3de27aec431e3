// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/diffusion_grid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace core {
namespace {

using Cell = std::array<int, 3>;

constexpr std::size_t kMaxLevels = 16;
constexpr int kSplineReach = 1;                               // cells to either side that a sample or a pixel meets
constexpr int kSmoothing = kWideSteps - kNarrowSteps;         // and that wide is made of
constexpr double kNarrowVariance = 0.5 + kNarrowSteps / 3.0;  // in cells
constexpr double kWideVariance = 0.5 + kWideSteps / 3.0;

Eigen::Vector3d inAxes(const Vector3f& p) {
    const kernel::vec3 q = kernel::diffusion_axes({p.x(), p.y(), p.z()});
    return Vector3f(q.x, q.y, q.z).cast<double>();
}

/// The bricks of one level.
struct BrickMap {
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;  // within the level
    std::vector<Cell> origins;                                 // in bricks

    static std::uint64_t keyOf(const Cell& c) {
        const auto part = [](int v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v) & 0x1fffffU); };
        return part(c[0]) | part(c[1]) << 21 | part(c[2]) << 42;
    }
    std::uint32_t add(const Cell& c) {
        const auto [found, fresh] = numbers.try_emplace(keyOf(c), static_cast<std::uint32_t>(origins.size()));
        if (fresh) origins.push_back(c);
        return found->second;
    }
    [[nodiscard]] std::optional<std::uint32_t> find(const Cell& c) const {
        const auto found = numbers.find(keyOf(c));
        if (found == numbers.end()) return std::nullopt;
        return found->second;
    }
};

/// Calls `visit` with every brick from `low` to `high`.
template <class Visit>
void forBricks(const Cell& low, const Cell& high, const Visit& visit) {
    for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
            for (int x = low[0]; x <= high[0]; ++x) visit(Cell{x, y, z});
}

struct Builder {
    std::span<const Vector3f> positions;
    const ImageV3& position;
    std::vector<std::uint32_t> pixels;  // x | y << 16
    const Progress& progress;
    DiffusionGrid grid{};
    std::vector<BrickMap> maps{};

    [[nodiscard]] const Vector3f& pointOf(std::uint32_t pixel) const {
        return position(static_cast<int>(pixel & 0xffffU), static_cast<int>(pixel >> 16));
    }

    [[nodiscard]] Eigen::Vector3d placeOf(const Vector3f& p) const {
        return (inAxes(p) - Eigen::Vector3d(grid.corner.data())) / grid.cell;
    }

    /// Bricks that hold the cells around `place`, as far as `cells` away.
    static std::pair<Cell, Cell> reach(const Eigen::Vector3d& place, int cells) {
        Cell low{};
        Cell high{};
        for (int k = 0; k < 3; ++k) {
            const auto c = static_cast<int>(std::floor(place[k]));
            low[static_cast<std::size_t>(k)] = (c - cells) >> 2;
            high[static_cast<std::size_t>(k)] = (c + cells) >> 2;
        }
        return {low, high};
    }

    /// Corner, extent and number of levels for the grid's cell.
    void layOut(const Eigen::AlignedBox3d& box) {
        grid.diameter = std::max(box.isEmpty() ? 0.0 : box.diagonal().norm(), grid.cell);
        std::size_t count = 1;
        while (count < kMaxLevels && 1.5 * grid.cellOf(count - 1) < grid.diameter) ++count;
        grid.levels.assign(count, {});
        // Two bricks of the coarsest level beside everything, so that no cell has a negative number.
        const double margin = 8 * grid.cellOf(count - 1);
        for (int k = 0; k < 3; ++k)
            grid.corner[static_cast<std::size_t>(k)] = (box.isEmpty() ? 0.0 : box.min()[k]) - margin;
    }

    /// False when there are too many bricks.
    bool findBricks() {
        maps.assign(grid.levels.size(), {});
        grid.places.clear();
        grid.pixels.clear();
        std::pair<Cell, Cell> last{{-1, -1, -1}, {-1, -1, -1}};
        const auto addAround = [&](const Eigen::Vector3d& place, int cells) {
            const std::pair<Cell, Cell> bricks = reach(place, cells);
            if (bricks == last) return true;
            last = bricks;
            forBricks(bricks.first, bricks.second, [&](const Cell& c) { maps[0].add(c); });
            return maps[0].origins.size() <= kMaxDiffusionBricks;
        };
        const auto found = [&](std::size_t level) { return static_cast<std::uint32_t>(maps[level].origins.size()); };
        for (const std::uint32_t pixel : pixels) {
            const Eigen::Vector3d place = placeOf(pointOf(pixel));
            if (!addAround(place, kSplineReach)) return false;
            Cell c{};
            for (int k = 0; k < 3; ++k) c[static_cast<std::size_t>(k)] = static_cast<int>(std::floor(place[k])) >> 2;
            grid.pixels.push_back({pixel, *maps[0].find(c)});
        }
        grid.levels[0].wanted = found(0);
        for (const std::uint32_t pixel : pixels)
            if (!addAround(placeOf(pointOf(pixel)), kSplineReach + kSmoothing)) return false;
        grid.levels[0].near = found(0);
        for (const Vector3f& p : positions) {
            const Eigen::Vector3d place = placeOf(p);
            if (!addAround(place, kSplineReach)) return false;
            grid.places.push_back(
                {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z()), 0});
        }
        std::size_t total = maps[0].origins.size();
        for (std::size_t l = 1; l < maps.size(); ++l) {
            progress.checkpoint(static_cast<float>(l) / static_cast<float>(maps.size()));
            const std::vector<Cell>& fine = maps[l - 1].origins;
            // A brick's cells are read from 2b-1 to 2b+2 of the coarser level.
            const auto addCoarser = [&](std::size_t count, int cells) {
                for (std::size_t i = 0; i < count; ++i) {
                    Cell low{};
                    Cell high{};
                    for (std::size_t k = 0; k < 3; ++k) {
                        low[k] = (2 * fine[i][k] - 1 - cells) >> 2;
                        high[k] = (2 * fine[i][k] + 2 + cells) >> 2;
                    }
                    forBricks(low, high, [&](const Cell& c) { maps[l].add(c); });
                }
            };
            addCoarser(grid.levels[l - 1].wanted, 0);
            grid.levels[l].wanted = found(l);
            addCoarser(grid.levels[l - 1].wanted, kSmoothing);
            grid.levels[l].near = found(l);
            addCoarser(fine.size(), 0);
            total += maps[l].origins.size();
        }
        return total <= kMaxDiffusionBricks;
    }

    void link() {
        std::uint32_t next = 1;
        for (std::size_t l = 0; l < maps.size(); ++l) {
            grid.levels[l].first = next;
            grid.levels[l].count = static_cast<std::uint32_t>(maps[l].origins.size());
            next += grid.levels[l].count;
        }
        grid.words.assign(std::size_t{next} * DIFFUSION_BRICK_WORDS, 0);
        for (std::size_t l = 0; l < maps.size(); ++l) {
            progress.checkpoint(static_cast<float>(l) / static_cast<float>(maps.size()));
            const auto number = [&](std::size_t level, const Cell& c) {
                const std::optional<std::uint32_t> found = maps[level].find(c);
                return found ? grid.levels[level].first + *found : 0;
            };
            for (std::uint32_t i = 0; i < grid.levels[l].count; ++i) {
                const Cell& c = maps[l].origins[i];
                const std::size_t brick = grid.levels[l].first + i;
                kernel::uint* words = &grid.words[brick * DIFFUSION_BRICK_WORDS];
                std::size_t neighbour = DIFFUSION_BRICK_NEIGHBOURS;
                forBricks({c[0] - 1, c[1] - 1, c[2] - 1}, {c[0] + 1, c[1] + 1, c[2] + 1},
                          [&](const Cell& around) { words[neighbour++] = number(l, around); });
                if (l + 1 < maps.size()) {
                    const std::uint32_t parent = number(l + 1, {c[0] >> 1, c[1] >> 1, c[2] >> 1});
                    words[DIFFUSION_BRICK_PARENT] = parent;
                    const auto child = static_cast<unsigned>((c[0] & 1) + 2 * (c[1] & 1) + 4 * (c[2] & 1));
                    grid.words[std::size_t{parent} * DIFFUSION_BRICK_WORDS + DIFFUSION_BRICK_CHILDREN + child] =
                        static_cast<kernel::uint>(brick);
                }
                for (std::size_t k = 0; k < 3; ++k) words[DIFFUSION_BRICK_ORIGIN + k] = static_cast<kernel::uint>(c[k]);
            }
        }
        for (kernel::uvec2& pixel : grid.pixels) pixel.y += grid.levels[0].first;
    }

    void listSamples() {
        std::vector<kernel::uint> counts(grid.levels[0].count + 1, 0);
        const auto forReached = [&](const auto& visit) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const auto [low, high] = reach(placeOf(positions[i]), kSplineReach);
                forBricks(low, high, [&](const Cell& c) { visit(i, *maps[0].find(c)); });
            }
        };
        forReached([&](std::size_t, std::uint32_t brick) { ++counts[brick + 1]; });
        for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
        grid.sampleStarts = counts;
        grid.samples.resize(counts.back());
        forReached(
            [&](std::size_t i, std::uint32_t brick) { grid.samples[counts[brick]++] = static_cast<kernel::uint>(i); });
    }
};

/// Depth of the source without absorption whose profile is as narrow at r = 0 [m]. Absorption counts more than that:
/// what it shapes is nearly a Gaussian, which wider ones cannot make up.
double equivalentDepth(const DiffusionProfile::Term& t) {
    constexpr double kAbsorption = 1.6;
    return std::sqrt(3 * t.z / (kAbsorption * t.sigma * t.sigma * t.z / (1 + t.sigma * t.z) + 3 / t.z));
}

}  // namespace

double cellsPerSpacing(DiffusionQuality quality) {
    switch (quality) {
        case DiffusionQuality::Draft:
            return 0.9;
        case DiffusionQuality::Standard:
            return 0.6;
        case DiffusionQuality::Fine:
            return 0.4;
    }
    return 0.6;
}

DiffusionGrid buildDiffusionGrid(std::span<const Vector3f> positions, double spacing, const LabelImage& labels,
                                 const ImageF& depth, const ImageV3& position, std::uint16_t label,
                                 DiffusionQuality quality, const Progress& progress) {
    std::vector<std::uint32_t> pixels;
    Eigen::AlignedBox3d box;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) {
            if (labels(x, y) != label || !(depth(x, y) > 0) || !position(x, y).allFinite()) continue;
            pixels.push_back(static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16);
            box.extend(inAxes(position(x, y)));
        }
    for (const Vector3f& p : positions) box.extend(inAxes(p));
    const double extent = box.isEmpty() ? 1.0 : box.diagonal().norm();

    Builder builder{.positions = positions, .position = position, .pixels = std::move(pixels), .progress = progress};
    DiffusionGrid& grid = builder.grid;
    // Of no use below what single precision tells apart.
    grid.spacing = std::max({spacing, 1e-4 * extent, 1e-9});
    while (true) {
        grid.cell = cellsPerSpacing(quality) * grid.spacing;
        builder.layOut(box);
        if (builder.findBricks()) break;
        grid.spacing *= 1.25;
    }
    builder.link();
    builder.listSamples();
    return std::move(builder.grid);
}

Vector3f FlatSurface::exitance(const Eigen::Vector3d& sum, const Eigen::Vector3d& whole) const {
    Vector3f result;
    for (int c = 0; c < 3; ++c)
        result[c] = kernel::diffusion_exitance(static_cast<float>(sum[c]), static_cast<float>(whole[c]), integral[c],
                                               tolerance[c]);
    return result;
}

FlatSurface flatSurface(const DiffusionProfile& profile) {
    FlatSurface flat;
    for (int c = 0; c < 3; ++c) {
        const double integral = profile.integral(c);
        if (!(integral > 0)) continue;
        flat.integral[c] = static_cast<float>(integral);
        flat.tolerance[c] = static_cast<float>(profile.tolerance(c));
    }
    return flat;
}

DiffusionKernel fitDiffusionKernel(const DiffusionProfile& profile, const DiffusionGrid& grid) {
    constexpr int kRings = 240;
    constexpr double kRelative = 0.005;  // how much single radii count beside the light of rings
    constexpr double kAll = 30;          // how much all light together counts
    constexpr double kRegularisation = 1e-9;
    const std::size_t count = grid.levels.size();
    DiffusionKernel kernel;
    kernel.narrow.assign(count, Vector3f::Zero());
    kernel.wide.assign(count, Vector3f::Zero());
    kernel.flat = flatSurface(profile);

    double narrowest = std::numeric_limits<double>::max();
    for (const std::vector<DiffusionProfile::Term>& terms : profile.terms)
        for (const DiffusionProfile::Term& t : terms)
            if (t.flux > 0 || t.fluence > 0) narrowest = std::min(narrowest, equivalentDepth(t));
    while (kernel.finest + 1 < count && grid.spacing * static_cast<double>(2U << kernel.finest) <= narrowest)
        ++kernel.finest;

    const auto unknowns = static_cast<Eigen::Index>(2 * (count - kernel.finest));
    for (int c = 0; c < 3; ++c) {
        const double integral = profile.integral(c);
        if (!(integral > 0)) continue;
        double z = std::numeric_limits<double>::max();
        for (const DiffusionProfile::Term& t : profile.terms[static_cast<std::size_t>(c)]) z = std::min(z, t.z);
        const double farthest = std::max(grid.diameter, 2 * z);
        // The last row is all rings together: what is reflected as a whole.
        Eigen::MatrixXd gaussians = Eigen::MatrixXd::Zero(kRings + 1, unknowns);
        Eigen::VectorXd target = Eigen::VectorXd::Zero(kRings + 1);
        for (int ring = 0; ring < kRings; ++ring) {
            const double r = 0.1 * z * std::pow(farthest / (0.1 * z), ring / (kRings - 1.0));
            const double value = profile.evaluate(c, r * r);
            const double weight = 2 * std::numbers::pi * (r * r + 0.1 * z * z) / integral +
                                  (value > 1e-30 * integral / (z * z) ? kRelative / value : 0);
            const double all = kAll * 2 * std::numbers::pi * r * r * std::log(farthest / (0.1 * z)) / kRings / integral;
            for (Eigen::Index i = 0; i < unknowns; ++i) {
                const double h = grid.cellOf(kernel.finest + static_cast<std::size_t>(i / 2));
                const double variance = (i % 2 == 0 ? kNarrowVariance : kWideVariance) * h * h;
                const double gaussian = std::exp(-0.5 * r * r / variance);
                gaussians(ring, i) = weight * gaussian;
                gaussians(kRings, i) += all * gaussian;
            }
            target[ring] = weight * value;
            target[kRings] += all * value;
        }
        const Eigen::VectorXd norms = gaussians.colwise().norm().transpose().cwiseMax(1e-300);
        gaussians.array().rowwise() /= norms.transpose().array();
        const Eigen::MatrixXd normal =
            gaussians.transpose() * gaussians + kRegularisation * Eigen::MatrixXd::Identity(unknowns, unknowns);
        const Eigen::VectorXd solution = normal.ldlt().solve(gaussians.transpose() * target);
        for (Eigen::Index i = 0; i < unknowns; ++i) {
            const std::size_t level = kernel.finest + static_cast<std::size_t>(i / 2);
            const double variance = i % 2 == 0 ? kNarrowVariance : kWideVariance;
            // A cell of width 1 passes on (2πV)^(-3/2) of its light at distance 0.
            const double weight = solution[i] / norms[i] * std::pow(2 * std::numbers::pi * variance, 1.5);
            (i % 2 == 0 ? kernel.narrow : kernel.wide)[level][c] = static_cast<float>(weight);
        }
    }
    return kernel;
}

std::array<double, 3> evaluateKernel(const DiffusionKernel& kernel, const DiffusionGrid& grid, double r2) {
    std::array<double, 3> sum{};
    for (std::size_t level = kernel.finest; level < grid.levels.size(); ++level)
        for (const bool wide : {false, true}) {
            const double h = grid.cellOf(level);
            const double variance = wide ? kWideVariance : kNarrowVariance;
            const double value =
                std::exp(-0.5 * r2 / (variance * h * h)) / std::pow(2 * std::numbers::pi * variance, 1.5);
            for (int c = 0; c < 3; ++c)
                sum[static_cast<std::size_t>(c)] +=
                    value * static_cast<double>((wide ? kernel.wide : kernel.narrow)[level][c]);
        }
    return sum;
}

}  // namespace core
