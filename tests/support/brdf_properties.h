// SPDX-License-Identifier: GPL-3.0-or-later
// Properties required of every BRDF, as checks of one BRDF from one view direction.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "shaders/brdf/brdf.h"
#include "shaders/shared/rng.h"
#include "tests/support/statistics.h"

namespace test {

using kernel::vec2;
using kernel::vec3;
using std::numbers::pi;

/// A BRDF and a view direction.
struct BrdfCase {
    kernel::BrdfParams brdf;
    vec3 wo;
    std::string name;
};

inline vec3 direction(double theta, double phi) {
    return {static_cast<float>(std::sin(theta) * std::cos(phi)), static_cast<float>(std::sin(theta) * std::sin(phi)),
            static_cast<float>(std::cos(theta))};
}

/// Integral of `f(wi)` over part of the upper hemisphere, refined around the mirror direction.
template <class F>
double integrateDirections(const F& f, const vec3& wo, double theta0, double theta1, double phi0, double phi1,
                           double tolerance) {
    const double mirrorTheta = std::acos(std::min(1.0, static_cast<double>(wo.z)));
    double mirrorPhi = std::atan2(-wo.y, -wo.x);
    if (mirrorPhi < 0) mirrorPhi += 2 * pi;
    // Lobes are narrowest across the plane of incidence at grazing angles, and long when anisotropic.
    const auto within = [&](double margin, double t0, double t1, double p0, double p1) {
        const bool phiInside = mirrorPhi >= p0 - margin && mirrorPhi <= p1 + margin;
        return mirrorTheta >= t0 - margin && mirrorTheta <= t1 + margin && (phiInside || mirrorTheta < 0.05);
    };
    const auto near = [&](double t0, double t1, double p0, double p1) {
        const double size = std::max(t1 - t0, p1 - p0);
        return (size > 0.006 && within(0.02, t0, t1, p0, p1)) || (size > 0.06 && within(0.3, t0, t1, p0, p1));
    };
    return integrate([&](double t, double p) { return f(direction(t, p)) * std::sin(t); }, theta0, theta1, phi0, phi1,
                     near, tolerance);
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

/// Chi-squared test of 100 000 samples; fails below the probability `significance`.
inline void expectSamplesFollowThePdf(const BrdfCase& c, double significance) {
    constexpr int kTheta = 12;
    constexpr int kPhi = 24;
    constexpr int kSamples = 100000;
    std::vector<double> observed(kTheta * kPhi + 1);
    for (int s = 0; s < kSamples; ++s) {
        const vec3 wi = kernel::brdf_sample(c.brdf, c.wo, kernel::rng_vec2(1, static_cast<kernel::uint>(s), 0, 77));
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
    EXPECT_GT(chiSquareP(observed, expected), significance);
}

/// Directional albedo by quadrature, and the estimator used for rendering against it.
inline void expectReflectsNoMoreThanItReceives(const BrdfCase& c) {
    const double albedo = integrateHemisphere(
        [&](const vec3& wi) { return static_cast<double>(kernel::brdf_eval(c.brdf, c.wo, wi).x * wi.z); }, c.wo, 1e-2);
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

/// The closed form of the weight.
inline void expectWeightIsEvalTimesCosineOverPdf(const BrdfCase& c) {
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

/// f(wo, wi) = f(wi, wo).
inline void expectIsReciprocal(const BrdfCase& c) {
    for (kernel::uint s = 0; s < 1000; ++s) {
        const vec3 wi = kernel::sample_cosine_hemisphere(kernel::rng_vec2(4, s, 0, 7));
        const double ab = static_cast<double>(kernel::brdf_eval(c.brdf, c.wo, wi).x);
        const double ba = static_cast<double>(kernel::brdf_eval(c.brdf, wi, c.wo).x);
        ASSERT_NEAR(ab, ba, 1e-4 * std::max(ab, ba) + 1e-12);
    }
}

/// Below the horizon, on either side.
inline void expectIsZeroBelowTheHorizon(const BrdfCase& c) {
    const vec3 below(0.6f, 0, -0.8f);
    for (const auto& [wo, wi] : {std::pair{c.wo, below}, std::pair{below, c.wo}}) {
        EXPECT_EQ(kernel::brdf_eval(c.brdf, wo, wi).x, 0);
        EXPECT_EQ(kernel::brdf_pdf(c.brdf, wo, wi), 0);
        EXPECT_EQ(kernel::brdf_weight(c.brdf, wo, wi).x, 0);
    }
    EXPECT_LE(kernel::brdf_sample(c.brdf, below, vec2(0.3f, 0.4f)).z, 0);
}

}  // namespace test
