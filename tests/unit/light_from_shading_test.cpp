// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/light_from_shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/analysis/light/environment.h"

namespace {

using core::Vector3f;

/// A picture of a half sphere that faces the camera, its left and right half of different segments and albedos, shaded
/// by E(n)/π = `irradiance`.
struct ShadedBall {
    core::Photo photo;
    core::Surface front;

    ShadedBall(const std::function<float(const Vector3f&)>& irradiance, float textureSigma = 0) {
        constexpr int kSize = 120;
        photo.camera = {kSize, kSize, 200, 200, kSize / 2.0f, kSize / 2.0f};
        photo.color = core::ImageRgb(kSize, kSize, Vector3f::Zero());
        photo.labels = core::LabelImage(kSize, kSize, 0);
        front.depth = core::ImageF(kSize, kSize, 0.0f);
        front.normal = core::ImageV3(kSize, kSize, Vector3f::Zero());
        std::mt19937 random(1);
        std::normal_distribution<float> texture(0, 1);
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const float nx = (static_cast<float>(x) + 0.5f) / (kSize / 2.0f) - 1;
                const float ny = (static_cast<float>(y) + 0.5f) / (kSize / 2.0f) - 1;
                const float squared = nx * nx + ny * ny;
                if (squared > 0.9f) continue;
                const Vector3f n(nx, ny, -std::sqrt(1 - squared));
                const float albedo = (nx < 0 ? 0.1f : 0.7f) * std::exp(textureSigma * texture(random));
                photo.color(x, y) = albedo * irradiance(n) * Vector3f(1, 0.8f, 0.3f);
                photo.labels(x, y) = nx < 0 ? 1 : 2;
                front.depth(x, y) = 1;
                front.normal(x, y) = n;
            }
        }
    }

    [[nodiscard]] core::analysis::ShadingLight light() const {
        return core::analysis::lightFromShading(photo, front, {});
    }
};

float axisErrorDegrees(const Vector3f& a, const Vector3f& b) {
    return std::acos(std::clamp(a.dot(b), -1.0f, 1.0f)) * 57.29578f;
}

TEST(LightFromShading, FindsTheDirectionWhateverTheAlbedos) {
    const Vector3f axis = Vector3f(0.8f, -0.5f, -0.4f).normalized();
    const ShadedBall plain([&](const Vector3f& n) { return 1 + 0.8f * axis.dot(n); });
    EXPECT_LT(axisErrorDegrees(plain.light().axis, axis), 3);
    const float k = plain.light().concentration;
    EXPECT_NEAR(2 * (1 / std::tanh(k) - 1 / k), 0.8f, 0.06f) << "gradient of the irradiance";

    const ShadedBall textured([&](const Vector3f& n) { return 1 + 0.8f * axis.dot(n); }, 0.4f);
    EXPECT_LT(axisErrorDegrees(textured.light().axis, axis), 8);
}

TEST(LightFromShading, OutliersDoNotPull) {
    const Vector3f axis(-1, 0, 0);
    ShadedBall ball([&](const Vector3f& n) { return 1 + 0.6f * axis.dot(n); });
    for (int y = 20; y < 50; ++y)  // a dark print
        for (int x = 70; x < 90; ++x) ball.photo.color(x, y) *= 0.02f;
    EXPECT_LT(axisErrorDegrees(ball.light().axis, axis), 10);
}

TEST(LightFromShading, ALampFillsTheSphereWithTheRadianceItClaims) {
    const core::analysis::ShadingLight light{{0, 0, 1}, 1.5f, 2};
    double sum = 0;
    double along = 0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
        const double z = -1 + (2 * i + 1.0) / kSteps;
        const double l =
            static_cast<double>(light.radiance({static_cast<float>(std::sqrt(1 - z * z)), 0, static_cast<float>(z)}));
        sum += l / kSteps;
        along += l * z / kSteps;
    }
    EXPECT_NEAR(sum, 2, 1e-4);
    EXPECT_NEAR(along / sum, 1 / std::tanh(1.5) - 1 / 1.5, 1e-4);
}

