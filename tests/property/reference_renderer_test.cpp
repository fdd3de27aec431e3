// SPDX-License-Identifier: GPL-3.0-or-later
// Furnaces and closed forms for the oracle itself.
#include "core/shading/reference_renderer.h"
#include "core/material/diffusion_profile.h"
#include "core/material/translucency.h"
#include "core/shading/image_filter.h"
#include "core/shading/surface_samples.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "shaders/shared/rng.h"
#include "tests/support/analytic_scene.h"

namespace core {
namespace {

using test::AnalyticHit;
using test::AnalyticScene;
using test::squareCamera;

Vector3f mean(const ImageRgb& image, const LabelImage& labels, std::uint16_t label) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
    for (std::size_t i = 0; i < image.size(); ++i)
        if (labels[i] == label) {
            sum += image[i].cast<double>();
            count += 1;
        }
    return (sum / count).cast<float>();
}

TEST(ReferenceFurnace, WhiteLambertSphereVanishes) {
    // The photograph is white too, so every path ends with 1 wherever it ends.
    AnalyticScene s(squareCamera(32, 40), test::sphere(0.3f, 1, Vector3f(1, 1, 1)));
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    s.edit(1, "lambert");
    s.scene.render.samples = 16;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const Accumulation sums = renderer.reshade(16);
    EXPECT_EQ(sums.dropped, 0u);
    for (std::size_t i = 0; i < sums.sum.size(); ++i) {
        const float expected = s.scene.photo->labels[i] == 1 ? 16.0f : 0.0f;
        ASSERT_NEAR((sums.sum[i] - Vector3f::Constant(expected)).cwiseAbs().maxCoeff(), 0, 1e-4) << i;
    }
}

TEST(ReferenceFurnace, ConvexSphereHardlySeesItself) {
    // A black photograph and one bounce: what is missing from 1 is the share of rays that hit the sphere they left.
    AnalyticScene s(squareCamera(48, 60), test::sphere(0.3f, 1));
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    s.edit(1, "lambert");
    s.scene.render.bounces = 1;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const Accumulation sums = renderer.reshade(64);
    EXPECT_GT(mean(sums.sum, s.scene.photo->labels, 1).x() / 64, 0.98f);
}

TEST(ReferenceRenderer, MirrorShowsTheEnvironmentOverItsPixel) {
    const Camera camera = squareCamera(24, 30);
    AnalyticScene s(camera, test::sphere(0.3f, 1));
    const auto radiance = [](const Vector3f& d) -> Vector3f {
        return Vector3f::Constant(1.5f) + 0.5f * (8 * d).array().sin().matrix();
    };
    s.setEnvironment(radiance);
    s.edit(1, "phong").values[0] = 1e5f;  // tails short enough for a bound on every pixel
    s.scene.render.bounces = 1;
    // Alone, the BRDF's samples all weigh the same; a bound on every pixel needs that.
    const ReferenceRenderer renderer(s.scene, s.analysis, LightSampling::BrdfOnly);
    constexpr int kSamples = 1024;
    const Accumulation sums = renderer.reshade(kSamples);
    // Mirrored light through image point (u, v), and the cosine there: 0 beside the sphere of radius 0.3 around (0, 0,
    // 1).
    const auto mirrored = [&](float u, float v) {
        const Vector3f d = camera.ray(u, v).normalized();
        const float root = d.z() * d.z() - 1 + 0.09f;
        if (root <= 0) return std::pair{Vector3f(0, 0, 0), 0.0f};
        const Vector3f n = (d * (d.z() - std::sqrt(root)) - Vector3f(0, 0, 1)) / 0.3f;
        return std::pair<Vector3f, float>{radiance(d - 2 * d.dot(n) * n), -d.dot(n)};
    };
    constexpr int kParts = 16;
    int checked = 0;
    float error = 0;
    float errorOfCenter = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            Vector3f expected = Vector3f::Zero();
            float steepest = 1;
            for (int part = 0; part < kParts * kParts; ++part) {
                const auto [light, cosine] =
                    mirrored(static_cast<float>(x) + (static_cast<float>(part % kParts) + 0.5f) / kParts,
                             static_cast<float>(y) + (static_cast<float>(part / kParts) + 0.5f) / kParts);
                expected += light / (kParts * kParts);
                steepest = std::min(steepest, cosine);
            }
            if (steepest < 0.5f) continue;
            const Vector3f actual = sums.sum(x, y) / kSamples;
            const Vector3f center = mirrored(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f).first;
            ASSERT_NEAR((actual - expected).cwiseAbs().maxCoeff(), 0, 0.05) << x << "," << y;
            error += (actual - expected).cwiseAbs().sum();
            errorOfCenter += (center - expected).cwiseAbs().sum();
            ++checked;
        }
    EXPECT_GT(checked, 100);
    EXPECT_LT(error, 0.5f * errorOfCenter);
    RecordProperty("error_over_center", std::to_string(error / errorOfCenter));
}

