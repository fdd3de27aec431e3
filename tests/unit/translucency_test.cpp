// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/translucency.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/material/diffusion_profile.h"
#include "core/shading/surface_samples.h"
#include "shaders/brdf/fresnel.h"
#include "shaders/shared/rng.h"
#include "tests/support/statistics.h"

namespace core {
namespace {

/// ∫ R_d 2πr dr by the midpoint rule in log r.
double integrateProfile(const DiffusionProfile& profile, int channel) {
    double sum = 0;
    const double low = std::log(1e-7);
    const double high = std::log(1e4);
    constexpr int kSteps = 40000;
    for (int i = 0; i < kSteps; ++i) {
        const double r = std::exp(low + (high - low) * (i + 0.5) / kSteps);
        sum += profile.evaluate(channel, r * r) * (2 * std::numbers::pi * r * r);
    }
    return sum * ((high - low) / kSteps);
}

TEST(Dipole, IntegralIsTheClosedFormForEveryPreset) {
    for (const TranslucencyPreset& preset : translucencyPresets())
        for (const float eta : {1.0f, 1.3f, 1.5f}) {
            Translucency t = toTranslucency(preset);
            t.eta = eta;
            const DiffusionProfile profile = profileFromTranslucency(t);
            const double fdr = internalDiffuseFresnel(static_cast<double>(eta));
            const double a = (1 + fdr) / (1 - fdr);
            for (int c = 0; c < 3; ++c) {
                const auto sigmaS = static_cast<double>(preset.sigmaSPrime[c]);
                const double alpha = sigmaS / (sigmaS + static_cast<double>(preset.sigmaA[c]));
                const double s = std::sqrt(3 * (1 - alpha));
                const double closed = alpha / 2 * (1 + std::exp(-4.0 / 3.0 * a * s)) * std::exp(-s);
                EXPECT_NEAR(integrateProfile(profile, c), closed, 1e-3 * closed) << preset.key << c << " eta " << eta;
                EXPECT_NEAR(profile.integral(c), closed, 1e-9);
                EXPECT_NEAR(static_cast<double>(diffuseReflectance(t)[c]), closed, 1e-5);
            }
        }
}

TEST(Dipole, BlurKeepsTheReflectanceAndHidesTheSamples) {
    for (const char* key : {"skin1", "marble", "ketchup"})
        for (const double spacing : {1e-5, 1e-3, 5e-3}) {
            const Translucency t = toTranslucency(*findTranslucencyPreset(key));
            const DiffusionProfile profile = blurred(profileFromTranslucency(t), spacing * spacing);
            for (int c = 0; c < 3; ++c) {
                const auto total = static_cast<double>(diffuseReflectance(t)[c]);
                EXPECT_NEAR(integrateProfile(profile, c), total, 1e-3 * total) << key << " " << spacing;
                EXPECT_LE(profile.evaluate(c, 0) * spacing * spacing, 1.001 / (2 * std::numbers::pi) * total)
                    << "one sample with the light of its patch outshines the sum of all: " << key << " " << spacing;
            }
        }
}

TEST(Dipole, BlurIsAConvolution) {
    // R_d of a single source, convolved in the plane with the blur's own kernel by brute force: the kernel is that of a
    // source at depth 0 moved by δ, e^(σδ) δ (1+σd) e^(−σd)/(2π d³).
    const double z = 1e-3;
    const double sigma = 300;
    const double area = 1e-6;
    DiffusionProfile source;
    source.terms[0] = {{.z = z, .sigma = sigma, .flux = 1}};
    const DiffusionProfile moved = blurred(source, area);
    const double delta = moved.terms[0][0].shift;
    EXPECT_NEAR((1 + sigma * delta) / (2 * std::numbers::pi * delta * delta), 1 / (2 * std::numbers::pi * area),
                1e-6 / area);
    const auto profile = [&](double depth, double r2) {
        const double d = std::sqrt(r2 + depth * depth);
        return depth * (1 + sigma * d) * std::exp(-sigma * d) / (d * d * d);
    };
    for (const double x : {0.0, 1e-3, 4e-3}) {
        double sum = 0;
        constexpr int kGrid = 800;
        const double side = 0.04;
        for (int i = 0; i < kGrid; ++i)
            for (int j = 0; j < kGrid; ++j) {
                const double u = side * ((i + 0.5) / kGrid - 0.5);
                const double v = side * ((j + 0.5) / kGrid - 0.5);
                sum += profile(z, u * u + v * v) * profile(delta, (x - u) * (x - u) + v * v);
            }
        sum *= side * side / kGrid / kGrid * std::exp(sigma * delta) / (2 * std::numbers::pi);
        EXPECT_NEAR(moved.evaluate(0, x * x), sum, 5e-3 * sum) << x;
    }
}

TEST(Dipole, DenseSamplesLeaveItSharp) {
    const DiffusionProfile exact = profileFromTranslucency(Translucency());
    EXPECT_EQ(blurred(exact, 0).evaluate(0, 1e-6), exact.evaluate(0, 1e-6));
    EXPECT_NEAR(blurred(exact, 1e-12).evaluate(0, 0), exact.evaluate(0, 0), 0.01 * exact.evaluate(0, 0));
}

TEST(Dipole, HandComputedNumbers) {
    Translucency t;
    t.sigmaSPrime = Vector3f(0.9f, 0.9f, 0.9f);  // 1/mm
    t.sigmaA = Vector3f(0.1f, 0.1f, 0.1f);
    t.eta = 1;
    const std::vector<DiffusionProfile::Term> d = profileFromTranslucency(t).terms[0];
    ASSERT_EQ(d.size(), 2u);
    EXPECT_NEAR(d[0].z, 1e-3, 1e-9);                           // 1/σt' = 1 mm
    EXPECT_NEAR(d[1].z, 7.0 / 3.0 * 1e-3, 1e-8);               // A = 1: z_r (1 + 4/3)
    EXPECT_NEAR(d[1].sigma, std::sqrt(0.3) * 1000, 1e-2);      // sqrt(3 σa σt')
    EXPECT_NEAR(d[1].flux * 4 * std::numbers::pi, 0.9, 1e-6);  // α'
    EXPECT_EQ(profileFromTranslucency(t).eta, 1);
    t.scale = 2;
    EXPECT_NEAR(profileFromTranslucency(t).terms[0][0].z, 0.5e-3, 1e-9)
        << "twice the size, half the free path relative to it";
}

TEST(Dipole, BoundaryTermAgreesWithDirectIntegration) {
    EXPECT_EQ(internalDiffuseFresnel(1), 0);
    for (const double eta : {0.8, 1.1, 1.3, 1.5, 2.0}) {
        // From inside: relative index 1/eta, total internal reflection included.
        double sum = 0;
        constexpr int kSteps = 200000;
        for (int i = 0; i < kSteps; ++i) {
            const double c = (i + 0.5) / kSteps;
            const double sinT = std::sqrt(1 - c * c) * eta;
            double f = 1;
            if (sinT < 1) {
                const double t = std::sqrt(1 - sinT * sinT);
                const double s = (eta * c - t) / (eta * c + t);
                const double p = (c - eta * t) / (c + eta * t);
                f = 0.5 * (s * s + p * p);
            }
            sum += f * c;
        }
        EXPECT_NEAR(internalDiffuseFresnel(eta), 2 * sum / kSteps, 1e-4) << eta;
    }
}

TEST(Dipole, BoundaryTermIsNearThePublishedFit) {
    for (const double eta : {1.1, 1.3, 1.5, 2.0})
        EXPECT_NEAR(internalDiffuseFresnel(eta), -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta, 0.002);
}

TEST(Dipole, TransmissionIsOneForAnIndexMatchedBoundary) {
    for (const float c : {0.0f, 0.01f, 0.5f, 1.0f}) EXPECT_EQ(kernel::fresnel_transmission(1, c), 1.0f);
    EXPECT_NEAR(kernel::fresnel_transmission(1.5f, 1), 0.96f, 1e-6f);
    EXPECT_EQ(kernel::fresnel_transmission(1.5f, 0), 0.0f);
}

TEST(Dipole, UnphysicalCoefficientsStayFinite) {
    Translucency t;
    t.sigmaA = Vector3f(-1, NAN, 0);
    t.sigmaSPrime = Vector3f(0, -2, INFINITY);
    t.eta = NAN;
    t.scale = 0;
    const DiffusionProfile profile = profileFromTranslucency(t);
    const DiffusionProfile smooth = blurred(profile, 1e-6);
    for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::isfinite(profile.evaluate(c, 1e-6)));
        EXPECT_TRUE(std::isfinite(smooth.evaluate(c, 1e-6)));
    }
}

