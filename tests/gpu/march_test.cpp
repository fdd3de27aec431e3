// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/depth_layers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gpu/readback.h"
#include "render/analysis/march_rays.h"
#include "render/scene_geometry.h"
#include "shaders/shared/geometry_block.h"
#include "tests/gpu/render_support.h"

namespace {

using core::Vector3f;
using test::AnalyticScene;

kernel::vec4 texel(const core::DepthLayers::Patch& patch) { return {patch.w, patch.gu, patch.gv, 0}; }

struct Scene {
    explicit Scene(const AnalyticScene& source,
                   std::uint64_t maxPyramidCells = std::numeric_limits<std::uint64_t>::max())
        : layers(source.layers()), geometry(test::device(), maxPyramidCells) {
        geometry.setLayers(layers, source.photo->color, *source.front, *source.back);
        geometry.setEnvironment(*source.environment);
        const gpu::CommandEncoder encoder = test::device().createCommandEncoder({.label = "pyramid"});
        geometry.record(encoder);
        test::device().queue().submit(encoder.finish());
    }
    std::vector<render::RayHit> march(const std::vector<render::Ray>& rays) {
        render::RayMarcher marcher(test::device(), geometry);
        return marcher.march(rays, render::MarchMethod::Pyramid);
    }
    core::DepthLayers layers;
    render::SceneGeometry geometry;
};

/// Rays from lifted surface points into the upper hemisphere, from free points, and towards the camera.
std::vector<render::Ray> randomRays(const AnalyticScene& scene, int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    const core::Camera& camera = scene.photo->camera;
    std::vector<render::Ray> rays;
    while (rays.size() < static_cast<std::size_t>(count)) {
        Vector3f direction = test::randomDirection(random);
        if (rays.size() % 4 == 3) {
            const float z = 0.3f + 2 * uniform(random);
            rays.push_back({camera.ray(uniform(random) * static_cast<float>(camera.width),
                                       uniform(random) * static_cast<float>(camera.height)) *
                                z,
                            direction});
            continue;
        }
        const int x = static_cast<int>(uniform(random) * static_cast<float>(camera.width - 1));
        const int y = static_cast<int>(uniform(random) * static_cast<float>(camera.height - 1));
        const float z = scene.front->depth(x, y);
        if (z <= 0) continue;
        const Vector3f& n = scene.front->normal(x, y);
        if (direction.dot(n) < 0) direction -= 2 * direction.dot(n) * n;
        rays.push_back({camera.backProject(x, y, z) + n * core::marchBias(camera, z), direction});
    }
    return rays;
}

/// Share of rays on which kernel and oracle agree about the pixel, the layer and (within 0.1 %) the distance.
double agreement(const core::DepthLayers& layers, const std::vector<render::Ray>& rays,
                 const std::vector<render::RayHit>& hits, std::size_t* hitCount = nullptr) {
    std::size_t agreed = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto expected = core::march(layers, rays[i].origin, rays[i].direction);
        if (hitCount != nullptr && expected) ++*hitCount;
        if (!expected) {
            agreed += !hits[i].found;
        } else if (hits[i].found && hits[i].x == expected->x && hits[i].y == expected->y &&
                   hits[i].back == expected->back &&
                   std::abs(hits[i].distance - expected->distance) <= 1e-3f * expected->distance + 1e-4f) {
            ++agreed;
        }
    }
    return static_cast<double>(agreed) / static_cast<double>(rays.size());
}

