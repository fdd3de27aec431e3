// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/translucency.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "shaders/shared/rng.h"
#include "tests/support/statistics.h"

namespace core {
namespace {

/// ∫ R_d 2πr dr by the midpoint rule in log r, in double sums of the shared text.
Vector3f integrateProfile(const kernel::DipoleParams& d) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const double low = std::log(1e-7);
    const double high = std::log(1e4);
    constexpr int kSteps = 40000;
    for (int i = 0; i < kSteps; ++i) {
        const double r = std::exp(low + (high - low) * (i + 0.5) / kSteps);
        const kernel::vec3 rd = kernel::dipole_rd(d, static_cast<float>(r * r));
        sum += Eigen::Vector3d(rd.x, rd.y, rd.z) * (2 * M_PI * r * r);
    }
    return (sum * ((high - low) / kSteps)).cast<float>();
}

TEST(Dipole, IntegralIsTheClosedFormForEveryPreset) {
    for (const TranslucencyPreset& preset : translucencyPresets())
        for (const float eta : {1.0f, 1.3f, 1.5f}) {
            Translucency t = toTranslucency(preset);
            t.eta = eta;
            const kernel::DipoleParams d = dipoleFromTranslucency(t);
            const double fdr = internalDiffuseFresnel(static_cast<double>(eta));
            const double a = (1 + fdr) / (1 - fdr);
            const Vector3f integral = integrateProfile(d);
            for (int c = 0; c < 3; ++c) {
                const double sigmaS = static_cast<double>(preset.sigmaSPrime[c]);
                const double alpha = sigmaS / (sigmaS + static_cast<double>(preset.sigmaA[c]));
                const double s = std::sqrt(3 * (1 - alpha));
                const double closed = alpha / 2 * (1 + std::exp(-4.0 / 3.0 * a * s)) * std::exp(-s);
                EXPECT_NEAR(integral[c], closed, 2e-3 * closed) << preset.key << " channel " << c << " eta " << eta;
                EXPECT_NEAR(diffuseReflectance(t)[c], closed, 1e-5);
            }
        }
}

TEST(Dipole, BlurKeepsTheReflectanceAndHidesTheSamples) {
    for (const char* key : {"skin1", "marble", "ketchup"})
        for (const double spacing : {1e-5, 1e-3, 5e-3}) {
            const Translucency t = toTranslucency(*findTranslucencyPreset(key));
            SurfaceSamples samples;
            samples.samples.resize(1000);
            samples.area = 1000 * spacing * spacing;
            const kernel::DipoleParams blurred = smoothedFor(samples, dipoleFromTranslucency(t));
            const Vector3f total = diffuseReflectance(t);
            const Vector3f integral = integrateProfile(blurred);
            const kernel::vec3 peak = kernel::dipole_rd(blurred, 0);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(integral[c], total[c], 3e-3 * total[c]) << key << " " << spacing;
                const double atZero = static_cast<double>(c == 0 ? peak.x : c == 1 ? peak.y : peak.z);
                EXPECT_LE(atZero * spacing * spacing, 1.001 / (2 * M_PI) * total[c])
                    << "one sample with the light of its patch outshines the sum of all: " << key << " " << spacing;
            }
        }
}

TEST(Dipole, BlurIsAConvolution) {
    // R_d of a single source, convolved in the plane with the blur's own kernel by brute force: the kernel is that of a
    // source at depth 0 moved by δ, e^(σδ) δ (1+σd) e^(−σd)/(2π d³).
    const double z = 1e-3;
    const double sigma = 300;
    const double delta = 1.5e-3;
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
        sum *= side * side / kGrid / kGrid * std::exp(sigma * delta) / (2 * M_PI);
        const double blurred = static_cast<double>(kernel::dipole_source(
            static_cast<float>(z), static_cast<float>(sigma), static_cast<float>(delta), static_cast<float>(x * x)));
        EXPECT_NEAR(blurred, sum, 5e-3 * sum) << x;
    }
}

TEST(Dipole, DenseSamplesLeaveItSharp) {
    const kernel::DipoleParams exact = dipoleFromTranslucency(Translucency());
    EXPECT_EQ(smoothedFor({}, exact).zr.w, 0);
    EXPECT_EQ(kernel::dipole_blur(exact.sigmaTr.x, 0), 0);
    kernel::DipoleParams dense = exact;
    dense.zr.w = 1e-12f;
    EXPECT_NEAR(kernel::dipole_rd(dense, 0).x, kernel::dipole_rd(exact, 0).x, 0.01f * kernel::dipole_rd(exact, 0).x);
}