TEST(ReferenceRenderer, OneBounceFromAWallIsItsFormFactor) {
    // A white floor under a glowing wall, in the dark.
    const float wallZ = 2;
    const float floorY = 0.5f;
    const Camera camera = squareCamera(64, 64);
    AnalyticScene s(camera, [&](const Vector3f& ray) {
        AnalyticHit hit;
        const float z = ray.y() > 0 ? floorY / ray.y() : 1e9f;
        if (z < wallZ) {
            hit.label = 1;
            hit.front = z;
            hit.back = z * 1.01f;
            hit.frontNormal = Vector3f(0, -1, 0);
            hit.backNormal = Vector3f(0, 1, 0);
        } else {
            hit.label = 2;
            hit.front = wallZ;
            hit.back = wallZ + 0.05f;
            hit.color = Vector3f(1, 2, 4);
        }
        return hit;
    });
    s.edit(1, "lambert").albedo = Vector3f(0.5f, 0.5f, 0.5f);
    const ReferenceRenderer renderer(s.scene, s.analysis);
    constexpr int kSamples = 4000;
    for (const auto& [x, y] : {std::pair{32, 55}, {20, 60}, {40, 52}}) {
        Vector3f sum = Vector3f::Zero();
        for (std::uint32_t i = 0; i < kSamples; ++i) sum += renderer.pathRadiance(x, y, i);
        // Visible wall: |x| < wallZ/2, -wallZ/2 < y < floorY; its radiance integrated over the floor's hemisphere.
        const Vector3f p = s.analysis->front->position(x, y);
        double form = 0;
        constexpr int kGrid = 500;
        for (int i = 0; i < kGrid; ++i)
            for (int j = 0; j < kGrid; ++j) {
                const double wx = -1 + 2 * (i + 0.5) / kGrid;
                const double wy = -1 + 1.5 * (j + 0.5) / kGrid;
                const Eigen::Vector3d d(wx - p.x(), wy - p.y(), wallZ - p.z());
                const double r2 = d.squaredNorm();
                form += -d.y() * d.z() / (r2 * r2) / std::numbers::pi * (2.0 / kGrid) * (1.5 / kGrid);
            }
        const double hits = form * kSamples;
        const double tolerance = 4.5 * std::sqrt(hits) / kSamples + 0.01 * form;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(static_cast<double>(sum[c]) / kSamples, 0.5 * (1 << c) * form, 0.5 * (1 << c) * tolerance)
                << x << " " << y;
    }
}

