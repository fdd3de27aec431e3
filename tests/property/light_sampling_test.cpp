// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling of the environment: its density, and what it does to means and noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/base/color.h"
#include "core/shading/environment_sampler.h"
#include "core/shading/image_filter.h"
#include "core/shading/reference_renderer.h"
#include "core/shading/surface_samples.h"
#include "tests/support/analytic_scene.h"
#include "tests/support/statistics.h"

namespace core {
namespace {

using test::AnalyticHit;
using test::AnalyticScene;
using test::squareCamera;

/// Sky of radiance 1 with a sun of `radius` [rad] that adds as much light as three times the sky.
std::function<Vector3f(const Vector3f&)> sky(float radius, const Vector3f& towards) {
    const float solidAngle = 2 * static_cast<float>(std::numbers::pi) * (1 - std::cos(radius));
    const float sun = 3 * 4 * static_cast<float>(std::numbers::pi) / solidAngle;
    return [=, d = towards.normalized()](const Vector3f& v) {
        return Vector3f(Vector3f::Constant(v.dot(d) > std::cos(radius) ? 1 + sun : 1.0f));
    };
}

/// A ball on a floor, both of which can be edited; the ball shades a part of the floor.
AnalyticScene ballOnFloor() {
    const auto ball = test::sphere(0.3f, 1.6f, Vector3f(0.3f, 0.4f, 0.5f));
    return AnalyticScene(squareCamera(32, 28), [=](const Vector3f& ray) {
        AnalyticHit hit = ball(ray);
        if (hit.front > 0) {
            hit.label = 2;
            return hit;
        }
        const float z = ray.y() > 0 ? 0.3f / ray.y() : 0;
        if (z > 0 && z < 4)
            hit = {.front = z,
                   .back = z * 1.05f,
                   .frontNormal = {0, -1, 0},
                   .backNormal = {0, 1, 0},
                   .label = 1,
                   .color = {0.4f, 0.3f, 0.2f}};
        return hit;
    });
}

/// Mean over a segment of the luminance, and of the variance of a pixel's sample.
struct Statistics {
    double mean = 0, variance = 0;
    double standardError = 0;
};
Statistics statistics(const AnalyticScene& s, std::uint16_t label, LightSampling sampling, int samples) {
    const ReferenceRenderer renderer(s.scene, s.analysis, sampling);
    const Accumulation sums = renderer.reshade(samples);
    EXPECT_EQ(sums.dropped, 0u);
    Statistics result;
    double pixels = 0;
    for (std::size_t i = 0; i < sums.sum.size(); ++i) {
        if (s.scene.photo->labels[i] != label) continue;
        const double mean = static_cast<double>(luminance(sums.sum[i])) / samples;
        result.mean += mean;
        result.variance +=
            (static_cast<double>(sums.sumSquaredLuminance[i]) / samples - mean * mean) * samples / (samples - 1);
        pixels += 1;
    }
    result.mean /= pixels;
    result.variance /= pixels;
    result.standardError = std::sqrt(result.variance / (samples * pixels));
    return result;
}

TEST(EnvironmentSampler, DrawsWhatItsDensitySays) {
    AnalyticScene s = ballOnFloor();
    s.setEnvironment([](const Vector3f& d) {
        Vector3f light = sky(0.12f, {0.3f, -0.9f, 0.3f})(d) + 40 * sky(0.3f, {-1, 0.1f, -0.2f})(d);
        return Vector3f(light * (1 + 0.5f * d.x()));
    });
    const DirectionalMap& map = *s.analysis->environment;
    const EnvironmentSampler sampler(map);
    ASSERT_FALSE(sampler.empty());
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    double integral = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            integral += static_cast<double>(sampler.density()(x, y)) *
                        static_cast<double>(DirectionalMap::texelSolidAngle(y, width, height));
    EXPECT_NEAR(integral, 1, 1e-4);

    constexpr int kSamples = 400000;
    constexpr int kBlock = 8;  // texels per bin
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    Image<double> counts(width / kBlock, height / kBlock, 0.0);
    for (int i = 0; i < kSamples; ++i) {
        const float u = std::min(uniform(random), 0.99999994f);
        const float v = std::min(uniform(random), 0.99999994f);
        const EnvironmentSampler::Sample sample = sampler.sample(u, v);
        ASSERT_NEAR(sample.direction.norm(), 1, 1e-5);
        ASSERT_GT(sample.pdf, 0);
        const Vector2f texel = DirectionalMap::texelFromDirection(sample.direction, width, height);
        counts(std::clamp(static_cast<int>(texel.x()) / kBlock, 0, counts.width() - 1),
               std::clamp(static_cast<int>(texel.y()) / kBlock, 0, counts.height() - 1)) += 1;
    }
    std::vector<double> expected;
    for (int y = 0; y < counts.height(); ++y)
        for (int x = 0; x < counts.width(); ++x) {
            double probability = 0;
            for (int j = 0; j < kBlock; ++j)
                for (int i = 0; i < kBlock; ++i)
                    probability += static_cast<double>(sampler.density()(x * kBlock + i, y * kBlock + j)) *
                                   static_cast<double>(DirectionalMap::texelSolidAngle(y * kBlock + j, width, height));
            expected.push_back(probability * kSamples);
        }
    EXPECT_GT(std::ranges::count_if(expected, [](double e) { return e > 5; }), 10);
    EXPECT_GT(test::chiSquareP({counts.pixels().begin(), counts.pixels().end()}, expected), 1e-4);
}

TEST(EnvironmentSampler, LargeMapsAreSampledInCells) {
    DirectionalMap map{.radiance = ImageRgb(2500, 1250, Vector3f(1, 1, 1)), .coverage = ImageF(2500, 1250, 1.0f)};
    for (int y = 300; y < 303; ++y)
        for (int x = 2498; x < 2500; ++x) map.radiance(x, y) = Vector3f::Constant(1e6f);
    const EnvironmentSampler sampler(map);
    EXPECT_EQ(sampler.cellSize(), 3);
    EXPECT_EQ(sampler.columns(), 834);
    int found = 0;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 0.999f);
    for (int i = 0; i < 1000; ++i) {
        const auto sample = sampler.sample(uniform(random), uniform(random));
        EXPECT_FLOAT_EQ(sampler.pdf(sample.direction), sample.pdf);
        found += luminance(map.lookup(sample.direction)) > 1000;
    }
    EXPECT_GT(found, 400);
}

TEST(EnvironmentSampler, LeavesSmoothAndDarkLightAlone) {
    AnalyticScene s = ballOnFloor();
    s.setEnvironment([](const Vector3f& d) { return Vector3f::Constant(1 + 0.3f * d.y()); });
    EXPECT_TRUE(EnvironmentSampler(*s.analysis->environment).empty());
    s.setEnvironment([](const Vector3f&) { return Vector3f(0, 0, 0); });
    EXPECT_TRUE(EnvironmentSampler(*s.analysis->environment).empty());
    EXPECT_TRUE(EnvironmentSampler(DirectionalMap()).empty());
}

TEST(LightSampling, MeansAgreeForEveryBrdf) {
    // A sun large enough for the BRDF's sampling alone to be a reference.
    for (const char* brdf : {"lambert", "phong", "ggx"}) {
        AnalyticScene s = ballOnFloor();
        s.setEnvironment(sky(0.25f, {0.4f, -0.8f, 0.2f}));
        s.edit(1, brdf);
        s.edit(2, brdf).values[0] = std::string(brdf) == "phong" ? 20.0f : 0.4f;
        for (const auto label : {std::uint16_t{1}, std::uint16_t{2}}) {
            const Statistics both = statistics(s, label, LightSampling::Both, 500);
            const Statistics alone = statistics(s, label, LightSampling::BrdfOnly, 3000);
            const double error = std::hypot(both.standardError, alone.standardError);
            EXPECT_LT(error, 0.02 * alone.mean) << brdf << " " << label << ": the test must be able to fail";
            EXPECT_NEAR(both.mean, alone.mean, 4 * error) << brdf << " " << label;
        }
    }
}

TEST(LightSampling, TranslucentBodiesReceiveTheSameLight) {
    AnalyticScene s = ballOnFloor();
    s.setEnvironment(sky(0.25f, {0.4f, -0.8f, 0.2f}));
    s.edit(2, "none").translucency.emplace();
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 2, 200, 3);
    const auto mean = [&](LightSampling sampling, int rays) {
        const ReferenceRenderer renderer(s.scene, s.analysis, sampling);
        double sum = 0;
        for (const Vector3f& e : renderer.irradiance(samples, 2, 1.3f, rays)) sum += static_cast<double>(e.x());
        return sum / 200;
    };
    const double alone = mean(LightSampling::BrdfOnly, 8000);
    EXPECT_NEAR(mean(LightSampling::Both, 1000), alone, 0.01 * alone);
}

