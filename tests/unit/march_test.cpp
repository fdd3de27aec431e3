// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/geometry/depth_layers.h"
#include "core/geometry/march.h"
#include "tests/support/ray_scene.h"

namespace {

using core::Camera;
using core::DepthLayers;
using core::MarchHit;
using core::Vector3f;
using test::Vector3d;

/// Depth below the front and above the back plane of the pixel under `p`, in w; nullopt off the image or over an empty
/// pixel. Straight from the definition, with no ray in it.
std::optional<std::pair<double, double>> roomAt(const DepthLayers& layers, const Vector3d& p) {
    const Camera& c = layers.camera;
    if (p.z() <= 0) return std::nullopt;
    const double u = c.fx * p.x() / p.z() + c.cx;
    const double v = c.fy * p.y() / p.z() + c.cy;
    const int x = static_cast<int>(std::floor(u));
    const int y = static_cast<int>(std::floor(v));
    if (!layers.front.contains(x, y) || layers.front(x, y).w <= 0) return std::nullopt;
    const auto value = [&](const DepthLayers::Patch& patch) {
        return patch.w + patch.gu * (u - x - 0.5) + patch.gv * (v - y - 0.5);
    };
    return std::pair{value(layers.front(x, y)) - 1 / p.z(), 1 / p.z() - value(layers.back(x, y))};
}

bool isInside(const DepthLayers& layers, const Vector3d& p, double margin) {
    const auto room = roomAt(layers, p);
    return room && room->first >= margin && room->second >= margin;
}

DepthLayers layersOf(const test::RayScene& scene) {
    return core::buildDepthLayers(scene.camera, scene.photograph().labels, scene.frontSurface(), scene.backSurface());
}

struct Ray {
    Vector3f origin, direction;
    std::uint16_t label;
    Vector3f normal;
};

/// Rays from random surface points, lifted by the bias, into random directions of their upper half space.
std::vector<Ray> surfaceRays(const test::RayScene& scene, int count, unsigned seed) {
    const core::Surface front = scene.frontSurface();
    const core::Photo photo = scene.photograph();
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> anyX(0, scene.camera.width - 1);
    std::uniform_int_distribution<int> anyY(0, scene.camera.height - 1);
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < count) {
        const int x = anyX(random);
        const int y = anyY(random);
        if (front.depth(x, y) <= 0) continue;
        Vector3f d = test::randomDirection(random);
        const Vector3f& n = front.normal(x, y);
        if (d.dot(n) < 0) d = -d;
        rays.push_back(
            {front.position(x, y) + core::marchBias(scene.camera, front.depth(x, y)) * n, d, photo.labels(x, y), n});
    }
    return rays;
}

TEST(March, PlaneAcrossTheImageIsHitWhereGeometrySays) {
    test::RayScene scene;
    scene.camera = test::testCamera();
    scene.objects.push_back(
        {1, std::make_shared<test::Box>(Vector3d(0, 0, 2.5), Vector3d(9, 9, 0.5), test::rotation(0.4, {1, 2, 0})), {}});
    const DepthLayers layers = layersOf(scene);
    std::mt19937 random(5);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vector3f origin(0.1f, -0.05f, 0.7f);
        const Vector3f d = test::randomDirection(random);
        const auto truth = scene.trace(origin.cast<double>(), d.cast<double>());
        const auto hit = core::march(layers, origin, d);
        if (!hit) continue;
        ++hits;
        ASSERT_TRUE(truth);
        EXPECT_NEAR(hit->distance, truth->t, 2e-3 * truth->t);
        EXPECT_FALSE(hit->back);
        const Eigen::Vector2f uv = scene.camera.project(origin + hit->distance * d);
        EXPECT_NEAR(uv.x(), static_cast<float>(hit->x) + 0.5f, 0.51f);
        EXPECT_NEAR(uv.y(), static_cast<float>(hit->y) + 0.5f, 0.51f);
    }
    EXPECT_GT(hits, 100);
}

TEST(March, EveryHitIsTheFirstSolidOnTheRay) {
    const test::RayScene scene = test::stillLife(test::testCamera());
    const DepthLayers layers = layersOf(scene);
    int hits = 0;
    for (const Ray& ray : surfaceRays(scene, 1500, 7)) {
        const auto hit = core::march(layers, ray.origin, ray.direction);
        const Vector3d o = ray.origin.cast<double>();
        const Vector3d d = ray.direction.cast<double>();
        const double end = hit ? hit->distance : 4.0;
        // Tiny steps up to the hit: after the ray has been outside once, no step lies inside a solid.
        bool escaped = false;
        for (double t = 0; t < end * (1 - 1e-4); t += 2e-4) {
            const Vector3d p = o + t * d;
            if (p.z() <= 0) break;
            escaped = escaped || !isInside(layers, p, 0);
            ASSERT_FALSE(escaped && isInside(layers, p, 1e-5)) << "passed a solid at " << t << " of " << end;
        }
        if (!hit) continue;
        ++hits;
        EXPECT_TRUE(isInside(layers, o + (hit->distance * (1 + 1e-6) + 1e-7) * d, -1e-4));
        const auto room = roomAt(layers, o + (hit->distance + 1e-7) * d);
        if (room && std::abs(room->first - room->second) > 1e-4) {
            EXPECT_EQ(hit->back, room->second < room->first);
        }
    }
    EXPECT_GT(hits, 200);
}