TEST(Pyramid, HoldsTheRangesOfItsCellsOnAnySize) {
    for (const auto& [width, height] : {std::pair{64, 64}, std::pair{97, 61}, std::pair{5, 130}, std::pair{1, 1}}) {
        const AnalyticScene source = test::randomSpheres(width, height, 3);
        const Scene scene(source);
        const render::PyramidShape& shape = scene.geometry.pyramidShape();
        ASSERT_EQ(shape.finest, 0u);
        ASSERT_GE(1 << shape.top, std::max(width, height)) << "the top is a single cell";
        const auto [minW, maxW] = scene.geometry.rangeOfW();
        const float scale = kernel::rangeScale(minW, maxW);
        const auto cells = gpu::readTexture<kernel::uint>(test::device(), scene.geometry.pyramid());
        ASSERT_GE(cells.size(), shape.cells());
        for (std::uint32_t level = 0; level <= shape.top; ++level) {
            const int size = 1 << level;
            for (int cy = 0; cy * size < height; ++cy) {
                for (int cx = 0; cx * size < width; ++cx) {
                    kernel::vec2 expected(kernel::kEmptyRangeMin, kernel::kEmptyRangeMax);
                    for (int y = cy * size; y < std::min((cy + 1) * size, height); ++y)
                        for (int x = cx * size; x < std::min((cx + 1) * size, width); ++x) {
                            const kernel::vec2 range =
                                kernel::pixelRange(texel(scene.layers.front(x, y)), texel(scene.layers.back(x, y)));
                            expected = {std::min(expected.x, range.x), std::max(expected.y, range.y)};
                        }
                    const kernel::uint cell = cells[kernel::pyramidIndex(
                        static_cast<kernel::uint>(cx), static_cast<kernel::uint>(cy), level, shape.rows, shape.blocks)];
                    const std::string where = std::to_string(width) + "x" + std::to_string(height) + " level " +
                                              std::to_string(level) + " cell " + std::to_string(cx) + ", " +
                                              std::to_string(cy);
                    if (expected.x > expected.y) {
                        ASSERT_EQ(cell, kernel::kEmptyCell) << where;
                        continue;
                    }
                    const float low = (expected.x - minW) * scale + kernel::kRangeStart;
                    const float high = (expected.y - minW) * scale + kernel::kRangeStart;
                    ASSERT_NEAR(static_cast<float>(cell & 0xffffu), low - 2.5f, 0.6f) << where;
                    ASSERT_NEAR(static_cast<float>(cell >> 16u), high + 2.5f, 0.6f) << where;
                }
            }
        }
    }
}

TEST(Pyramid, DropsItsFinestLevelsWhenTheDeviceHoldsNoMore) {
    EXPECT_EQ(render::pyramidShape(4096, 4096, 1ull << 40).finest, 0u);
    for (const std::uint64_t maxCells : {1ull << 25, 1ull << 23, 1ull << 12}) {
        const render::PyramidShape shape = render::pyramidShape(4096, 3000, maxCells);
        EXPECT_LE(shape.cells(), maxCells);
        EXPECT_GE(shape.top, shape.finest);
        EXPECT_EQ(shape.blocks, 1024u >> shape.finest);
        EXPECT_GT(render::pyramidShape(4096, 3000, shape.cells() - 1).finest, shape.finest);
        const kernel::uint step = shape.top - shape.finest;
        EXPECT_EQ(shape.rows >> step << step, shape.rows);
        EXPECT_LT(kernel::pyramidIndex((4095u >> shape.top), (2999u >> shape.top), step, shape.rows, shape.blocks),
                  shape.cells());
    }
}

TEST(March, AgreesWithTheOracleOnRandomScenes) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const AnalyticScene source = test::randomSpheres(211 + 30 * static_cast<int>(seed), 157, seed);
        Scene scene(source);
        const auto rays = randomRays(source, 20000, seed);
        std::size_t hits = 0;
        EXPECT_GE(agreement(scene.layers, rays, scene.march(rays), &hits), 0.999) << "seed " << seed;
        EXPECT_GT(hits, rays.size() / 20) << "the rays must meet something for the test to mean anything";
    }
}

TEST(March, AgreesWithTheOracleWithoutTheFinestLevelsOfThePyramid) {
    const AnalyticScene source = test::randomSpheres(97, 61, 5);
    for (const std::uint64_t cells : {3000u, 800u, 256u}) {
        Scene scene(source, cells);
        ASSERT_GT(scene.geometry.pyramidShape().finest, 0u);
        const std::vector<render::Ray> rays = randomRays(source, 4000, 3);
        std::size_t hitCount = 0;
        EXPECT_GE(agreement(scene.layers, rays, scene.march(rays), &hitCount), 0.999)
            << scene.geometry.pyramidShape().finest;
        EXPECT_GT(hitCount, 400u);
    }
}

