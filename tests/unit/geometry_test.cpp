// SPDX-License-Identifier: GPL-3.0-or-later
// Depth filter, normals, positions and areas (docs/method.md#depth) against exact planes and spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/depth/filter_depth.h"
#include "core/analysis/depth/normals.h"
#include "tests/support/ray_scene.h"

namespace {

using core::ImageF;
using core::ImageV3;
using core::Vector3f;
using core::analysis::Side;
using test::Vector3d;

float degreesBetween(const Vector3f& a, const Vector3f& b) {
    return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0f, 1.0f)) * 180 / std::numbers::pi_v<float>;
}

ImageV3 normalsOf(const core::Photo& photo, const ImageF& depth, Side side = Side::Front, float noise = 0) {
    core::Surface surface;
    surface.depth = depth;
    core::analysis::computeSurface({photo.camera, photo.labels, side, noise}, surface, {});
    return surface.normal;
}

test::RayScene tiltedSquare(double angle, double half) {
    test::RayScene scene;
    scene.camera = test::testCamera(320, 240);
    // A thin box: only its front face is seen.
    scene.objects.push_back({1,
                             std::make_shared<test::Box>(Vector3d(0.02, -0.01, 1), Vector3d(half, half, 1e-6),
                                                         test::rotation(angle, {0.3, 1, 0})),
                             {}});
    return scene;
}

test::RayScene ball(double radius, const Vector3d& center = Vector3d(0, 0, 1)) {
    test::RayScene scene;
    scene.camera = test::testCamera(320, 240);
    scene.objects.push_back({1, std::make_shared<test::Sphere>(center, radius), {}});
    return scene;
}

double totalArea(const core::Surface& surface) {
    double sum = 0;
    for (const float a : surface.area.pixels()) sum += a;
    return sum;
}

core::Surface surfaceOf(const core::Photo& photo) {
    core::Surface surface;
    surface.depth = photo.depth;
    core::analysis::computeSurface({photo.camera, photo.labels}, surface, {});
    return surface;
}

TEST(Geometry, NormalsOfTiltedPlanesAreExact) {
    for (const double angle : {0.0, 0.5, 1.0, 1.3}) {
        const test::RayScene scene = tiltedSquare(angle, 0.3);
        const core::Photo photo = scene.photograph();
        const ImageV3 normals = normalsOf(photo, photo.depth);
        const core::Surface truth = scene.frontSurface();
        int count = 0;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            if (photo.depth[i] <= 0) {
                EXPECT_EQ(normals[i], Vector3f(0, 0, 0));
                continue;
            }
            ++count;
            EXPECT_LT(degreesBetween(normals[i], truth.normal[i]), 0.1f);
            EXPECT_LT(normals[i].dot(truth.position[i]), 0);
        }
        EXPECT_GT(count, 500);
    }
}

TEST(Geometry, NormalsOfASphere) {
    const test::RayScene scene = ball(0.25, {0.1, -0.05, 1});
    const core::Photo photo = scene.photograph();
    const ImageV3 normals = normalsOf(photo, photo.depth);
    const core::Surface truth = scene.frontSurface();
    std::vector<float> errors;
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (photo.depth[i] > 0) errors.push_back(degreesBetween(normals[i], truth.normal[i]));
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.1f);
    EXPECT_LT(errors[errors.size() * 95 / 100], 1.5f);
    EXPECT_LT(errors.back(), 20);
}

TEST(Geometry, BackNormalsFaceAway) {
    const test::RayScene scene = ball(0.25);
    const core::Photo photo = scene.photograph();
    const core::Surface truth = scene.backSurface();
    const ImageV3 normals = normalsOf(photo, truth.depth, Side::Back);
    std::vector<float> errors;
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (truth.depth[i] > 0) errors.push_back(degreesBetween(normals[i], truth.normal[i]));
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.1f);
}