TEST(BetterDipole, IntegralIsTheSumOverThePlane) {
    for (const char* key : {"marble", "ketchup", "skin1", "spectralon"})
        for (const float eta : {1.0f, 1.5f}) {
            Translucency t = toTranslucency(*findTranslucencyPreset(key));
            t.eta = eta;
            t.model = ScatteringModel::BetterDipole;
            const DiffusionProfile profile = profileFromTranslucency(t);
            const DiffusionProfile smooth = blurred(profile, 1e-6);
            for (int c = 0; c < 3; ++c) {
                const double total = profile.integral(c);
                EXPECT_GT(total, 0);
                EXPECT_LT(total, 1);
                // Without absorption the tail reaches farther than this sum.
                if (key != std::string("spectralon")) {
                    EXPECT_NEAR(integrateProfile(profile, c), total, 2e-3 * total) << key;
                }
                EXPECT_NEAR(smooth.integral(c), total, 1e-6) << "blurring keeps the light";
            }
        }
}

TEST(BetterDipole, IsNearerToRandomWalksThanTheDipole) {
    // A beam straight down into a half space without boundary, isotropic scattering, free paths of length 1: the light
    // that returns at distance r after two events and more.
    for (const double alpha : {0.5, 0.8, 0.95}) {
        constexpr int kWalks = 60000;
        constexpr double kWidth = 0.5;
        std::array<double, 16> light{};
        double total = 0;
        std::mt19937 random(5);
        std::uniform_real_distribution<double> uniform;
        for (int i = 0; i < kWalks; ++i) {
            Eigen::Vector3d p(0, 0, -std::log(1 - uniform(random)));
            double weight = 1;
            for (int event = 1; weight > 1e-4; ++event) {
                weight *= alpha;
                const double mu = 2 * uniform(random) - 1;
                const double phi = 2 * std::numbers::pi * uniform(random);
                const Eigen::Vector3d d(std::sqrt(1 - mu * mu) * std::cos(phi), std::sqrt(1 - mu * mu) * std::sin(phi),
                                        mu);
                if (mu < 0) {  // what reaches the surface from here leaves
                    const double leaving = weight * std::exp(p.z() / mu);
                    const double r = (p - d * (p.z() / mu)).head<2>().norm();
                    weight -= leaving;
                    if (event >= 2) {
                        total += leaving;
                        if (r < kWidth * 16) light[static_cast<std::size_t>(r / kWidth)] += leaving;
                    }
                    // The rest stays below: a free path that ends before the surface.
                    const double free = -std::log(1 - uniform(random) * (1 - std::exp(p.z() / mu)));
                    p += free * d;
                } else {
                    p += -std::log(1 - uniform(random)) * d;
                }
            }
        }
        const auto distance = [&](ScatteringModel model) {
            const DiffusionProfile profile = halfSpaceProfile(alpha, 1 - alpha, model, diffuseBoundary(model, 1));
            double sum = 0;
            for (std::size_t ring = 0; ring < light.size(); ++ring) {
                double expected = 0;
                for (int i = 0; i < 20; ++i) {
                    const double r = kWidth * (static_cast<double>(ring) + (i + 0.5) / 20);
                    expected += profile.evaluate(0, r * r) * 2 * std::numbers::pi * r * kWidth / 20;
                }
                sum += std::abs(expected - light[ring] / kWalks);
            }
            return sum / (total / kWalks);
        };
        EXPECT_LT(distance(ScatteringModel::BetterDipole), distance(ScatteringModel::Dipole)) << alpha;
    }
}