TEST(March, HitsASphereWhereTheMathsSays) {
    const Vector3f center(0, 0, 1);
    const float radius = 0.2f;
    const AnalyticScene source =
        test::spheresOnFloor(400, 300, {{center, radius, 2}}, 0, [](const Vector3f&) { return Vector3f(1, 1, 1); });
    Scene scene(source);
    std::mt19937 random(5);
    std::vector<render::Ray> rays;
    std::vector<double> expected;  // distance, < 0 = misses
    while (rays.size() < 4000) {
        // From a point beside the sphere, inside the view cone, towards a random point around it.
        const Vector3f origin = Vector3f(0, 0, 1) + 0.33f * test::randomDirection(random);
        if (std::abs(origin.x()) > 0.28f * origin.z() || std::abs(origin.y()) > 0.2f * origin.z()) continue;
        const Vector3f target = center + 0.3f * test::randomDirection(random);
        const Vector3f d = (target - origin).normalized();
        const Eigen::Vector3d o = (origin - center).cast<double>();
        const double b = o.dot(d.cast<double>());
        const double root = b * b - (o.squaredNorm() - double{radius} * radius);
        const double closest = std::sqrt(o.squaredNorm() - b * b);
        if (std::abs(closest - double{radius}) < 0.02) continue;  // grazing rays depend on the pixels of the outline
        rays.push_back({origin, d});
        expected.push_back(root > 0 && b < 0 ? -b - std::sqrt(root) : -1.0);
    }
    const auto hits = scene.march(rays);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].found != (expected[i] > 0))
            ++wrong;
        else if (hits[i].found && std::abs(double{hits[i].distance} - expected[i]) > 0.01)
            ++wrong;
    }
    // In a band of pixels along the outline the two halves meet in a step.
    EXPECT_LE(wrong, rays.size() / 100);
}

TEST(March, SurvivesDegenerateRays) {
    const AnalyticScene source = test::randomSpheres(128, 96, 9);
    Scene scene(source);
    const core::Camera& camera = source.photo->camera;
    const float nan = std::nanf("");
    std::vector<render::Ray> rays = {
        {{0, 0, 0.5f}, {0, 0, 1}},         // along the view direction, away from the camera
        {{0, 0, 3.0f}, {0, 0, -1}},        // towards the camera: w grows without limit
        {camera.ray(64, 48), {1, 0, 0}},   // axis-parallel on a cell border
        {camera.ray(64, 48), {0, -1, 0}},  // the other axis
        {camera.ray(32, 32) * 2, {0, 0, 1}},
        {camera.ray(0, 0), Vector3f(1, 1, 0).normalized()},  // from the corner along the diagonal
        {camera.ray(-5, 10), {1, 0, 0}},                     // starts outside the image
        {{0, 0, -1}, {0, 0, 1}},                             // behind the camera
        {{0, 0, 1}, {nan, 0, 1}},
        {{nan, 0, 1}, {0, 0, 1}},
        {{0, 0, 1}, {0, 0, 0}},
        {{0, 0, 1e-30f}, {0, 0, 1}},
        {{0, 0, 1e30f}, {0, 0, -1}},
    };
    const auto hits = scene.march(rays);
    for (std::size_t i = 0; i < 8; ++i) {
        const auto expected = core::march(scene.layers, rays[i].origin, rays[i].direction);
        EXPECT_EQ(hits[i].found, expected.has_value()) << "ray " << i;
        if (expected && hits[i].found) {
            EXPECT_NEAR(hits[i].distance, expected->distance, 1e-3f) << "ray " << i;
        }
    }
    for (std::size_t i = 8; i < rays.size(); ++i)
        EXPECT_TRUE(!hits[i].found || std::isfinite(hits[i].distance)) << "ray " << i;
}

/// Rays with distant hits among rays that end at once, in an order that does not repeat with any workgroup's share.
std::vector<render::Ray> unevenRays(const AnalyticScene& source, int count) {
    std::vector<render::Ray> rays = randomRays(source, count, 11);
    std::mt19937 random(12);
    for (render::Ray& ray : rays) {
        switch (random() % 4) {
            case 0:
                ray.direction.setZero();
                break;
            case 1:
                ray.origin = {0, 0, -1};  // behind the camera
                break;
            default:
                break;
        }
    }
    return rays;
}