TEST(Geometry, NormalsStopAtDiscontinuitiesAndLabels) {
    // A near square in front of a far wall: the same label or another one, no normal may be bent at the edge.
    for (const bool sameLabel : {false, true}) {
        test::RayScene scene;
        scene.camera = test::testCamera();
        const Eigen::Matrix3d tilt = test::rotation(0.4, {0, 1, 0});
        scene.objects.push_back(
            {1, std::make_shared<test::Box>(Vector3d(0, 0, 1), Vector3d(0.2, 0.15, 0.001), tilt), {}});
        scene.objects.push_back({static_cast<std::uint16_t>(sameLabel ? 1 : 2),
                                 std::make_shared<test::Box>(Vector3d(0, 0, 1.6), Vector3d(4, 4, 0.01)),
                                 {}});
        const core::Photo photo = scene.photograph();
        const ImageV3 normals = normalsOf(photo, photo.depth);
        const core::Surface truth = scene.frontSurface();
        int wrong = 0;
        int count = 0;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            ++count;
            // The square's side faces are a fraction of a pixel wide.
            if (degreesBetween(normals[i], truth.normal[i]) > 1 && std::abs(truth.normal[i].z()) > 0.9f) ++wrong;
        }
        EXPECT_GT(count, 10000);
        EXPECT_LE(wrong, sameLabel ? count / 500 : 0) << "same label: " << sameLabel;
    }
}

TEST(Geometry, AreasOfATiltedSquareAddUp) {
    for (const double angle : {0.0, 0.6, 1.1}) {
        const core::Surface surface = surfaceOf(tiltedSquare(angle, 0.2).photograph());
        EXPECT_NEAR(totalArea(surface), 0.16, 0.16 * 0.015) << "tilted by " << angle;
    }
}

TEST(Geometry, AreasOfASphereAddUpToItsVisibleCap) {
    const double radius = 0.25;
    const core::Surface surface = surfaceOf(ball(radius).photograph());
    // Up to 60 degrees from the point that faces the camera: height R/2, area πR².
    double inner = 0;
    for (std::size_t i = 0; i < surface.area.size(); ++i)
        if (surface.depth[i] > 0 && (Vector3f(0, 0, 1) - surface.position[i]).z() > 0.5f * 0.25f)
            inner += surface.area[i];
    EXPECT_NEAR(inner, std::numbers::pi * radius * radius, 0.01 * std::numbers::pi * radius * radius);
    // From distance 1 the cap up to the tangent cone is seen: its height is R·(1 − R/distance). A seventh of it lies in
    // the outermost ring of pixels.
    const double cap = 2 * std::numbers::pi * radius * radius * (1 - radius);
    EXPECT_NEAR(totalArea(surface), cap, 0.02 * cap);
}

TEST(Geometry, PositionsProjectToTheirPixels) {
    const core::Photo photo = ball(0.25).photograph();
    const core::Surface surface = surfaceOf(photo);
    for (int y = 0; y < photo.depth.height(); ++y) {
        for (int x = 0; x < photo.depth.width(); ++x) {
            if (photo.depth(x, y) <= 0) continue;
            const Eigen::Vector2f uv = photo.camera.project(surface.position(x, y));
            EXPECT_NEAR(uv.x(), static_cast<float>(x) + 0.5f, 1e-3f);
            EXPECT_NEAR(uv.y(), static_cast<float>(y) + 0.5f, 1e-3f);
            EXPECT_EQ(surface.position(x, y).z(), photo.depth(x, y));
        }
    }
}

TEST(Geometry, LonePixelsAndLinesHaveFiniteNormals) {
    core::Photo photo;
    photo.camera = test::testCamera(16, 12);
    photo.depth = ImageF(16, 12);
    photo.labels = core::LabelImage(16, 12);
    photo.depth(3, 3) = 1;
    for (int x = 5; x < 12; ++x) photo.depth(x, 8) = 1 + 0.01f * static_cast<float>(x);
    const ImageV3 normals = normalsOf(photo, photo.depth);
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (photo.depth[i] > 0) {
            EXPECT_NEAR(normals[i].norm(), 1, 1e-4f);
        }
    EXPECT_LT(degreesBetween(normals(3, 3), -photo.camera.pixelRay(3, 3)), 35);
}