TEST(March, AgreesWithTracingTheTrueShapes) {
    const test::RayScene scene = test::stillLife(test::testCamera(320, 240));
    const DepthLayers layers = layersOf(scene);
    int agree = 0;
    int judged = 0;
    for (const Ray& ray : surfaceRays(scene, 4000, 9)) {
        // Grazing the own surface is decided by less than a pixel.
        if (ray.direction.dot(ray.normal) < 0.05f) continue;
        const auto truth = scene.trace(ray.origin.cast<double>(), ray.direction.cast<double>());
        // The photograph ends at its border, and does not show what lies behind things.
        if (truth) {
            const Vector3f p = ray.origin + static_cast<float>(truth->t) * ray.direction;
            const Eigen::Vector2f uv = scene.camera.project(p);
            const auto x = static_cast<int>(uv.x());
            const auto y = static_cast<int>(uv.y());
            if (p.z() <= 0 || uv.minCoeff() < 0 || !layers.labels.contains(x, y)) continue;
            if (layers.labels(x, y) != truth->object->label) continue;
        }
        ++judged;
        const auto hit = core::march(layers, ray.origin, ray.direction);
        if (hit.has_value() != truth.has_value()) continue;
        if (!hit || (layers.labels(hit->x, hit->y) == truth->object->label &&
                     std::abs(hit->distance - truth->t) < 0.02 * truth->t + 0.004))
            ++agree;
    }
    EXPECT_GT(judged, 2000);
    EXPECT_GT(agree, 0.97 * judged);
}

TEST(March, ConvexSurfacesDoNotHitThemselves) {
    const test::RayScene scene = test::stillLife(test::testCamera(320, 240));
    const DepthLayers layers = layersOf(scene);
    const core::Surface front = scene.frontSurface();
    std::mt19937 random(21);
    int rays = 0;
    int selfHits = 0;
    scene.forEachPixel([&](int x, int y, const Vector3d&) {
        if (layers.labels(x, y) != 2) return;
        const Vector3f& n = front.normal(x, y);
        const Vector3f origin = front.position(x, y) + core::marchBias(scene.camera, front.depth(x, y)) * n;
        for (int k = 0; k < 4; ++k) {
            Vector3f d = test::randomDirection(random);
            if (d.dot(n) < 0) d = -d;
            ++rays;
            const auto hit = core::march(layers, origin, d);
            if (hit && layers.labels(hit->x, hit->y) == 2) ++selfHits;
        }
    });
    EXPECT_GT(rays, 1000);
    EXPECT_LT(selfHits, 0.005 * rays);
}

struct SlabTest : testing::Test {
    /// One pixel column of solid between z = 1 and z = 2 in the middle of an otherwise empty 9×9 picture.
    SlabTest() {
        layers.camera = {9, 9, 9, 9, 4.5f, 4.5f};
        layers.front = core::Image<DepthLayers::Patch>(9, 9);
        layers.back = layers.front;
        layers.labels = core::LabelImage(9, 9);
        layers.front(4, 4) = {1.0f, 0, 0};
        layers.back(4, 4) = {0.5f, 0, 0};
        layers.labels(4, 4) = 3;
    }
    DepthLayers layers;
};

TEST_F(SlabTest, FrontBackAndSides) {
    const auto front = core::march(layers, {0, 0, 0.5f}, {0, 0, 1});
    ASSERT_TRUE(front);
    EXPECT_FALSE(front->back);
    EXPECT_NEAR(front->distance, 0.5f, 1e-6f);

    const auto back = core::march(layers, {0, 0, 3}, {0, 0, -1});
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->back);
    EXPECT_NEAR(back->distance, 1, 1e-6f);

    // From the side at z = 1.1 (w = 0.909, nearer to the front's 1 than to the back's 0.5) and at z = 1.8.
    const auto nearSide = core::march(layers, {-0.4f, 0, 1.1f}, {1, 0, 0});
    ASSERT_TRUE(nearSide);
    EXPECT_FALSE(nearSide->back);
    EXPECT_NEAR(nearSide->distance, 0.4f - 1.1f / 18, 1e-5f);
    const auto farSide = core::march(layers, {-0.4f, 0, 1.8f}, {1, 0, 0});
    ASSERT_TRUE(farSide);
    EXPECT_TRUE(farSide->back);
    EXPECT_EQ(farSide->x, 4);
    EXPECT_EQ(farSide->y, 4);
}