TEST(Dipole, HandComputedNumbers) {
    Translucency t;
    t.sigmaSPrime = Vector3f(0.9f, 0.9f, 0.9f);  // 1/mm
    t.sigmaA = Vector3f(0.1f, 0.1f, 0.1f);
    t.eta = 1;
    const kernel::DipoleParams d = dipoleFromTranslucency(t);
    EXPECT_NEAR(d.zr.x, 1e-3, 1e-9);                        // 1/σt' = 1 mm
    EXPECT_NEAR(d.zv.x, 7.0 / 3.0 * 1e-3, 1e-8);            // A = 1: z_r (1 + 4/3)
    EXPECT_NEAR(d.sigmaTr.x, std::sqrt(0.3) * 1000, 1e-2);  // sqrt(3 σa σt')
    EXPECT_NEAR(d.alphaPrime.x, 0.9, 1e-6);
    EXPECT_EQ(d.alphaPrime.w, 1);
    t.scale = 2;
    EXPECT_NEAR(dipoleFromTranslucency(t).zr.x, 0.5e-3, 1e-9) << "twice the size, half the free path relative to it";
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
    const kernel::DipoleParams d = dipoleFromTranslucency(t);
    for (const kernel::vec4& v : {d.zr, d.zv, d.sigmaTr, d.alphaPrime})
        for (const float x : {v.x, v.y, v.z}) EXPECT_TRUE(std::isfinite(x));
    const kernel::vec3 rd = kernel::dipole_rd(d, 1e-6f);
    EXPECT_TRUE(std::isfinite(rd.x + rd.y + rd.z));
}

TEST(TranslucencyPresets, AreThePublishedOnes) {
    EXPECT_EQ(translucencyPresets().size(), 12u);
    const TranslucencyPreset* marble = findTranslucencyPreset("Marble");
    ASSERT_NE(marble, nullptr);
    EXPECT_EQ(marble->sigmaSPrime[1], 2.62f);
    EXPECT_EQ(marble->sigmaA[2], 0.0071f);
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
    for (const float eta : {1.0f, 1.3f}) {
        const Vector3f color(0.05f, 0.5f, 0.95f);
        const Vector3f path(1, 5, 20);
        const Translucency t = translucencyFromDiffuse(color, path, eta);
        const kernel::DipoleParams d = dipoleFromTranslucency(t);
        const Vector3f reached = diffuseReflectance(t);
        EXPECT_NEAR((reached - color).cwiseAbs().maxCoeff(), 0, 2e-4);
        EXPECT_NEAR(1000 / d.sigmaTr.x, 1, 1e-3);
        EXPECT_NEAR(1000 / d.sigmaTr.y, 5, 5e-3);
        EXPECT_NEAR(1000 / d.sigmaTr.z, 20, 2e-2);
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

TEST(TranslucencySurfaceSampling, FollowsPatchAreaOnBothSides) {
    const Patches patches;
    std::vector<double> observed(2 * 37 * 23);
    double area = 0;
    const auto bin = [](int x, int y, bool back) {
        return static_cast<std::size_t>((y * 37 + x) * 2 + (back ? 1 : 0));
    };
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const SurfaceSamples s = sampleSurface(patches.analysis, patches.labels, 1, 97, seed);
        ASSERT_EQ(s.samples.size(), 97u);
        area = s.area;
        for (const SurfaceSample& p : s.samples) {
            ++observed[bin(p.x, p.y, p.back)];
            ASSERT_EQ(patches.labels(p.x, p.y), 1);
            ASSERT_EQ(p.position.z(), p.back ? 2.0f : 1.0f);
            ASSERT_EQ(p.normal.z(), p.back ? 1.0f : -1.0f);
        }
    }
    std::vector<double> expected(observed.size());
    double total = 0;
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 30; ++x)
            for (const bool back : {false, true}) total += expected[bin(x, y, back)] = patches.area(x, y, back);
    EXPECT_NEAR(area, total, 1e-6 * total);
    for (double& e : expected) e *= 400 * 97 / total;
    EXPECT_GT(test::chiSquareP(observed, expected), 0.01);
}

TEST(TranslucencySurfaceSampling, IsStratifiedAndRepeatable) {
    const Patches patches;
    const SurfaceSamples a = sampleSurface(patches.analysis, patches.labels, 1, 20000, 5);
    const SurfaceSamples b = sampleSurface(patches.analysis, patches.labels, 1, 20000, 5);
    std::map<std::pair<int, bool>, double> counts;
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        ASSERT_EQ(a.samples[i].position, b.samples[i].position);
        ++counts[{a.samples[i].y * 37 + a.samples[i].x, a.samples[i].back}];
    }
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 30; ++x)
            for (const bool back : {false, true})
                EXPECT_NEAR((counts[{y * 37 + x, back}]), 20000 * patches.area(x, y, back) / a.area, 2)
                    << x << " " << y;
}

TEST(TranslucencySurfaceSampling, NothingToSample) {
    const Patches patches;
    EXPECT_TRUE(sampleSurface(patches.analysis, patches.labels, 9, 100, 1).samples.empty());
    EXPECT_EQ(sampleSurface(patches.analysis, patches.labels, 9, 100, 1).area, 0);
    EXPECT_TRUE(sampleSurface(patches.analysis, patches.labels, 1, 0, 1).samples.empty());
}

}  // namespace
}  // namespace core
