// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/material/diffusion_profile.h"
#include "core/material/translucency.h"
#include "core/shading/diffusion_grid.h"

namespace core {
namespace {

/// Samples on a sphere seen as a picture of 48x48 pixels.
struct Body {
    ImageV3 position{48, 48};
    ImageF depth{48, 48};
    LabelImage labels{48, 48};
    std::vector<Vector3f> points;

    explicit Body(int count, float radius = 0.1f) {
        std::mt19937 random(7);
        std::normal_distribution<float> normal;
        const auto surface = [radius](const Vector3f& n) -> Vector3f { return Vector3f(0, 0, 1) + radius * n; };
        for (int i = 0; i < count; ++i)
            points.push_back(surface(Vector3f(normal(random), normal(random), normal(random)).normalized()));
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x) {
                const Vector2f p(static_cast<float>(x - 23.5) / 23, static_cast<float>(y - 23.5) / 23);
                if (p.norm() > 0.98f) continue;
                position(x, y) = surface(Vector3f(p.x(), p.y(), -std::sqrt(1 - p.squaredNorm())));
                depth(x, y) = position(x, y).z();
                labels(x, y) = 3;
            }
    }
    [[nodiscard]] double spacing() const {
        return std::sqrt(4 * std::numbers::pi * 0.01 / static_cast<double>(std::max<std::size_t>(points.size(), 1)));
    }
    [[nodiscard]] DiffusionGrid grid(DiffusionQuality quality = DiffusionQuality::Standard) const {
        return buildDiffusionGrid(points, spacing(), labels, depth, position, 3, quality);
    }
};

TEST(DiffusionKernel, IsTheProfileForEveryPreset) {
    for (const int count : {300, 3000, 30000}) {
        const Body body(count);
        const DiffusionGrid grid = body.grid();
        for (const TranslucencyPreset& preset : translucencyPresets()) {
            const DiffusionProfile profile =
                blurred(profileFromTranslucency(toTranslucency(preset)), grid.spacing * grid.spacing);
            const DiffusionKernel kernel = fitDiffusionKernel(profile, grid);
            ASSERT_EQ(kernel.narrow.size(), grid.levels.size());
            double r = 1e-4 * grid.spacing;
            std::array<double, 3> difference{};  // of light, ring by ring
            for (double next = 1.02 * r; next < grid.diameter; r = next, next *= 1.02)
                for (std::size_t c = 0; c < 3; ++c) {
                    const double ring = std::numbers::pi * (next * next - r * r);
                    difference[c] += ring * std::abs(evaluateKernel(kernel, grid, r * next)[c] -
                                                     profile.evaluate(static_cast<int>(c), r * next));
                }
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_LT(difference[c], 0.03 * profile.integral(static_cast<int>(c))) << preset.key << " " << count;
        }
    }
}

TEST(DiffusionKernel, WideProfilesNeedNoFineLevels) {
    const DiffusionGrid grid = Body(30000).grid();
    Translucency wide;
    wide.sigmaSPrime = Vector3f::Constant(0.05f);
    wide.sigmaA = Vector3f::Constant(0.001f);
    Translucency narrow = wide;
    narrow.sigmaSPrime = Vector3f::Constant(20);
    const double area = grid.spacing * grid.spacing;
    const DiffusionKernel few = fitDiffusionKernel(blurred(profileFromTranslucency(wide), area), grid);
    EXPECT_EQ(fitDiffusionKernel(blurred(profileFromTranslucency(narrow), area), grid).finest, 0U);
    EXPECT_GE(few.finest, 2U);
    for (std::size_t l = 0; l < few.finest; ++l) EXPECT_TRUE(few.narrow[l].isZero() && few.wide[l].isZero());
}

TEST(DiffusionKernel, NothingReflectedIsNothing) {
    const DiffusionGrid grid = Body(100).grid();
    DiffusionProfile black;
    const DiffusionKernel kernel = fitDiffusionKernel(black, grid);
    for (std::size_t l = 0; l < grid.levels.size(); ++l)
        EXPECT_TRUE(kernel.narrow[l].isZero() && kernel.wide[l].isZero());
}

kernel::uint word(const DiffusionGrid& grid, std::uint32_t brick, std::uint32_t at) {
    return grid.words[std::size_t{brick} * DIFFUSION_BRICK_WORDS + at];
}

std::array<int, 3> origin(const DiffusionGrid& grid, std::uint32_t brick) {
    std::array<int, 3> result{};
    for (std::uint32_t k = 0; k < 3; ++k) result[k] = static_cast<int>(word(grid, brick, DIFFUSION_BRICK_ORIGIN + k));
    return result;
}

TEST(DiffusionGrid, BricksKnowEachOther) {
    const DiffusionGrid grid = Body(3000).grid();
    ASSERT_GE(grid.levels.size(), 4U);
    for (std::uint32_t w = 0; w < DIFFUSION_BRICK_WORDS; ++w) EXPECT_EQ(word(grid, 0, w), 0U) << "brick 0 is empty";
    for (std::size_t l = 0; l < grid.levels.size(); ++l) {
        const DiffusionGrid::Level& level = grid.levels[l];
        EXPECT_LE(level.wanted, level.near);
        EXPECT_LE(level.near, level.count);
        for (std::uint32_t brick = level.first; brick < level.first + level.count; ++brick) {
            const std::array<int, 3> at = origin(grid, brick);
            for (std::uint32_t n = 0; n < 27; ++n) {
                const std::uint32_t other = word(grid, brick, DIFFUSION_BRICK_NEIGHBOURS + n);
                if (other == 0) continue;
                const std::array<int, 3> there = origin(grid, other);
                EXPECT_EQ(there[0] - at[0], static_cast<int>(n % 3) - 1);
                EXPECT_EQ(there[1] - at[1], static_cast<int>(n / 3 % 3) - 1);
                EXPECT_EQ(there[2] - at[2], static_cast<int>(n / 9) - 1);
                EXPECT_EQ(word(grid, other, DIFFUSION_BRICK_NEIGHBOURS + 26 - n), brick);
            }
            EXPECT_EQ(word(grid, brick, DIFFUSION_BRICK_NEIGHBOURS + 13), brick);
            if (l + 1 == grid.levels.size()) continue;
            const std::uint32_t parent = word(grid, brick, DIFFUSION_BRICK_PARENT);
            ASSERT_NE(parent, 0U);
            const std::uint32_t child = static_cast<std::uint32_t>((at[0] & 1) + 2 * (at[1] & 1) + 4 * (at[2] & 1));
            EXPECT_EQ(word(grid, parent, DIFFUSION_BRICK_CHILDREN + child), brick);
            // What its cells are read from: next to the parent where the brick touches its side.
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t step = k == 0 ? 1 : k == 1 ? 3 : 9;
                const std::uint32_t beside = (at[k] & 1) != 0 ? 13 + step : 13 - step;
                EXPECT_NE(word(grid, parent, DIFFUSION_BRICK_NEIGHBOURS + beside), 0U);
            }
            if (brick < level.first + level.wanted) {
                EXPECT_LT(parent, grid.levels[l + 1].first + grid.levels[l + 1].wanted);
            }
        }
    }
}