TEST(LightFromShading, SurroundingsAreLimitedAndDiffuseSurfacesReceiveTheSame) {
    const core::analysis::ShadingLight broad{{0, 0, 1}, 1.5f, 0.8f};
    core::analysis::ShadingLight limited = broad;
    limited.limit = 0.9f;
    // Irradiance over π of a surface whose normal is at an angle to the axis.
    const auto received = [](const core::analysis::ShadingLight& light, float angle) {
        const Vector3f n(std::sin(angle), 0, std::cos(angle));
        double sum = 0;
        constexpr int kSteps = 400;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j) {
                const double z = -1 + (2 * i + 1.0) / kSteps;
                const double turn = 2 * 3.14159265358979 * (j + 0.5) / kSteps;
                const double r = std::sqrt(1 - z * z);
                const Vector3f d(static_cast<float>(r * std::cos(turn)), static_cast<float>(r * std::sin(turn)),
                                 static_cast<float>(z));
                sum += static_cast<double>(light.radiance(d) * std::max(d.dot(n), 0.0f)) * 4 / (kSteps * kSteps);
            }
        return sum;
    };
    for (const float angle : {0.0f, 0.8f, 1.6f, 2.4f})
        EXPECT_NEAR(received(limited, angle), received(broad, angle), 0.1 * received(broad, 0)) << angle;
    int bright = 0;
    constexpr int kCosines = 1000;
    for (int i = 0; i < kCosines; ++i) {
        const float z = -1 + (2 * static_cast<float>(i) + 1) / kCosines;
        if (limited.radiance({std::sqrt(1 - z * z), 0, z}) > 1.0f) ++bright;
    }
    EXPECT_LT(bright, 0.1 * kCosines) << "a highlight";
    EXPECT_GT(broad.radiance({0.8f, 0, 0.6f}), 1.0f) << "which was a third of all directions";
}

TEST(LightFromShading, NothingCurvedIsLitFromAbove) {
    ShadedBall flat([](const Vector3f&) { return 1.0f; });
    for (Vector3f& n : flat.front.normal.pixels()) n = {0, 0, -1};
    EXPECT_LT(axisErrorDegrees(flat.light().axis, {0, -1, 0}), 1);
}

/// Radiance that what faces the camera gets on the average.
float received(const ShadedBall& ball) {
    const core::analysis::ShadingLight light = ball.light();
    const float k = light.concentration;
    Vector3f facing = Vector3f::Zero();
    float count = 0;
    for (const Vector3f& n : ball.front.normal.pixels()) facing += n, count += n.isZero() ? 0.0f : 1.0f;
    return light.mean * (1 + 2 * (1 / std::tanh(k) - 1 / k) * light.axis.dot(facing / count));
}

TEST(LightFromShading, WithoutSegmentsItIsFromAbove) {
    ShadedBall ball([](const Vector3f& n) { return 1 + 0.5f * n.x(); });
    for (std::uint16_t& label : ball.photo.labels.pixels()) label = 0;
    EXPECT_LT(axisErrorDegrees(ball.light().axis, {0, -1, 0}), 1);
    EXPECT_GT(ball.light().mean, 0);
}

TEST(LightFromShading, BrightnessFollowsTheMeter) {
    // Lit by radiance 2: reflects 18 % of it on the average; a tenth of the pixels are highlights.
    ShadedBall ball([](const Vector3f&) { return 1.0f; });
    int i = 0;
    for (Vector3f& c : ball.photo.color.pixels())
        if (!c.isZero()) c = Vector3f::Constant(i++ % 10 == 0 ? 2.4f : 0.1333f);
    EXPECT_NEAR(received(ball), 2, 0.01f);

    // Dimmer than all that is white, and surroundings no brighter than that.
    for (Vector3f& c : ball.photo.color.pixels())
        if (!c.isZero()) c = Vector3f::Constant(1.6f);
    EXPECT_NEAR(received(ball), 1.6f, 0.01f);
}

