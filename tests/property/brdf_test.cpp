// SPDX-License-Identifier: GPL-3.0-or-later
// Every BRDF of the registry, at several parameters and view directions: the list drives the tests, so a new BRDF
// arrives tested.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/brdf.h"
#include "shaders/brdf/brdf.h"
#include "shaders/shared/rng.h"
#include "tests/support/statistics.h"

namespace {

using kernel::vec2;
using kernel::vec3;
using std::numbers::pi;

constexpr double kViewAngles[] = {0, 25, 50, 70, 85};  // degrees

struct Case {
    kernel::BrdfParams brdf;
    vec3 wo;
    std::string name;
};

vec3 direction(double theta, double phi) {
    return {static_cast<float>(std::sin(theta) * std::cos(phi)), static_cast<float>(std::sin(theta) * std::sin(phi)),
            static_cast<float>(std::cos(theta))};
}

/// A white material of every BRDF, its first parameter at five values over the slider's range.
std::vector<Case> allCases() {
    std::vector<Case> cases;
    for (const core::BrdfInfo& info : core::brdfs()) {
        const int steps = info.params.empty() ? 1 : 5;
        for (int i = 0; i < steps; ++i)
            for (const double angle : kViewAngles) {
                core::Material m = core::defaultMaterial(info);
                m.albedo = m.specular.emplace(1, 1, 1);
                m.fresnel = core::Fresnel::None;
                if (steps > 1) {
                    const core::ParamInfo& p = info.params[0];
                    const float t = static_cast<float>(i) / static_cast<float>(steps - 1);
                    m.values[0] = p.logScale ? p.min * std::pow(p.max / p.min, t) : p.min + (p.max - p.min) * t;
                }
                std::string name = std::string(info.key) + "_" + std::to_string(i) + "_" +
                                   std::to_string(static_cast<int>(angle)) + "deg";
                cases.push_back({core::toKernel(m, core::Vector3f(1, 1, 1)), direction(angle * pi / 180, 0.7), name});
            }
    }
    return cases;
}

/// Integral of `f(wi)` over part of the upper hemisphere, refined around the mirror direction.
template <class F>
double integrateDirections(const F& f, const vec3& wo, double theta0, double theta1, double phi0, double phi1,
                           double tolerance) {
    const double mirrorTheta = std::acos(std::min(1.0, static_cast<double>(wo.z)));
    double mirrorPhi = std::atan2(-wo.y, -wo.x);
    if (mirrorPhi < 0) mirrorPhi += 2 * pi;
    const auto near = [&](double t0, double t1, double p0, double p1) {
        const bool phiInside = mirrorPhi >= p0 - 0.02 && mirrorPhi <= p1 + 0.02;
        return mirrorTheta >= t0 - 0.02 && mirrorTheta <= t1 + 0.02 && (phiInside || mirrorTheta < 0.05);
    };
    return test::integrate([&](double t, double p) { return f(direction(t, p)) * std::sin(t); }, theta0, theta1, phi0,
                           phi1, near, tolerance);
}

template <class F>
double integrateHemisphere(const F& f, const vec3& wo, double tolerance) {
    double sum = 0;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j)
            sum += integrateDirections(f, wo, i * pi / 32, (i + 1) * pi / 32, j * pi / 8, (j + 1) * pi / 8,
                                       tolerance / 256);
    return sum;
}

class EveryBrdf : public testing::TestWithParam<Case> {};

