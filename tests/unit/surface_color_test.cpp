// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/surface_color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using core::Vector3f;

/// A half sphere that faces the camera in a light L(d) = base + slope·d per channel, so that E(n)/π = base + ⅔ slope·n:
/// label 1 left, 2 right.
struct LitBall {
    static constexpr int kSize = 80;
    core::Photo photo;
    core::Analysis analysis;
    const Vector3f base{1, 0.8f, 0.6f};
    const Vector3f slope{0.3f, -0.5f, -0.2f};
    const Vector3f albedo[2] = {{0.2f, 0.4f, 0.1f}, {0.7f, 0.3f, 0.3f}};

    LitBall() {
        photo.color = core::ImageRgb(kSize, kSize, Vector3f::Zero());
        photo.labels = core::LabelImage(kSize, kSize, 0);
        auto front = std::make_shared<core::Surface>();
        front->depth = core::ImageF(kSize, kSize, 0.0f);
        front->normal = core::ImageV3(kSize, kSize, Vector3f::Zero());
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const float nx = (static_cast<float>(x) + 0.5f) / (kSize / 2.0f) - 1;
                const float ny = (static_cast<float>(y) + 0.5f) / (kSize / 2.0f) - 1;
                const float squared = nx * nx + ny * ny;
                if (squared > 0.95f) continue;
                const Vector3f n(nx, ny, -std::sqrt(1 - squared));
                const float e = 1 + 2.0f / 3 * slope.dot(n);
                photo.labels(x, y) = nx < 0 ? 1 : 2;
                photo.color(x, y) = e * base.cwiseProduct(albedo[nx < 0 ? 0 : 1]);
                front->depth(x, y) = 1;
                front->normal(x, y) = n;
            }
        auto environment = std::make_shared<core::DirectionalMap>();
        environment->radiance = core::ImageRgb(128, 64);
        environment->coverage = core::ImageF(128, 64, 1.0f);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 128; ++x)
                environment->radiance(x, y) =
                    (1 + slope.dot(core::DirectionalMap::directionFromTexel(
                             {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 128, 64))) *
                    base;
        analysis.front = front;
        analysis.environment = environment;
    }
};

void expectNear(const Vector3f& found, const Vector3f& expected, float tolerance) {
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), tolerance)
        << found.transpose() << " for " << expected.transpose();
}

TEST(SurfaceColor, IsTheAlbedoWithoutShading) {
    LitBall ball;
    expectNear(core::segmentAlbedo(ball.photo, &ball.analysis, 1), ball.albedo[0], 0.005f);
    expectNear(core::segmentAlbedo(ball.photo, &ball.analysis, 2), ball.albedo[1], 0.005f);
    expectNear(core::albedoAt(ball.photo, &ball.analysis, 20, 20), ball.albedo[0], 0.005f);
    expectNear(core::albedoAt(ball.photo, &ball.analysis, 41, 60), ball.albedo[1], 0.005f);
}

TEST(SurfaceColor, HighlightsDoNotCount) {
    LitBall ball;
    for (int y = 30; y < 40; ++y)
        for (int x = 20; x < 36; ++x) ball.photo.color(x, y) = {9, 9, 9};
    expectNear(core::segmentAlbedo(ball.photo, &ball.analysis, 1), ball.albedo[0], 0.02f);
}

TEST(SurfaceColor, BrighterThanWhiteKeepsItsHue) {
    LitBall ball;
    for (Vector3f& c : ball.photo.color.pixels()) c *= 4;
    const Vector3f found = core::segmentAlbedo(ball.photo, &ball.analysis, 1);
    EXPECT_NEAR(found.maxCoeff(), 0.9f, 1e-5f);
    expectNear(found / found.y(), ball.albedo[0] / ball.albedo[0].y(), 0.02f);
}

TEST(SurfaceColor, WithoutLightItFollowsTheMeter) {
    LitBall ball;
    for (Vector3f& c : ball.photo.color.pixels()) c = Vector3f::Constant(0.36f);
    ball.photo.color(10, 40) = {0.36f, 0.36f, 0.36f};
    expectNear(core::segmentAlbedo(ball.photo, nullptr, 1), Vector3f::Constant(0.18f), 1e-4f);
    expectNear(core::segmentAlbedo(ball.photo, nullptr, 9), Vector3f::Constant(0.5f), 1e-6f);
    for (Vector3f& c : ball.photo.color.pixels()) c = Vector3f::Zero();
    EXPECT_TRUE(core::segmentAlbedo(ball.photo, nullptr, 1).allFinite());
    EXPECT_TRUE(core::albedoAt(ball.photo, nullptr, -1, 500).allFinite());
}

}  // namespace