/// Two facing slabs cannot be photographed, so: a mirror sphere before a wall, looked at from the camera side only.
TEST(ReferenceRenderer, PathsEndAtUneditedAndGoOnAtEditedAndGlossySegments) {
    const Camera camera = squareCamera(64, 64);
    AnalyticScene s(camera, [&](const Vector3f& ray) {
        AnalyticHit hit;
        const float z = ray.y() > 0 ? 0.5f / ray.y() : 1e9f;
        if (z < 2) {
            hit = {.front = z, .back = z * 1.01f, .frontNormal = {0, -1, 0}, .backNormal = {0, 1, 0}, .label = 1};
        } else {
            hit = {.front = 2, .back = 2.05f, .label = 2, .color = {8, 8, 8}};
        }
        return hit;
    });
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    s.edit(1, "lambert");
    const auto floorRadiance = [&] {
        const ReferenceRenderer renderer(s.scene, s.analysis);
        float sum = 0;
        for (std::uint32_t i = 0; i < 2000; ++i) sum += renderer.pathRadiance(32, 50, i).x() / 2000;
        return sum;
    };
    const float unedited = floorRadiance();
    EXPECT_GT(unedited, 1.5f) << "the wall's photograph colour, 8, reaches the floor";
    s.edit(2, "none");
    const float black = floorRadiance();
    EXPECT_LT(black, 1.0f) << "the wall became black: only the environment is left";
    s.edit(2, "lambert");
    EXPECT_NEAR(floorRadiance(), 1, 0.1) << "white everywhere under a white sky; walls end paths after four bounces";
    s.scene.render.bounces = 1;
    EXPECT_NEAR(floorRadiance(), unedited, 1e-4) << "one bounce, the paper: the wall shows its old colour";
    s.scene.render.bounces = 4;
    s.scene.findSegment(2)->edit.reset();
    s.scene.findSegment(2)->glossy = true;
    s.scene.findSegment(2)->reflectance = Vector3f(0, 0, 0);
    EXPECT_NEAR(floorRadiance(), black, 1e-4) << "a glossy wall of reflectance zero is black as well";
    s.scene.findSegment(2)->reflectance = Vector3f(1, 1, 1);
    EXPECT_GT(floorRadiance(), black + 0.02f);
    s.edit(2, "none").blendOriginal = 1;
    EXPECT_NEAR(floorRadiance(), unedited, 1e-4) << "black plus all of the photograph is the photograph";
}

TEST(ReferenceRenderer, MirrorsInterpolateWithinASurfaceAndNotBeyondIt) {
    // A mirror for a floor, before a wall that is bright from the 33rd column on: each column of the floor mirrors the
    // same column of the wall.
    const Camera camera = squareCamera(64, 64);
    const auto scene = [&](std::uint16_t rightLabel) {
        AnalyticScene s(camera, [&](const Vector3f& ray) {
            AnalyticHit hit;
            const float z = ray.y() > 0 ? 0.5f / ray.y() : 1e9f;
            if (z < 2)
                return AnalyticHit{.front = z, .back = z * 1.01f, .frontNormal = {0, -1, 0}, .backNormal = {0, 1, 0}};
            const bool right = ray.x() > 0;
            return AnalyticHit{.front = 2,
                               .back = 2.05f,
                               .label = right ? rightLabel : std::uint16_t{2},
                               .color = right ? Vector3f(1, 1, 1) : Vector3f(0, 0, 0)};
        });
        s.edit(1, "ggx").values[0] = 0.001f;
        return s;
    };
    const auto mirrored = [](const AnalyticScene& s, int x) {
        constexpr int kSamples = 4096;
        const ReferenceRenderer renderer(s.scene, s.analysis);
        double sum = 0;
        for (std::uint32_t i = 0; i < kSamples; ++i) sum += static_cast<double>(renderer.pathRadiance(x, 52, i).x());
        return sum / kSamples;
    };
    // Bilinear between centres, averaged over a column: an eighth comes from each neighbour.
    const AnalyticScene one = scene(2);
    EXPECT_NEAR(mirrored(one, 30), 0, 1e-6);
    EXPECT_NEAR(mirrored(one, 31), 0.125, 0.02);
    EXPECT_NEAR(mirrored(one, 32), 0.875, 0.02);
    EXPECT_NEAR(mirrored(one, 33), 1, 0.01);
    const AnalyticScene two = scene(3);
    EXPECT_NEAR(mirrored(two, 31), 0, 0.01) << "another segment";
    EXPECT_NEAR(mirrored(two, 32), 1, 0.01);
}

