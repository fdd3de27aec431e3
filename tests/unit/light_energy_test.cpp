// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/light_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/analysis/light/irradiance.h"

namespace {

using core::Vector3f;

constexpr int kBallSize = 80;

/// A matt half sphere that faces the camera, in a light of radiance 0.3 with a lamp of radiance `kLamp` above. The
/// camera clips at `clipLevel`; the light as it was recovered has the lamp at 1.
struct LampBall {
    static constexpr float kLamp = 3;
    core::Scene scene;
    core::Surface front;
    core::DirectionalMap truth;
    core::DirectionalMap clipped;

    explicit LampBall(const Vector3f& albedo, float clipLevel = 1, bool glossy = false) {
        truth.radiance = core::ImageRgb(64, 32, Vector3f(0.3f, 0.3f, 0.3f));
        truth.coverage = core::ImageF(64, 32, 1.0f);
        clipped = truth;
        clipped.clipped = core::Image<std::uint8_t>(64, 32, 0);
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 64; ++x) {
                truth.radiance(x, y) = Vector3f::Constant(kLamp);
                clipped.radiance(x, y) = Vector3f::Constant(1);
                clipped.clipped(x, y) = 7;
            }
        auto photo = std::make_shared<core::Photo>();
        photo->color = core::ImageRgb(kBallSize, kBallSize, Vector3f::Zero());
        photo->labels = core::LabelImage(kBallSize, kBallSize, 0);
        photo->clipLevel = clipLevel;
        front.depth = core::ImageF(kBallSize, kBallSize, 0.0f);
        front.normal = core::ImageV3(kBallSize, kBallSize, Vector3f::Zero());
        const core::analysis::Irradiance light(truth.radiance);
        for (int y = 0; y < kBallSize; ++y)
            for (int x = 0; x < kBallSize; ++x) {
                const float nx = (static_cast<float>(x) + 0.5f) / (kBallSize / 2.0f) - 1;
                const float ny = (static_cast<float>(y) + 0.5f) / (kBallSize / 2.0f) - 1;
                if (nx * nx + ny * ny > 0.9f) continue;
                const Vector3f n(nx, ny, -std::sqrt(1 - nx * nx - ny * ny));
                photo->labels(x, y) = 1;
                photo->color(x, y) = albedo.cwiseProduct(light.at(n)).cwiseMin(clipLevel);
                front.depth(x, y) = 1;
                front.normal(x, y) = n;
            }
        scene.photo = photo;
        core::Segment segment;
        segment.label = 1;
        segment.glossy = glossy;
        scene.segments = {segment};
    }

    [[nodiscard]] core::DirectionalMap raised(bool exactShape) const {
        core::DirectionalMap light = clipped;
        core::analysis::raiseToMattSurfaces(scene, front, exactShape, light);
        return light;
    }
};

TEST(LightEnergy, AWhiteBallTellsHowBrightAClippedLampIs) {
    const core::DirectionalMap light = LampBall(Vector3f::Constant(0.8f)).raised(true);
    EXPECT_EQ(light.radiance(10, 20).x(), 0.3f) << "what was measured stays";
    EXPECT_NEAR(light.radiance(10, 2).x(), LampBall::kLamp, 0.01f);
}

TEST(LightEnergy, ClippedPixelsAreLowerBoundsAndTakeNothingAway) {
    const core::DirectionalMap light = LampBall(Vector3f::Constant(0.8f), 0.7f).raised(true);
    EXPECT_NEAR(light.radiance(10, 2).x(), LampBall::kLamp, 0.01f);
}

TEST(LightEnergy, GreyExplainsTheSamePictureByAWeakerLight) {
    const LampBall ball(Vector3f::Constant(0.02f));
    EXPECT_EQ(ball.raised(true).radiance(10, 2), ball.clipped.radiance(10, 2));
    EXPECT_EQ(ball.raised(false).radiance(10, 2), ball.clipped.radiance(10, 2));
}

TEST(LightEnergy, AColouredBallMakesNoColourCast) {
    const LampBall ball(Vector3f(0.8f, 0.05f, 0.05f));
    for (const bool exactShape : {false, true}) {
        const core::DirectionalMap light = ball.raised(exactShape);
        EXPECT_GT(light.radiance(10, 2).x(), 1.1f);
        EXPECT_FLOAT_EQ(light.radiance(10, 2).x(), light.radiance(10, 2).z());
        EXPECT_EQ(exactShape, light.radiance(10, 20).x() == 0.3f);
    }
}

TEST(LightEnergy, GlossySegmentsAndExactFloatsChangeNothing) {
    const LampBall mirror(Vector3f::Constant(0.8f), 1, true);
    EXPECT_EQ(mirror.raised(false).radiance(10, 2), mirror.clipped.radiance(10, 2));
    const LampBall floats(Vector3f::Constant(0.8f), std::numeric_limits<float>::infinity());
    EXPECT_EQ(floats.raised(true).radiance(10, 2), floats.clipped.radiance(10, 2));
    EXPECT_GT(floats.raised(false).radiance(10, 2).x(), 1.5f) << "wrong normals mix bright and dark";
}

}  // namespace