TEST_P(EveryBrdf, SamplesFollowThePdf) {
    const Case& c = GetParam();
    constexpr int kTheta = 12;
    constexpr int kPhi = 24;
    constexpr int kSamples = 100000;
    std::vector<double> observed(kTheta * kPhi + 1);
    for (int s = 0; s < kSamples; ++s) {
        const vec3 wi = kernel::brdf_sample(c.brdf, c.wo, kernel::rng_vec2(1, static_cast<kernel::uint>(s), 0, 99));
        ASSERT_NEAR(kernel::length(wi), 1, 1e-4);
        if (wi.z <= 0) {
            ++observed.back();
            continue;
        }
        const double theta = std::acos(std::min(1.0, static_cast<double>(wi.z)));
        double phi = std::atan2(wi.y, wi.x);
        if (phi < 0) phi += 2 * pi;
        const int i = std::min(kTheta - 1, static_cast<int>(theta / (pi / 2) * kTheta));
        const int j = std::min(kPhi - 1, static_cast<int>(phi / (2 * pi) * kPhi));
        ++observed[static_cast<std::size_t>(i * kPhi + j)];
    }
    std::vector<double> expected(observed.size());
    double total = 0;
    const auto pdf = [&](const vec3& wi) { return static_cast<double>(kernel::brdf_pdf(c.brdf, c.wo, wi)); };
    for (int i = 0; i < kTheta; ++i)
        for (int j = 0; j < kPhi; ++j) {
            const double p = integrateDirections(pdf, c.wo, i * pi / 2 / kTheta, (i + 1) * pi / 2 / kTheta,
                                                 j * 2 * pi / kPhi, (j + 1) * 2 * pi / kPhi, 1e-5);
            expected[static_cast<std::size_t>(i * kPhi + j)] = p * kSamples;
            total += p;
        }
    EXPECT_LE(total, 1 + 1e-3) << "the pdf integrates to more than one";
    expected.back() = std::max(1 - total, 0.0) * kSamples;
    EXPECT_GT(test::chiSquareP(observed, expected), test::sidak(0.01, static_cast<int>(allCases().size())));
}

TEST_P(EveryBrdf, ReflectsNoMoreThanItReceives) {
    const Case& c = GetParam();
    const double albedo = integrateHemisphere(
        [&](const vec3& wi) { return static_cast<double>(kernel::brdf_eval(c.brdf, c.wo, wi).x * wi.z); }, c.wo, 1e-3);
    EXPECT_LE(albedo, 1 + 1e-3);

    // The estimator used for rendering has the same mean.
    constexpr int kSamples = 20000;
    double sum = 0;
    double squared = 0;
    for (int s = 0; s < kSamples; ++s) {
        const vec3 wi = kernel::brdf_sample(c.brdf, c.wo, kernel::rng_vec2(2, static_cast<kernel::uint>(s), 0, 7));
        const double w = wi.z > 0 ? static_cast<double>(kernel::brdf_weight(c.brdf, c.wo, wi).x) : 0.0;
        sum += w;
        squared += w * w;
    }
    const double mean = sum / kSamples;
    const double sigma = std::sqrt(std::max(squared / kSamples - mean * mean, 0.0) / kSamples);
    EXPECT_NEAR(mean, albedo, 4.5 * sigma + 1e-3);
}

TEST_P(EveryBrdf, WeightIsEvalTimesCosineOverPdf) {
    const Case& c = GetParam();
    for (kernel::uint s = 0; s < 1000; ++s) {
        const vec3 wi = kernel::brdf_sample(c.brdf, c.wo, kernel::rng_vec2(3, s, 0, 7));
        const float pdf = kernel::brdf_pdf(c.brdf, c.wo, wi);
        if (wi.z <= 0) {
            ASSERT_EQ(pdf, 0) << "absorbed directions have no density";
            continue;
        }
        ASSERT_GT(pdf, 0);
        const double ratio = static_cast<double>(kernel::brdf_eval(c.brdf, c.wo, wi).x) * static_cast<double>(wi.z) /
                             static_cast<double>(pdf);
        ASSERT_NEAR(static_cast<double>(kernel::brdf_weight(c.brdf, c.wo, wi).x), ratio, 1e-3 * ratio + 1e-6);
    }
}