TEST(ReferenceTranslucency, FlatSlabInUniformLightReturnsTheDiffuseReflectance) {
    AnalyticScene s(squareCamera(64, 64), test::slab(1, 2));
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    Translucency t;
    t.sigmaSPrime = Vector3f(0.04f, 0.035f, 0.03f);  // 1/mm, so that pixels of 16 mm resolve the profile
    t.sigmaA = Vector3f(0.004f, 0.007f, 0.01f);
    t.eta = 1;
    s.edit(1, "none").translucency = t;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 12000, 3);
    const std::vector<Vector3f> light(samples.samples.size(), Vector3f::Constant(static_cast<float>(std::numbers::pi)));
    const ImageRgb b = renderer.translucentRadiosity(samples, light, 1, profileFromTranslucency(t));
    Vector3f sum = Vector3f::Zero();
    for (int y = 28; y < 36; ++y)
        for (int x = 28; x < 36; ++x) sum += b(x, y) / 64;
    const Vector3f expected = diffuseReflectance(t);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 0.02f * expected[c]) << c;
}

TEST(ReferenceTranslucency, OpaqueLimitIsALambertSurface) {
    // Free paths far below what samples resolve: light leaves where it entered, with the albedo of R_d's integral.
    AnalyticScene s(squareCamera(64, 64), test::slab(1, 2));
    Translucency t;
    t.sigmaSPrime = Vector3f(2000, 1000, 500);
    t.sigmaA = Vector3f(20, 100, 200);
    t.eta = 1;
    s.edit(1, "none").translucency = t;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 6000, 3);
    // Light that is brighter to the right, linearly: symmetric blur leaves it as it is.
    std::vector<Vector3f> light;
    for (const SurfaceSample& p : samples.samples)
        light.push_back(
            Vector3f::Constant(p.back ? 0 : static_cast<float>(std::numbers::pi) * (1 + 0.5f * p.position.x())));
    const ImageRgb b =
        renderer.translucentRadiosity(samples, light, 1, blurred(profileFromTranslucency(t), samples.areaPerSample()));
    const Vector3f albedo = diffuseReflectance(t);
    for (const int left : {16, 28, 40}) {
        Vector3f sum = Vector3f::Zero();
        Vector3f expected = Vector3f::Zero();
        for (int y = 28; y < 36; ++y)
            for (int x = left; x < left + 8; ++x) {
                sum += b(x, y) / 64;
                expected += albedo * ((1 + 0.5f * s.analysis->front->position(x, y).x()) / 64);
            }
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 0.02f * expected[c]) << left << " " << c;
    }
}

TEST(ReferenceTranslucency, ThinSlabGlowsWhenLitFromBehind) {
    Translucency t;
    t.sigmaSPrime = Vector3f(0.04f, 0.04f, 0.04f);
    t.sigmaA = Vector3f(0.0002f, 0.002f, 0.02f);
    t.eta = 1;
    const auto glow = [&](float thickness) -> Vector3f {
        AnalyticScene s(squareCamera(64, 64), test::slab(1, 1 + thickness));
        s.edit(1, "none").translucency = t;
        const ReferenceRenderer renderer(s.scene, s.analysis);
        const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 4000, 3);
        std::vector<Vector3f> light;
        for (const SurfaceSample& p : samples.samples)
            light.push_back(Vector3f::Constant(p.back ? static_cast<float>(std::numbers::pi) : 0));
        return renderer.translucentRadiosity(samples, light, 1, profileFromTranslucency(t))(32, 32);
    };
    const Vector3f thin = glow(0.05f);
    const Vector3f thick = glow(0.3f);
    const DiffusionProfile profile = profileFromTranslucency(t);
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(thin[c], 2 * thick[c]) << c;
        // All of R_d beyond the thickness: ∫ R_d(sqrt(r² + h²)) 2πr dr over the back.
        double expected = 0;
        for (int i = 0; i < 4000; ++i) {
            const double r = (i + 0.5) * 1e-3;
            expected += profile.evaluate(c, r * r + 0.05 * 0.05) * 2 * std::numbers::pi * r * 1e-3;
        }
        if (c > 0) {
            EXPECT_NEAR(static_cast<double>(thin[c]), expected, 0.05 * expected) << "the picture ends too soon for red";
        }
        EXPECT_LT(static_cast<double>(thin[c]), 1.02 * expected);
    }
    EXPECT_GT(thin.x(), thin.y());
    EXPECT_GT(thin.y(), thin.z()) << "what is absorbed least comes through most";
}