TEST(TranslucencyPresets, AreThePublishedOnes) {
    EXPECT_EQ(translucencyPresets().size(), 12u);
    const TranslucencyPreset* marble = findTranslucencyPreset("Marble");
    ASSERT_NE(marble, nullptr);
    EXPECT_EQ(marble->sigmaSPrime[1], 2.62f);
    EXPECT_EQ(marble->sigmaA[2], 0.0071f);
    EXPECT_EQ(marble->eta, 1.5f);
    EXPECT_EQ(toTranslucency(*findTranslucencyPreset("apple")).eta, 1.3f);
    EXPECT_EQ(findTranslucencyPreset("marbles"), nullptr);
    // Diffuse reflectances printed in the paper's table: ketchup is red, skimmed milk nearly white.
    const Vector3f ketchup = diffuseReflectance(toTranslucency(*findTranslucencyPreset("ketchup")));
    EXPECT_NEAR(ketchup.x(), 0.16f, 0.02f);
    EXPECT_NEAR(ketchup.y(), 0.01f, 0.01f);
    const Vector3f milk = diffuseReflectance(toTranslucency(*findTranslucencyPreset("skimmilk")));
    EXPECT_NEAR(milk.x(), 0.81f, 0.02f);
    EXPECT_NEAR(milk.y(), 0.81f, 0.02f);
    EXPECT_NEAR(milk.z(), 0.69f, 0.02f);
}