TEST_P(EveryBrdf, IsReciprocal) {
    const Case& c = GetParam();
    for (kernel::uint s = 0; s < 1000; ++s) {
        const vec3 wi = kernel::sample_cosine_hemisphere(kernel::rng_vec2(4, s, 0, 7));
        const double ab = static_cast<double>(kernel::brdf_eval(c.brdf, c.wo, wi).x);
        const double ba = static_cast<double>(kernel::brdf_eval(c.brdf, wi, c.wo).x);
        ASSERT_NEAR(ab, ba, 1e-4 * std::max(ab, ba) + 1e-12);
    }
}

TEST_P(EveryBrdf, IsZeroBelowTheHorizon) {
    const Case& c = GetParam();
    const vec3 below(0.6f, 0, -0.8f);
    for (const auto& [wo, wi] : {std::pair{c.wo, below}, std::pair{below, c.wo}}) {
        EXPECT_EQ(kernel::brdf_eval(c.brdf, wo, wi).x, 0);
        EXPECT_EQ(kernel::brdf_pdf(c.brdf, wo, wi), 0);
        EXPECT_EQ(kernel::brdf_weight(c.brdf, wo, wi).x, 0);
    }
    EXPECT_LE(kernel::brdf_sample(c.brdf, below, vec2(0.3f, 0.4f)).z, 0);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryBrdf, testing::ValuesIn(allCases()),
                         [](const auto& test) { return test.param.name; });

TEST(BrdfNumerics, FiniteAtGrazingAnglesExtremeParametersAndEveryCornerOfTheUnitSquare) {
    const float numbers[] = {0.0f, 1e-7f, 0.25f, 0.5f, 0.75f, 0.9999f, 0.99999994f};
    const float heights[] = {1.0f, 0.5f, 0.01f, 1e-4f, 1e-7f, 1e-20f};
    for (const core::BrdfInfo& info : core::brdfs())
        for (const float value : {0.0f, 1e-6f, 0.001f, 0.01f, 1.0f, 100.0f, 1e6f})
            for (const core::Fresnel fresnel :
                 {core::Fresnel::None, core::Fresnel::Schlick, core::Fresnel::Dielectric, core::Fresnel::Conductor}) {
                core::Material m;
                m.brdf = info.key;
                m.albedo = m.specular.emplace(1, 1, 1);
                m.fresnel = fresnel;
                m.k = core::Vector3f(0, 3, 7);
                m.values[0] = value;
                const kernel::BrdfParams b = core::toKernel(m, core::Vector3f(1, 1, 1));
                for (const float z : heights)
                    for (const float u : numbers)
                        for (const float v : numbers) {
                            const vec3 wo(std::sqrt(1 - z * z), 0, z);
                            const vec3 wi = kernel::brdf_sample(b, wo, vec2(u, v));
                            ASSERT_TRUE(std::isfinite(wi.x) && std::isfinite(wi.y) && std::isfinite(wi.z))
                                << info.key << " " << value << " z " << z << " u " << u << " " << v;
                            const vec3 w = kernel::brdf_weight(b, wo, wi);
                            for (const float x : {w.x, w.y, w.z})
                                ASSERT_TRUE(x >= 0 && x <= 1.001f)
                                    << info.key << " " << value << " z " << z << " u " << u << " " << v << ": " << x;
                            ASSERT_TRUE(std::isfinite(kernel::brdf_eval(b, wo, wi).x));
                            ASSERT_TRUE(std::isfinite(kernel::brdf_pdf(b, wo, wi)));
                        }
            }
}