struct FilterTest : testing::Test {
    static ImageF filter(const core::Photo& photo, const ImageF& depth, float noise,
                         const core::DepthFilterParams& params = {}) {
        core::analysis::DepthNoise flat;
        flat.deviation.cellsPerUnit = 1;
        for (std::size_t i = 0; i < flat.deviation.sigma.size(); ++i)
            flat.deviation.sigma[i] = noise * static_cast<float>(i);
        flat.relative = noise;
        return core::analysis::filterDepth(depth, photo, params, flat, {});
    }
    static float estimateNoise(const ImageF& depth, const core::LabelImage& labels) {
        return core::analysis::estimateDepthNoise(core::analysis::inverseOf(depth), labels, 1, {}).relative;
    }
    static ImageF withNoise(const ImageF& depth, float sigma, unsigned seed) {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal(0, sigma);
        ImageF noisy = depth;
        for (float& z : noisy.pixels())
            if (z > 0) z *= 1 + normal(random);
        return noisy;
    }
    static float medianError(const ImageF& a, const ImageF& b) {
        std::vector<float> errors;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (b[i] > 0) errors.push_back(std::abs(a[i] / b[i] - 1));
        std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2));
        return errors[errors.size() / 2];
    }
};

TEST_F(FilterTest, APlaneStaysThatPlane) {
    // Even with a large range and steep tilt, up to the square's edges.
    const core::Photo photo = tiltedSquare(1.2, 0.3).photograph();
    const ImageF filtered = filter(photo, photo.depth, 0.01f);
    for (std::size_t i = 0; i < filtered.size(); ++i)
        EXPECT_NEAR(filtered[i], photo.depth[i], 2e-6f * photo.depth[i] + 0);
}

TEST_F(FilterTest, NoiseIsEstimatedAndReduced) {
    const core::Photo photo = test::stillLife(test::testCamera()).photograph();
    for (const float sigma : {0.0005f, 0.002f}) {
        const ImageF noisy = withNoise(photo.depth, sigma, 4);
        const float estimated = estimateNoise(noisy, photo.labels);
        EXPECT_NEAR(estimated, sigma, 0.2f * sigma);
        const ImageF filtered = filter(photo, noisy, estimated);
        EXPECT_LT(medianError(filtered, photo.depth), 0.5f * medianError(noisy, photo.depth));
    }
}

TEST_F(FilterTest, QuantisationIsSeenAsNoise) {
    const core::Photo photo = test::stillLife(test::testCamera()).photograph();
    ImageF millimetres = photo.depth;
    for (float& z : millimetres.pixels()) z = std::round(z * 500) / 500;
    EXPECT_NEAR(estimateNoise(millimetres, photo.labels), 0.002f / std::sqrt(12.0f), 3e-4f);
    EXPECT_LT(estimateNoise(photo.depth, photo.labels), 2e-5f);
}

TEST_F(FilterTest, ExactDepthIsKept) {
    const core::Photo photo = ball(0.25).photograph();
    const float noise = estimateNoise(photo.depth, photo.labels);
    EXPECT_LT(medianError(filter(photo, photo.depth, noise), photo.depth), 1e-4f);
}

TEST_F(FilterTest, NothingCrossesLabelsOrInvalidPixels) {
    core::Photo photo;
    photo.camera = test::testCamera(32, 24);
    photo.color = core::ImageRgb(32, 24, Vector3f(0.5f, 0.5f, 0.5f));
    photo.depth = ImageF(32, 24);
    photo.labels = core::LabelImage(32, 24);
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 32; ++x) {
            photo.labels(x, y) = x < 16 ? 1 : 2;
            photo.depth(x, y) = x == 5 ? 0.0f : x < 16 ? 1.0f : 1.004f;
        }
    }
    const ImageF filtered = filter(photo, photo.depth, 0.01f);
    for (std::size_t i = 0; i < filtered.size(); ++i) EXPECT_EQ(filtered[i], photo.depth[i]);
}

}  // namespace