TEST(ReferenceTranslucency, SphereInUniformLightMatchesTheIntegral) {
    // On a sphere of radius R the area within chord r is πr², so the light leaving any point under uniform light is
    // ∫₀^2R R_d(r) 2πr dr exactly. Front and back both count: this pins the area factor (docs/deviations.md).
    const float radius = 0.1f;
    AnalyticScene s(squareCamera(96, 450), test::sphere(radius, 1.2f, Vector3f(1, 1, 1)));
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    Translucency t;
    t.sigmaSPrime = Vector3f(0.2f, 0.1f, 0.05f);
    t.sigmaA = Vector3f(0.002f, 0.0f, 0.001f);
    t.eta = 1;
    s.edit(1, "none").translucency = t;
    s.scene.render.surfaceSamples = 10000;
    s.scene.render.irradianceSamples = 4;
    const DiffusionProfile profile = profileFromTranslucency(t);
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 10000, 3);
    // The camera sees slightly less than half of the sphere; the back layer is the rest.
    EXPECT_NEAR(samples.area, 4 * std::numbers::pi * radius * radius, 0.02 * 4 * std::numbers::pi * radius * radius);

    const ReferenceRenderer renderer(s.scene, s.analysis);
    const ImageRgb result = renderer.translucency();
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
        const double r = 2.0 * radius * (i + 0.5) / kSteps;
        for (int c = 0; c < 3; ++c)
            expected[c] += profile.evaluate(c, r * r) * (2 * std::numbers::pi * r * 2 * radius / kSteps);
    }
    Vector3f sum = Vector3f::Zero();
    for (int y = 40; y < 56; ++y)
        for (int x = 40; x < 56; ++x) sum += result(x, y) / 256;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c], expected[c], 0.03 * expected[c]) << c;
        EXPECT_LT(sum[c], 1.0f) << "never brighter than white Lambert";
    }
}

/// A sheet of 2 cm thickness, folded like an accordion.
test::AnalyticHit foldedSheet(const Vector3f& ray) {
    constexpr float kPeriod = 0.25f;
    constexpr float kSlope = 3;
    const float u = std::abs(ray.x() / kPeriod - std::round(ray.x() / kPeriod));
    const float slope = (ray.x() / kPeriod > std::round(ray.x() / kPeriod)) ? kSlope : -kSlope;
    const float z = 1 + kSlope * kPeriod * u;
    // Along u the surface goes by (z, 0, 0) + slope * ray, along v by (0, z, 0).
    const Vector3f n = (Vector3f(z, 0, 0) + slope * ray).cross(Vector3f(0, z, 0)).normalized();
    return {.front = z,
            .back = z + 0.02f,
            .frontNormal = n.dot(ray) < 0 ? n : Vector3f(-n),
            .backNormal = n.dot(ray) < 0 ? Vector3f(-n) : n};
}

TEST(ReferenceTranslucency, NeverReflectsMoreThanItReceives) {
    AnalyticScene s(squareCamera(40, 40), foldedSheet);
    Translucency t;
    t.sigmaSPrime = Vector3f(0.2f, 0.05f, 0.05f);  // 1/mm
    t.sigmaA = Vector3f(0, 0, 0.01f);
    t.eta = 1;
    s.edit(1, "none").translucency = t;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 4000, 3);
    const DiffusionProfile profile = blurred(profileFromTranslucency(t), samples.areaPerSample());
    const auto brightest = [&](const std::vector<Vector3f>& light) {
        const ImageRgb b = renderer.translucentRadiosity(samples, light, 1, profile);
        Vector3f largest = Vector3f::Zero();
        for (std::size_t i = 0; i < b.size(); ++i) largest = largest.cwiseMax(b[i]);
        return largest;
    };
    // A half space's profile counts light twice here: on both sides of the sheet and across its folds.
    const std::vector<float> areas = sampleAreas(samples, samples.samples.size());
    const Vector3f p = s.analysis->front->position(20, 20);
    double whole = 0;
    for (std::size_t i = 0; i < areas.size(); ++i)
        whole += static_cast<double>(areas[i]) *
                 profile.evaluate(1, static_cast<double>((p - samples.samples[i].position).squaredNorm()));
    EXPECT_GT(whole, 1.5);

    std::vector<Vector3f> light(areas.size(), Vector3f::Constant(static_cast<float>(std::numbers::pi)));
    const Vector3f uniform = brightest(light);
    EXPECT_NEAR(uniform.x(), 1, 1e-5f) << "as bright as white, no brighter";
    EXPECT_NEAR(uniform.y(), 1, 1e-5f);
    EXPECT_LE(uniform.z(), 1 + 1e-5f);
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] *=
            samples.samples[i].position.x() > 0 ? 1.0f : kernel::rng_float(static_cast<kernel::uint>(i), 0, 0, 1);
    const Vector3f uneven = brightest(light);
    for (int c = 0; c < 3; ++c) EXPECT_LE(uneven[c], 1 + 1e-5f);
}