/// Directional albedo of white GGX straight from the textbook formula, in double, by quadrature over half vectors:
/// ∫ D G1(i) G1(o) / (4 ci co) ci dω_i with dω_i = 4 (o·h) dω_h.
double ggxAlbedo(double alpha, double thetaO) {
    const auto g1 = [alpha](double c) {
        const double tan2 = (1 - c * c) / (c * c);
        return 2 / (1 + std::sqrt(1 + alpha * alpha * tan2));
    };
    const double ox = std::sin(thetaO);
    const double oz = std::cos(thetaO);
    constexpr int kRings = 4000;
    constexpr int kSectors = 256;
    double sum = 0;
    for (int i = 0; i < kRings; ++i) {
        const double u = (i + 0.5) / kRings;  // equal shares of D cos θ_h
        const double tan2 = alpha * alpha * u / (1 - u);
        const double hz = 1 / std::sqrt(1 + tan2);
        const double hr = std::sqrt(1 - hz * hz);
        for (int j = 0; j < kSectors; ++j) {
            const double hx = hr * std::cos(2 * pi * (j + 0.5) / kSectors);
            const double oh = ox * hx + oz * hz;
            const double iz = 2 * oh * hz - oz;
            if (oh <= 0 || iz <= 0) continue;
            sum += g1(iz) * g1(oz) * oh / (oz * hz);
        }
    }
    return sum / kRings / kSectors;
}

TEST(Furnace, WhiteGgxLosesExactlyTheSingleScatteringLoss) {
    for (const double alpha : {0.01, 0.05, 0.3, 0.6, 1.0})
        for (const double angle : {0.0, 45.0, 75.0}) {
            core::Material m = core::defaultMaterial(*core::findBrdf("ggx"));
            m.values[0] = static_cast<float>(alpha);
            m.fresnel = core::Fresnel::None;
            const kernel::BrdfParams b = core::toKernel(m, core::Vector3f(1, 1, 1));
            const vec3 wo = direction(angle * pi / 180, 2.0);
            constexpr int kSamples = 100000;
            double sum = 0;
            double squared = 0;
            for (kernel::uint s = 0; s < kSamples; ++s) {
                const vec3 wi = kernel::brdf_sample(b, wo, kernel::rng_vec2(5, s, 0, 3));
                const double w = wi.z > 0 ? static_cast<double>(kernel::brdf_weight(b, wo, wi).x) : 0.0;
                sum += w;
                squared += w * w;
            }
            const double mean = sum / kSamples;
            const double sigma = std::sqrt(std::max(squared / kSamples - mean * mean, 0.0) / kSamples);
            EXPECT_NEAR(mean, ggxAlbedo(alpha, angle * pi / 180), 4.5 * sigma + 3e-4) << alpha << " at " << angle;
        }
}

TEST(Furnace, WhiteLambertReturnsExactlyOne) {
    core::Material m = core::defaultMaterial(*core::findBrdf("lambert"));
    m.albedo = core::Vector3f(1, 1, 1);
    const kernel::BrdfParams b = core::toKernel(m, core::Vector3f(1, 1, 1));
    for (kernel::uint s = 0; s < 10000; ++s) {
        const vec3 wi = kernel::brdf_sample(b, vec3(0.6f, 0, 0.8f), kernel::rng_vec2(6, s, 0, 3));
        ASSERT_EQ(kernel::brdf_weight(b, vec3(0.6f, 0, 0.8f), wi).y, 1.0f);
    }
}

TEST(Furnace, SharpPhongIsAMirrorAtEveryAngle) {
    core::Material m = core::defaultMaterial(*core::findBrdf("phong"));
    m.values[0] = 1e5f;
    const kernel::BrdfParams b = core::toKernel(m, core::Vector3f(0.5f, 0.5f, 0.5f));
    for (const double angle : kViewAngles) {
        const vec3 wo = direction(angle * pi / 180, 1);
        double sum = 0;
        for (kernel::uint s = 0; s < 4000; ++s) {
            const vec3 wi = kernel::brdf_sample(b, wo, kernel::rng_vec2(7, s, 0, 3));
            if (wi.z > 0) sum += static_cast<double>(kernel::brdf_weight(b, wo, wi).x);
        }
        EXPECT_NEAR(sum / 4000, 0.5, 0.012) << angle;
    }
}

}  // namespace
