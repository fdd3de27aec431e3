// SPDX-License-Identifier: GPL-3.0-or-later
// The invented back side (docs/method.md#back-side) against solids whose back is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/analysis/back/back_side.h"
#include "core/analysis/back/mirror_plane.h"
#include "core/analysis/segment/support_planes.h"
#include "tests/support/ray_scene.h"

namespace {

using core::BackSideMethod;
using core::Vector3f;
using core::analysis::BackLayer;
using test::Vector3d;

struct BackSide : testing::Test {
    static core::BackSideParams with(BackSideMethod method) {
        core::BackSideParams params;
        params.method = method;
        return params;
    }
    static BackLayer invent(const test::RayScene& scene, const core::BackSideParams& params,
                            const core::ImageF* userDepth = nullptr) {
        const core::Photo photo = scene.photograph();
        std::vector<core::Segment> segments;
        for (const test::SceneObject& object : scene.objects) {
            core::Segment segment;
            segment.label = object.label;
            segment.backSide = params;
            segments.push_back(segment);
        }
        core::Surface front = scene.frontSurface();
        return core::analysis::inventBackSide(scene.camera, photo.labels, front, segments, userDepth, 0, {});
    }
    /// Median |z_back − truth| over the median true thickness.
    static float relativeError(const test::RayScene& scene, const BackLayer& back, std::uint16_t label) {
        const core::Photo photo = scene.photograph();
        const core::Surface truth = scene.backSurface();
        std::vector<float> errors;
        std::vector<float> thickness;
        for (std::size_t i = 0; i < photo.depth.size(); ++i) {
            if (photo.labels[i] != label) continue;
            errors.push_back(std::abs(back.surface.depth[i] - truth.depth[i]));
            thickness.push_back(truth.depth[i] - photo.depth[i]);
        }
        std::ranges::sort(errors);
        std::ranges::sort(thickness);
        return errors[errors.size() / 2] / thickness[thickness.size() / 2];
    }
    static void expectThick(const test::RayScene& scene, const BackLayer& back, float minThickness) {
        const core::Photo photo = scene.photograph();
        for (int y = 0; y < photo.depth.height(); ++y) {
            for (int x = 0; x < photo.depth.width(); ++x) {
                const float z = photo.depth(x, y);
                if (z <= 0) {
                    EXPECT_EQ(back.surface.depth(x, y), 0);
                    EXPECT_EQ(back.surface.area(x, y), 0);
                    continue;
                }
                EXPECT_GE(back.surface.depth(x, y), z + minThickness * 0.999f);
                EXPECT_NEAR(back.surface.normal(x, y).norm(), 1, 1e-4f);
                EXPECT_GT(back.surface.normal(x, y).dot(photo.camera.pixelRay(x, y)), 0);
                EXPECT_GT(back.surface.area(x, y), 0);
                EXPECT_TRUE(back.surface.color(x, y).allFinite());
            }
        }
    }
    /// Seen through a long lens: from near by, less than half of a sphere is visible, and its mirror image is thinner.
    static test::RayScene sphere(const Vector3d& center = Vector3d(0, 0, 4)) {
        test::RayScene scene;
        scene.camera = core::Camera::fromHorizontalFov(240, 180, 0.18f);
        scene.objects.push_back({4, std::make_shared<test::Sphere>(center, 0.2), {}});
        return scene;
    }
    /// A box seen edge on: symmetric to the plane through its two side edges.
    static test::RayScene box() {
        test::RayScene scene;
        scene.camera = test::testCamera(240, 180);
        scene.objects.push_back({4,
                                 std::make_shared<test::Box>(Vector3d(0, 0, 1.2), Vector3d(0.15, 0.2, 0.15),
                                                             test::rotation(0.785398, {0, 1, 0})),
                                 {}});
        return scene;
    }
};

TEST_F(BackSide, SphereIsClosedByBothMirrors) {
    // The parallel plane stands at a percentile of the outline, so a sphere comes out a little short.
    for (const auto& [method, tolerance] :
         {std::pair{BackSideMethod::ParallelMirror, 0.2f}, std::pair{BackSideMethod::PcaMirror, 0.12f}}) {
        const test::RayScene scene = sphere();
        const BackLayer back = invent(scene, with(method));
        EXPECT_LT(relativeError(scene, back, 4), tolerance);
        ASSERT_EQ(back.segments.size(), 1u);
        EXPECT_EQ(back.segments[0].used, method);
        EXPECT_EQ(back.segments[0].note, "");
        expectThick(scene, back, 0.002f);
    }
}

TEST_F(BackSide, SphereOffTheAxis) {
    const test::RayScene scene = sphere({0.12, 0.05, 4});
    EXPECT_LT(relativeError(scene, invent(scene, with(BackSideMethod::PcaMirror)), 4), 0.2f);
}

TEST_F(BackSide, BackNormalsOfTheSphere) {
    const test::RayScene scene = sphere();
    const BackLayer back = invent(scene, with(BackSideMethod::PcaMirror));
    const core::Surface truth = scene.backSurface();
    std::vector<float> cosines;
    for (std::size_t i = 0; i < truth.depth.size(); ++i)
        if (truth.depth[i] > 0) cosines.push_back(truth.normal[i].dot(back.surface.normal[i]));
    std::ranges::sort(cosines);
    EXPECT_GT(cosines[cosines.size() / 2], 0.98f);
}

TEST_F(BackSide, BoxSeenEdgeOn) {
    const test::RayScene scene = box();
    const BackLayer back = invent(scene, with(BackSideMethod::PcaMirror));
    EXPECT_LT(relativeError(scene, back, 4), 0.15f);
    EXPECT_LT(back.segments[0].mirrorError, 0.1f);
    expectThick(scene, back, 0.002f);
}

TEST_F(BackSide, NormalIsMostSimilarAxis) {
    // A long, tilted slab of points: its largest axis lies across the view, the one most parallel to the view is
    // another.
    std::mt19937 random(8);
    std::normal_distribution<float> normal;
    const Eigen::Matrix3f axes = test::rotation(0.3, {0, 1, 0}).cast<float>();
    std::vector<Vector3f> points;
    for (int i = 0; i < 4000; ++i)
        points.push_back(axes * Vector3f(normal(random), 0.3f * normal(random), 0.1f * normal(random)) +
                         Vector3f(0, 0, 5));
    const auto axis = core::analysis::mirrorAxis(points);
    ASSERT_TRUE(axis);
    EXPECT_GT(axis->dot(axes.col(2)), 0.999f);
    EXPECT_GT(axis->z(), 0);
}

TEST_F(BackSide, PointsOnALineHaveNoAxis) {
    std::vector<Vector3f> points;
    for (int i = 0; i < 50; ++i) points.emplace_back(0.01f * static_cast<float>(i), 0, 1);
    EXPECT_FALSE(core::analysis::mirrorAxis(points));
    EXPECT_FALSE(core::analysis::mirrorAxis(std::span(points).first(2)));
}

TEST_F(BackSide, OffsetMovesTheFrontBack) {
    const test::RayScene scene = sphere();
    core::BackSideParams params = with(BackSideMethod::Offset);
    params.offset = 0.07f;
    const BackLayer back = invent(scene, params);
    const core::Photo photo = scene.photograph();
    for (std::size_t i = 0; i < photo.depth.size(); ++i)
        if (photo.depth[i] > 0) {
            EXPECT_NEAR(back.surface.depth[i], photo.depth[i] + 0.07f, 1e-5f);
        }
    params.offset = 0;
    params.minThickness = 0.01f;
    expectThick(scene, invent(scene, params), 0.01f);
}

TEST_F(BackSide, TablesAreSlabsNotMirrors) {
    const test::RayScene scene = test::stillLife(test::testCamera());
    const std::vector<bool> supports = core::analysis::findSupports(scene.photograph().labels);
    EXPECT_TRUE(supports[1]);
    EXPECT_FALSE(supports[2]);
    EXPECT_FALSE(supports[3]);
    const BackLayer back = invent(scene, with(BackSideMethod::PcaMirror));
    EXPECT_EQ(back.segments[0].used, BackSideMethod::Offset);
    EXPECT_NE(back.segments[0].note, "");
    EXPECT_EQ(back.segments[1].used, BackSideMethod::PcaMirror);
    expectThick(scene, back, 0.002f);
}

TEST_F(BackSide, TinySegmentsFallBackToOffsetAndSaySo) {
    core::Photo photo = sphere().photograph();
    core::Surface front = sphere().frontSurface();
    for (std::size_t i = 0; i < photo.labels.size(); ++i) photo.labels[i] = photo.labels[i] != 0 ? 1 : 0;
    photo.labels(120, 90) = 7;
    photo.labels(121, 90) = 7;
    const BackLayer back = core::analysis::inventBackSide(photo.camera, photo.labels, front, {}, nullptr, 0, {});
    ASSERT_EQ(back.segments.size(), 2u);
    EXPECT_EQ(back.segments[1].label, 7);
    EXPECT_EQ(back.segments[1].used, BackSideMethod::Offset);
    EXPECT_NE(back.segments[1].note, "");
    EXPECT_NEAR(back.surface.depth(120, 90), photo.depth(120, 90) + 0.05f, 1e-5f);
}

TEST_F(BackSide, GivenDepthReplacesTheInventedOne) {
    const test::RayScene scene = sphere();
    core::ImageF given = scene.backSurface().depth;
    given(120, 90) = 0;                                        // none here: invented
    given(121, 90) = 2.0f;                                     // nearer than the front
    given(122, 90) = std::numeric_limits<float>::quiet_NaN();  // broken
    const BackLayer back = invent(scene, with(BackSideMethod::PcaMirror), &given);
    EXPECT_EQ(relativeError(scene, back, 4), 0);
    EXPECT_GT(back.surface.depth(120, 90), 4.0f);
    EXPECT_NEAR(back.surface.depth(121, 90), scene.photograph().depth(121, 90) + 0.002f, 1e-4f);
    expectThick(scene, back, 0.002f);
}

TEST_F(BackSide, PixelsWithoutLabelAreSolidToo) {
    test::RayScene scene = sphere();
    scene.objects[0].label = 0;
    const BackLayer back = invent(scene, {});
    expectThick(scene, back, 0.05f);
    EXPECT_TRUE(back.segments.empty());
}

}  // namespace