TEST(TranslucencyFromDiffuse, RoundTrips) {
    for (const float eta : {1.0f, 1.3f})
        for (const ScatteringModel model : {ScatteringModel::Dipole, ScatteringModel::BetterDipole}) {
            // The better dipole leaves out light that was scattered once, so it cannot be as bright.
            const Vector3f color(0.05f, 0.5f, model == ScatteringModel::Dipole ? 0.95f : 0.8f);
            const Vector3f path(1, 5, 20);
            const Translucency t = translucencyFromDiffuse(color, path, eta, model);
            EXPECT_NEAR((diffuseMeanFreePath(t) - path).cwiseQuotient(path).cwiseAbs().maxCoeff(), 0, 2e-3f);
            const DiffusionProfile profile = profileFromTranslucency(t);
            const Vector3f reached = diffuseReflectance(t);
            EXPECT_NEAR((reached - color).cwiseAbs().maxCoeff(), 0, 2e-4);
            EXPECT_NEAR(1000 / profile.terms[0][0].sigma, 1, 1e-3);
            EXPECT_NEAR(1000 / profile.terms[1][0].sigma, 5, 5e-3);
            EXPECT_NEAR(1000 / profile.terms[2][0].sigma, 20, 2e-2);
        }
}

TEST(TranslucencyFromDiffuse, AcceptsTheExtremes) {
    const Translucency t = translucencyFromDiffuse(Vector3f(0, 1, 7), Vector3f(0, 1, 1e6f), 1.3f);
    for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::isfinite(t.sigmaA[c]) && t.sigmaA[c] >= 0);
        EXPECT_TRUE(std::isfinite(t.sigmaSPrime[c]) && t.sigmaSPrime[c] >= 0);
    }
    EXPECT_LT(diffuseReflectance(t).x(), 1e-3f);
    EXPECT_GT(diffuseReflectance(t).y(), 0.98f);
}

/// A segment of random patch areas over several magnitudes, a second segment, and pixels without surface.
struct Patches {
    Analysis analysis;
    LabelImage labels{37, 23};
    Patches() {
        Surface front{.depth = ImageF(37, 23, 1.0f),
                      .normal = ImageV3(37, 23, Vector3f(0, 0, -1)),
                      .position = ImageV3(37, 23),
                      .area = ImageF(37, 23),
                      .color = ImageRgb(37, 23)};
        Surface back = front;
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 37; ++x) {
                const auto i = static_cast<kernel::uint>(front.area.index(x, y));
                labels(x, y) = x < 30 ? 1 : 2;
                front.area(x, y) = std::exp(6 * kernel::rng_float(i, 0, 0, 1));
                back.area(x, y) = std::exp(6 * kernel::rng_float(i, 0, 1, 1));
                front.position(x, y) = Vector3f(static_cast<float>(x), static_cast<float>(y), 1);
                back.position(x, y) = Vector3f(static_cast<float>(x), static_cast<float>(y), 2);
                back.normal(x, y) = Vector3f(0, 0, 1);
            }
        front.area(3, 3) = 0;
        front.area(4, 4) = NAN;
        analysis.front = std::make_shared<Surface>(front);
        analysis.back = std::make_shared<Surface>(back);
    }
    [[nodiscard]] double area(int x, int y, bool back) const {
        const auto a = static_cast<double>((back ? analysis.back : analysis.front)->area(x, y));
        return std::isfinite(a) ? a : 0;
    }
};

TEST(TranslucencySurfaceSampling, EveryPrefixFollowsPatchAreaOnBothSides) {
    constexpr int kSeeds = 400;
    constexpr std::size_t kCount = 97;
    const Patches patches;
    const auto bin = [](int x, int y, bool back) {
        return static_cast<std::size_t>((y * 37 + x) * 2 + (back ? 1 : 0));
    };
    std::vector<double> share(2 * 37 * 23);
    double total = 0;
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 30; ++x)
            for (const bool back : {false, true}) total += share[bin(x, y, back)] = patches.area(x, y, back);
    // Also the samples that a larger set has more than a smaller one, by themselves.
    const std::pair<std::size_t, std::size_t> ranges[] = {{0, 1}, {0, 10}, {0, 33}, {10, 64}, {64, 97}, {0, kCount}};
    std::vector<std::vector<double>> observed(std::size(ranges), std::vector<double>(share.size()));
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const SurfaceSamples s = sampleSurface(patches.analysis, patches.labels, 1, kCount, seed);
        ASSERT_EQ(s.samples.size(), kCount);
        EXPECT_NEAR(s.area, total, 1e-6 * total);
        for (std::size_t i = 0; i < kCount; ++i) {
            const SurfaceSample& p = s.samples[i];
            ASSERT_EQ(patches.labels(p.x, p.y), 1);
            ASSERT_EQ(p.position.z(), p.back ? 2.0f : 1.0f);
            ASSERT_EQ(p.normal.z(), p.back ? 1.0f : -1.0f);
            for (std::size_t r = 0; r < std::size(ranges); ++r)
                if (i >= ranges[r].first && i < ranges[r].second) ++observed[r][bin(p.x, p.y, p.back)];
        }
    }
    for (std::size_t r = 0; r < std::size(ranges); ++r) {
        std::vector<double> expected = share;
        for (double& e : expected) e *= kSeeds * static_cast<double>(ranges[r].second - ranges[r].first) / total;
        EXPECT_GT(test::chiSquareP(observed[r], expected), 0.01) << ranges[r].first << " to " << ranges[r].second;
    }
}