TEST(DiffusionGrid, SamplesAndPixelsAreWhereTheyBelong) {
    const Body body(2000);
    const DiffusionGrid grid = body.grid();
    const DiffusionGrid::Level& finest = grid.levels[0];
    ASSERT_EQ(grid.sampleStarts.size(), finest.count + 1);
    std::vector<double> weight(body.points.size());
    for (std::uint32_t brick = 0; brick < finest.count; ++brick) {
        const std::array<int, 3> at = origin(grid, finest.first + brick);
        for (std::uint32_t e = grid.sampleStarts[brick]; e < grid.sampleStarts[brick + 1]; ++e) {
            const std::uint32_t i = grid.samples[e];
            for (int cell = 0; cell < DIFFUSION_BRICK_CELLS; ++cell)
                weight[i] += static_cast<double>(
                    kernel::diffusion_spline(grid.places[i].x - static_cast<float>(4 * at[0] + cell % 4) - 0.5f) *
                    kernel::diffusion_spline(grid.places[i].y - static_cast<float>(4 * at[1] + cell / 4 % 4) - 0.5f) *
                    kernel::diffusion_spline(grid.places[i].z - static_cast<float>(4 * at[2] + cell / 16) - 0.5f));
        }
    }
    for (const double w : weight) EXPECT_NEAR(w, 1, 1e-4) << "all of its light reaches cells";
    std::size_t pixelCount = 0;
    for (std::size_t i = 0; i < body.labels.size(); ++i) pixelCount += body.labels[i] == 3 ? 1 : 0;
    EXPECT_EQ(grid.pixels.size(), pixelCount);
    for (const kernel::uvec2& pixel : grid.pixels) {
        ASSERT_GE(pixel.y, finest.first);
        ASSERT_LT(pixel.y, finest.first + finest.wanted);
        const Vector3f& p = body.position(static_cast<int>(pixel.x & 0xffffU), static_cast<int>(pixel.x >> 16));
        const kernel::vec3 q = kernel::diffusion_axes({p.x(), p.y(), p.z()});
        const std::array<float, 3> turned{q.x, q.y, q.z};
        for (std::size_t k = 0; k < 3; ++k) {
            const double place = (static_cast<double>(turned[k]) - grid.corner[k]) / grid.cell;
            EXPECT_EQ(static_cast<int>(std::floor(place / 4)), origin(grid, pixel.y)[k]);
        }
    }
}

TEST(DiffusionGrid, NeverHasTooManyBricks) {
    const Body body(4000);
    // As if samples were a micrometre apart.
    const DiffusionGrid grid =
        buildDiffusionGrid(body.points, 1e-6, body.labels, body.depth, body.position, 3, DiffusionQuality::Fine);
    EXPECT_LE(grid.brickCount(), kMaxDiffusionBricks + 1);
    EXPECT_GT(grid.spacing, 1e-6);
    EXPECT_GT(grid.pixels.size(), 0U);
}

TEST(DiffusionGrid, OddInputsAreNoTrouble) {
    const Body body(0);
    EXPECT_EQ(
        buildDiffusionGrid({}, 0, body.labels, body.depth, body.position, 9, DiffusionQuality::Draft).levels.size(), 1U)
        << "neither samples nor pixels";
    const std::vector<Vector3f> one(100, Vector3f(0, 0, 1));
    const DiffusionGrid grid =
        buildDiffusionGrid(one, 1e-3, body.labels, body.depth, body.position, 9, DiffusionQuality::Standard);
    EXPECT_GE(grid.levels[0].count, 1U);
    EXPECT_EQ(grid.levels[0].wanted, 0U);
    const DiffusionKernel kernel = fitDiffusionKernel(blurred(profileFromTranslucency(Translucency()), 1e-6), grid);
    for (const Vector3f& w : kernel.narrow) EXPECT_TRUE(w.allFinite());
    EXPECT_EQ(body.grid().samples.size(), 0U) << "pixels alone";
}

}  // namespace
}  // namespace core