TEST(LightFromShading, WhiteFacingTheLightIsNoBrighterThanInThePhotograph) {
    const Vector3f axis = Vector3f(0.5f, -0.6f, -0.6f).normalized();
    ShadedBall white([&](const Vector3f& n) { return 1 + 0.8f * axis.dot(n); });
    for (int y = 0; y < white.photo.color.height(); ++y)
        for (int x = 0; x < white.photo.color.width(); ++x)
            if (const Vector3f& n = white.front.normal(x, y); !n.isZero())
                white.photo.color(x, y) = Vector3f::Constant(0.8f * 1.2f * (1 + 0.8f * axis.dot(n)));
    // Everything reflects 80 % of a light of mean 1.2.
    EXPECT_NEAR(white.light().mean, 1.2f, 0.12f);
}

TEST(LightFromShading, NoLightAndNoDepth) {
    ShadedBall black([](const Vector3f&) { return 0.0f; });
    EXPECT_EQ(black.light().radiance({1, 0, 0}), 1);
    ShadedBall bright([](const Vector3f&) { return 1.0f; });
    for (float& z : bright.front.depth.pixels()) z = 0;
    EXPECT_EQ(bright.light().radiance({0, 1, 0}), 1);
}

/// The environment of a ball whose first segment is flagged and shows red light.
core::DirectionalMap environmentOf(const ShadedBall& ball, bool contradicts, std::optional<Vector3f> chosen) {
    core::Scene scene;
    scene.photo = std::make_shared<core::Photo>(ball.photo);
    scene.environment.height = 16;
    core::Segment segment;
    segment.label = 1;
    segment.glossy = true;
    segment.reflectance = chosen;
    scene.segments = {segment};
    auto reflectance = std::make_shared<core::Reflectance>();
    reflectance->label = 1;
    reflectance->reliable = !contradicts;
    reflectance->commonSolidAngle = 0.5f;
    auto seen = std::make_shared<core::analysis::SegmentReflections>();
    seen->estimate = *reflectance;
    seen->missed = {core::ImageRgb(32, 16, Vector3f(1, 0, 0)), core::ImageF(32, 16, 1.0f)};
    const std::vector<std::shared_ptr<const core::Reflectance>> reflectances{reflectance};
    const std::vector<std::shared_ptr<const core::analysis::SegmentReflections>> reflections{seen};
    const core::Image<std::uint8_t> distant(ball.photo.color.width(), ball.photo.color.height(), 0);
    return core::analysis::recoverEnvironment(scene, ball.front, distant, true, reflectances, reflections, {});
}

TEST(LightFromShading, TakesThePlaceOfSegmentsThatShowMoreThanTheyMirror) {
    const ShadedBall ball([](const Vector3f& n) { return 1 - 0.5f * n.y(); });
    const core::DirectionalMap contradicted = environmentOf(ball, true, std::nullopt);
    EXPECT_EQ(contradicted.coverage(3, 3), 0);
    EXPECT_FLOAT_EQ(contradicted.radiance(3, 3).x(), contradicted.radiance(3, 3).z());
    EXPECT_GT(contradicted.radiance(3, 1).y(), 1.5f * contradicted.radiance(3, 14).y()) << "lit from above";

    for (const auto& map : {environmentOf(ball, false, std::nullopt), environmentOf(ball, true, Vector3f(1, 1, 1))}) {
        EXPECT_EQ(map.coverage(3, 3), 1);
        EXPECT_GT(map.radiance(3, 3).x(), 0.9f);
        EXPECT_LT(map.radiance(3, 3).z(), 0.01f);
    }
}

}  // namespace