TEST(TranslucencySurfaceSampling, IsProgressiveAndSpreadsEvenly) {
    const Patches patches;
    const SurfaceSamples all = sampleSurface(patches.analysis, patches.labels, 1, 20000, 5);
    for (const int count : {1, 100, 1500, 7000}) {
        const SurfaceSamples few = sampleSurface(patches.analysis, patches.labels, 1, count, 5);
        for (std::size_t i = 0; i < few.samples.size(); ++i)
            ASSERT_EQ(few.samples[i].position, all.samples[i].position) << count;
    }
    for (const std::size_t count : {512u, 3000u, 16384u, 20000u}) {
        std::map<std::pair<int, bool>, double> counts;
        for (std::size_t i = 0; i < count; ++i)
            ++counts[{all.samples[i].y * 37 + all.samples[i].x, all.samples[i].back}];
        // An interval of the sequence has a count within log2(count)/2 + 1 of its share; random samples of its root.
        const double bound = 0.5 * std::log2(static_cast<double>(count)) + 1;
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 30; ++x)
                for (const bool back : {false, true})
                    EXPECT_NEAR((counts[{y * 37 + x, back}]),
                                static_cast<double>(count) * patches.area(x, y, back) / all.area, bound)
                        << count << ": " << x << " " << y;
    }
}

TEST(TranslucencySurfaceSampling, NeighboursInTheOrderOfTheCurveAreNear) {
    // 64x64 patches of the same area, as many samples: close to one in each 4x4 block's worth of 16.
    Analysis analysis;
    Surface layer{.depth = ImageF(64, 64, 1.0f),
                  .normal = ImageV3(64, 64, Vector3f(0, 0, -1)),
                  .position = ImageV3(64, 64),
                  .area = ImageF(64, 64, 1.0f),
                  .color = ImageRgb(64, 64)};
    analysis.front = std::make_shared<Surface>(layer);
    layer.area = ImageF(64, 64, 0.0f);
    analysis.back = std::make_shared<Surface>(layer);
    const SurfaceSamples s = sampleSurface(analysis, LabelImage(64, 64, 1), 1, 4096, 2);
    std::map<std::pair<int, int>, int> blocks;
    for (const SurfaceSample& p : s.samples) ++blocks[{p.x / 4, p.y / 4}];
    ASSERT_EQ(blocks.size(), 256u);
    for (const auto& [block, count] : blocks) EXPECT_EQ(count, 16) << block.first << " " << block.second;
}

TEST(TranslucencySurfaceSampling, AreasOfAnyPrefixAreTheSurface) {
    const Patches patches;
    const SurfaceSamples samples = sampleSurface(patches.analysis, patches.labels, 1, 1000, 5);
    for (const std::size_t count : {1UL, 3UL, 64UL, 1000UL}) {
        const std::vector<float> areas = sampleAreas(samples, count);
        ASSERT_EQ(areas.size(), count);
        double sum = 0;
        for (const float a : areas) {
            EXPECT_GT(a, 0);
            // A sample's neighbours along a scrambled sequence are at most two strata away.
            EXPECT_LT(static_cast<double>(a), 4 * samples.area / static_cast<double>(count));
            sum += static_cast<double>(a);
        }
        EXPECT_NEAR(sum, samples.area, 1e-5 * samples.area);
    }
    EXPECT_TRUE(sampleAreas(SurfaceSamples(), 10).empty());
}

TEST(TranslucencySurfaceSampling, NothingToSample) {
    const Patches patches;
    EXPECT_TRUE(sampleSurface(patches.analysis, patches.labels, 9, 100, 1).samples.empty());
    EXPECT_EQ(sampleSurface(patches.analysis, patches.labels, 9, 100, 1).area, 0);
    EXPECT_TRUE(sampleSurface(patches.analysis, patches.labels, 1, 0, 1).samples.empty());
}

}  // namespace
}  // namespace core