TEST(March, EndsEveryRayOfALongList) {
    const AnalyticScene source = test::randomSpheres(211, 157, 2);
    Scene scene(source);
    // More than all workgroups take at once, and a multiple of no block size.
    const auto rays = unevenRays(source, 200003);
    const auto hits = scene.march(rays);
    std::size_t oracleHits = 0;
    std::vector<render::Ray> marched;
    std::vector<render::RayHit> marchedHits;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (rays[i].direction.isZero() || rays[i].origin.z() < 0) {
            ASSERT_FALSE(hits[i].found) << "ray " << i;
        } else if (i % 5 == 0 || i + 1000 > rays.size()) {
            marched.push_back(rays[i]);
            marchedHits.push_back(hits[i]);
        }
    }
    EXPECT_GE(agreement(scene.layers, marched, marchedHits, &oracleHits), 0.999);
    EXPECT_GT(oracleHits, marched.size() / 20);
}

TEST(March, GivesEachRayItsHitWhateverTheLengthOfTheList) {
    const AnalyticScene source = test::randomSpheres(128, 96, 4);
    Scene scene(source);
    const auto rays = unevenRays(source, 3000);
    const auto all = scene.march(rays);
    ASSERT_TRUE(std::any_of(all.begin(), all.end(), [](const render::RayHit& hit) { return hit.found; }));
    for (const std::size_t count : {1u, 7u, 64u, 65u, 127u, 128u, 129u, 511u, 512u, 513u, 2999u}) {
        const auto hits = scene.march({rays.end() - static_cast<std::ptrdiff_t>(count), rays.end()});
        ASSERT_EQ(hits.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            const render::RayHit& expected = all[rays.size() - count + i];
            ASSERT_EQ(hits[i].found, expected.found) << "ray " << i << " of " << count;
            ASSERT_EQ(hits[i].x, expected.x) << "ray " << i << " of " << count;
            ASSERT_EQ(hits[i].y, expected.y) << "ray " << i << " of " << count;
            ASSERT_EQ(hits[i].back, expected.back) << "ray " << i << " of " << count;
            ASSERT_EQ(hits[i].distance, expected.distance) << "ray " << i << " of " << count;
        }
    }
}

/// Label 2.
AnalyticScene lonelySphere() {
    return test::spheresOnFloor(200, 150, {{Vector3f(0, 0, 1), 0.2f, 2}}, 0,
                                [](const Vector3f&) { return Vector3f(1, 1, 1); });
}

TEST(March, LeavesOutWhatTheListIsMarchedWithout) {
    const AnalyticScene source = lonelySphere();
    Scene scene(source);
    const auto rays = randomRays(source, 4000, 7);
    render::RayMarcher marcher(test::device(), scene.geometry);
    const auto isSphere = [&](const render::RayHit& hit) {
        return hit.found && scene.layers.labels(hit.x, hit.y) == 2;
    };
    const auto with = marcher.march(rays, render::MarchMethod::Pyramid);
    const auto without = marcher.march(rays, render::MarchMethod::Pyramid, {}, 2);
    EXPECT_TRUE(std::any_of(with.begin(), with.end(), isSphere));
    EXPECT_FALSE(std::any_of(without.begin(), without.end(), isSphere));
}

TEST(March, ConstantStepsAgreeOnThickSolids) {
    const AnalyticScene source = lonelySphere();
    Scene scene(source);
    const auto rays = randomRays(source, 4000, 7);
    render::RayMarcher marcher(test::device(), scene.geometry);
    const auto exact = marcher.march(rays, render::MarchMethod::Pyramid);
    const auto steps = marcher.march(rays, render::MarchMethod::ConstantSteps, {.stepSize = 0.0005f, .maxDistance = 1});
    std::size_t same = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) same += exact[i].found == steps[i].found;
    EXPECT_GE(static_cast<double>(same), 0.99 * static_cast<double>(rays.size()));
}

}  // namespace