TEST(LightSampling, SmallSunDoesNotSparkle) {
    AnalyticScene s = ballOnFloor();
    s.setEnvironment(sky(0.035f, {0.4f, -0.8f, 0.2f}));
    s.edit(1, "lambert");
    s.edit(2, "ggx").values[0] = 0.5f;
    for (const auto label : {std::uint16_t{1}, std::uint16_t{2}}) {
        const Statistics both = statistics(s, label, LightSampling::Both, 64);
        const Statistics alone = statistics(s, label, LightSampling::BrdfOnly, 1024);
        EXPECT_LT(both.variance, alone.variance / 100) << label;
    }
}

TEST(LightSampling, IsNoWorseInSoftLightAndInMirrors) {
    // A wide window: the BRDF's sampling alone finds it.
    AnalyticScene s = ballOnFloor();
    s.setEnvironment([](const Vector3f& d) { return Vector3f::Constant(d.x() > 0.3f ? 4.0f : 1.0f); });
    s.edit(1, "lambert");
    s.edit(2, "ggx").values[0] = 0.05f;
    ASSERT_FALSE(EnvironmentSampler(*s.analysis->environment).empty()) << "the test must be able to fail";
    for (const auto label : {std::uint16_t{1}, std::uint16_t{2}}) {
        const Statistics both = statistics(s, label, LightSampling::Both, 512);
        const Statistics alone = statistics(s, label, LightSampling::BrdfOnly, 512);
        EXPECT_LT(both.variance, alone.variance) << label;
    }
}

}  // namespace
}  // namespace core