TEST_F(SlabTest, MissesInFrontBehindAndBeside) {
    EXPECT_FALSE(core::march(layers, {-0.3f, 0, 0.9f}, {1, 0, 0}));
    EXPECT_FALSE(core::march(layers, {-0.4f, 0, 2.2f}, {1, 0, 0}));
    EXPECT_FALSE(core::march(layers, {-0.4f, 0.2f, 1.1f}, {1, 0, 0}));
    EXPECT_FALSE(core::march(layers, {0, 0, 0.5f}, {0, 0, -1}));
}

TEST_F(SlabTest, OriginInsideMustLeaveFirst) {
    EXPECT_FALSE(core::march(layers, {0, 0, 1.5f}, {0, 0, 1}));
    EXPECT_FALSE(core::march(layers, {0, 0, 1.5f}, {0, 0, -1}));
    // Leaving through a side into another solid without a gap is still leaving: the neighbour does not count either.
    layers.front(5, 4) = {1.0f, 0, 0};
    layers.back(5, 4) = {0.5f, 0, 0};
    EXPECT_FALSE(core::march(layers, {0, 0, 1.5f}, {1, 0, 0}));
    // A gap in between makes the next solid a hit.
    layers.front(5, 4) = {};
    layers.front(6, 4) = {1.0f, 0, 0};
    layers.back(6, 4) = {0.5f, 0, 0};
    const auto hit = core::march(layers, {0, 0, 1.5f}, {1, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->x, 6);
    EXPECT_NEAR(hit->distance, 1.5f / 9 * 1.5f, 1e-5f);
}

TEST_F(SlabTest, RaysFromBesideTheImageEnterIt) {
    const auto hit = core::march(layers, {-2, 0, 1.5f}, {1, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->x, 4);
    EXPECT_FALSE(core::march(layers, {-2, 0, 1.5f}, {-1, 0, 0}));
    EXPECT_FALSE(core::march(layers, {0, 0, -1}, {0, 0, 1}));
}

TEST(DepthLayers, PlanesAreExactAndContinuous) {
    test::RayScene scene;
    scene.camera = test::testCamera(64, 48);
    scene.objects.push_back(
        {1, std::make_shared<test::Box>(Vector3d(0, 0, 2), Vector3d(9, 9, 0.3), test::rotation(0.9, {1, 0.3, 0})), {}});
    const DepthLayers layers = layersOf(scene);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x + 1 < 64; ++x)
            EXPECT_NEAR(layers.front(x, y).at(0.5f, 0), layers.front(x + 1, y).at(-0.5f, 0),
                        1e-5f * layers.front(x, y).w);
}

TEST(DepthLayers, AWrongNormalRaisesNoSpike) {
    const test::RayScene scene = test::stillLife(test::testCamera());
    core::Surface front = scene.frontSurface();
    const core::Surface back = scene.backSurface();
    const core::LabelImage labels = scene.photograph().labels;
    std::mt19937 random(2);
    for (std::size_t i = 0; i < front.normal.size(); ++i)
        if (random() % 10 == 0) front.normal[i] = Vector3f(0.999f, 0, -0.04f).normalized();
    const DepthLayers layers = core::buildDepthLayers(scene.camera, labels, front, back);
    for (std::size_t i = 0; i < front.depth.size(); ++i) {
        const auto& patch = layers.front[i];
        if (front.depth[i] <= 0) {
            EXPECT_EQ(patch.w, 0);
            continue;
        }
        for (const float du : {-0.5f, 0.5f}) {
            for (const float dv : {-0.5f, 0.5f}) {
                EXPECT_GT(layers.back[i].at(du, dv), 0);
                EXPECT_LE(layers.back[i].at(du, dv), patch.at(du, dv) * (1 + 1e-5f));
                if (labels[i] == 1) {
                    EXPECT_NEAR(patch.at(du, dv) / patch.w, 1, 0.05f);
                }
            }
        }
    }
}

TEST(DepthLayers, JaggedDepthOfASteepPlaneDoesNotShadeItself) {
    test::RayScene scene;
    scene.camera = test::testCamera(64, 48);
    scene.objects.push_back(
        {1,
         std::make_shared<test::Box>(Vector3d(0, 0, 0.6), Vector3d(9, 9, 0.1), test::rotation(1.1, {1, 0.1, 0})),
         {}});
    core::Surface front = scene.frontSurface();
    // Rows are off by most of the plane's own step; its normal is known all the same, as a fit over them gives
    // it.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> error(-0.8f, 0.8f);
    for (int y = 0; y < 48; ++y) {
        const float part = error(random);
        for (int x = 0; x < 64; ++x) {
            if (front.depth(x, y) <= 0) continue;
            const Vector3f& n = front.normal(x, y);
            const float step = front.depth(x, y) / scene.camera.fy * n.y() / n.z();
            front.depth(x, y) += part * step;
            front.position(x, y) = scene.camera.backProject(x, y, front.depth(x, y));
        }
    }
    const core::LabelImage labels = scene.photograph().labels;
    const DepthLayers layers = core::buildDepthLayers(scene.camera, labels, front, scene.backSurface());
    int dark = 0, count = 0;
    for (int y = 2; y < 46; ++y) {
        for (int x = 2; x < 62; ++x) {
            const Vector3f& n = front.normal(x, y);
            const Vector3f origin = front.position(x, y) + core::marchBias(scene.camera, front.depth(x, y)) * n;
            int blocked = 0;
            for (int k = 0; k < 16; ++k) {
                const float angle = static_cast<float>(k) * std::numbers::pi_v<float> / 8;
                const Vector3f across = n.unitOrthogonal();
                const Vector3f side = std::cos(angle) * across + std::sin(angle) * n.cross(across);
                if (core::march(layers, origin, (n + side).normalized())) ++blocked;
            }
            ++count;
            if (blocked > 8) ++dark;
        }
    }
    std::printf("jagged steep plane: %d of %d pixels shaded by their neighbours\n", dark, count);
    EXPECT_LT(dark, count / 100);
}

TEST(MarchPyramid, HitsWhatTheMarchThroughEveryPixelHits) {
    const test::RayScene scene = test::stillLife(test::testCamera(333, 241));
    const DepthLayers layers = layersOf(scene);
    const core::MarchPyramid pyramid(layers);
    std::vector<Ray> rays = surfaceRays(scene, 20000, 11);
    // Rays from anywhere in and around the picture, in all directions.
    std::mt19937 random(12);
    std::uniform_real_distribution<float> side(-0.6f, 0.6f);
    std::uniform_real_distribution<float> away(0.1f, 3.0f);
    for (int i = 0; i < 20000; ++i)
        rays.push_back({{side(random), side(random), away(random)}, test::randomDirection(random), 0, {0, 0, 0}});
    // Along the axes, where a ray never leaves its row or column.
    for (const Vector3f& d : {Vector3f(1, 0, 0), Vector3f(0, -1, 0), Vector3f(0, 0, 1), Vector3f(0, 0, -1)})
        for (int i = 0; i < 500; ++i) rays.push_back({{side(random), side(random), away(random)}, d, 0, {0, 0, 0}});
    int hits = 0;
    int different = 0;
    for (const Ray& ray : rays) {
        const auto expected = core::march(layers, ray.origin, ray.direction);
        const auto found = pyramid.march(ray.origin, ray.direction);
        hits += expected ? 1 : 0;
        if (expected.has_value() != found.has_value()) {
            ++different;
        } else if (expected) {
            different += expected->x != found->x || expected->y != found->y || expected->back != found->back;
        }
    }
    EXPECT_GT(hits, 4000);
    EXPECT_LE(different, 4) << "of " << rays.size();
}

TEST(MarchPyramid, LeavesOutASegment) {
    const test::RayScene scene = test::stillLife(test::testCamera(160, 120));
    const DepthLayers layers = layersOf(scene);
    DepthLayers without = layers;
    for (std::size_t i = 0; i < without.front.size(); ++i)
        if (without.labels[i] == 2) without.front[i] = {};
    const core::MarchPyramid pyramid(layers, 2);
    int hits = 0;
    for (const Ray& ray : surfaceRays(scene, 5000, 13)) {
        const auto expected = core::march(without, ray.origin, ray.direction);
        const auto found = pyramid.march(ray.origin, ray.direction);
        ASSERT_EQ(expected.has_value(), found.has_value());
        if (!expected) continue;
        ++hits;
        EXPECT_NE(layers.labels(found->x, found->y), 2);
        EXPECT_EQ(expected->x, found->x);
        EXPECT_EQ(expected->y, found->y);
    }
    EXPECT_GT(hits, 300);
}

TEST(MarchBias, IsHalfAPixel) {
    const Camera camera{100, 100, 200, 200, 50, 50};
    EXPECT_FLOAT_EQ(core::marchBias(camera, 2.0f), 0.5f * 2.0f / 200);
}

}  // namespace