TEST(ReferenceTranslucency, SpreadOfSamplesDoesNotShow) {
    // Light gets less far than samples lie apart.
    AnalyticScene s(squareCamera(64, 64), test::slab(1, 2));
    Translucency t = toTranslucency(*findTranslucencyPreset("marble"));
    t.eta = 1;
    s.edit(1, "none").translucency = t;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 2000, 3);
    DiffusionProfile profile = blurred(profileFromTranslucency(t), samples.areaPerSample());
    std::vector<Vector3f> light(samples.samples.size(), Vector3f::Constant(static_cast<float>(std::numbers::pi)));
    const Vector3f reflectance = diffuseReflectance(t);
    const auto deviation = [&](const DiffusionProfile& p) {
        const ImageRgb b = renderer.translucentRadiosity(samples, light, 1, p);
        double squares = 0;
        for (int y = 16; y < 48; ++y)
            for (int x = 16; x < 48; ++x)
                squares += std::pow(static_cast<double>(b(x, y).y() / reflectance.y()) - 1, 2) / (32 * 32);
        return std::sqrt(squares);
    };
    EXPECT_LT(deviation(profile), 0.01);
    const double sampleArea = std::exchange(profile.sampleArea, 0);
    EXPECT_GT(deviation(profile), 0.03) << "what would show";
    profile.sampleArea = sampleArea;

    // A patch of light in the middle: in all, as much leaves as the reflectance says.
    const std::vector<float> areas = sampleAreas(samples, samples.samples.size());
    double arriving = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const SurfaceSample& p = samples.samples[i];
        const bool lit = !p.back && p.position.head<2>().cwiseAbs().maxCoeff() < 0.25f;
        if (lit)
            arriving += static_cast<double>(areas[i]);
        else
            light[i].setZero();
    }
    const ImageRgb b = renderer.translucentRadiosity(samples, light, 1, profile);
    for (int c = 0; c < 3; ++c) {
        double leaving = 0;
        for (std::size_t i = 0; i < b.size(); ++i)
            leaving += static_cast<double>(b[i][c]) * static_cast<double>(s.analysis->front->area[i]);
        EXPECT_LE(leaving, arriving) << c;
        EXPECT_NEAR(leaving / arriving, reflectance[c], 0.03) << c;
    }
}

TEST(ReferenceTranslucency, FresnelBoundaryDimsLightOnBothWays) {
    AnalyticScene s(squareCamera(64, 64), test::slab(1, 2));
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    s.edit(1, "none");
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const SurfaceSamples samples = sampleSurface(*s.analysis, s.scene.photo->labels, 1, 50, 3);
    const std::vector<Vector3f> matched = renderer.irradiance(samples, 1, 1.0f, 400);
    const std::vector<Vector3f> boundary = renderer.irradiance(samples, 1, 1.3f, 400);
    double sum = 0;
    for (std::size_t i = 0; i < matched.size(); ++i) {
        EXPECT_NEAR(matched[i].x(), std::numbers::pi, 1e-3);
        sum += static_cast<double>(boundary[i].x()) / static_cast<double>(matched.size());
    }
    // Mean transmission of diffuse light into the medium, by reciprocity from the inside value.
    EXPECT_NEAR(sum, std::numbers::pi * 1.69 * (1 - internalDiffuseFresnel(1.3)), 0.01);
}

}  // namespace
}  // namespace core
