// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/directional_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using core::DirectionalMap;
using core::ImageRgb;
using core::Vector3f;

/// Radiance 1 + d·axis: every mean over the sphere is 1.
ImageRgb gradient(int height, const Vector3f& axis) {
    ImageRgb map(2 * height, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x)
            map(x, y) = Vector3f::Constant(
                1 + axis.dot(DirectionalMap::directionFromTexel(
                        {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 2 * height, height)));
    return map;
}

TEST(EvaluateDirectional, ResamplingKeepsTheMeanOverTheSphere) {
    ImageRgb map(128, 64, Vector3f::Constant(0.1f));
    map(17, 3) = Vector3f(900, 300, 100);  // a sun near the pole
    const Vector3f before = DirectionalMap{map, {}}.mean();
    const Vector3f after = DirectionalMap{evaluate::resampledMap(map, 16), {}}.mean();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[c] / before[c], 1, 0.02) << c;
}

TEST(EvaluateDirectional, BlurDampsAGradientAsTheSphereSays) {
    // A zonal kernel k scales harmonics of degree 1 by ∫ k cos θ: here with k(θ) = exp(−θ²/2σ²), integrated finely.
    const double sigma = 0.4;
    double weights = 0, sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double angle = (i + 0.5) * 4 * sigma / 100000;
        const double weight = std::exp(-0.5 * angle * angle / (sigma * sigma)) * std::sin(angle);
        weights += weight;
        sum += weight * std::cos(angle);
    }
    const Vector3f axis = Vector3f(1, 2, -2) / 3;
    const ImageRgb map = gradient(32, axis);
    const ImageRgb blurred = evaluate::blurredMap(map, sigma);
    for (std::size_t i = 0; i < map.size(); ++i)
        ASSERT_NEAR(blurred[i].x() - 1, sum / weights * (map[i].x() - 1), 0.01) << i;
}

TEST(EvaluateDirectional, ObservedAndFilledAreJudgedApart) {
    const ImageRgb truth = gradient(64, Vector3f(0.5f, 0, 0));
    DirectionalMap map{truth, core::ImageF(128, 64, 0.0f)};
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            const bool upper = y < 16;  // θ < 45°: 14.6 % of the sphere
            map.coverage(x, y) = upper ? 3.0f : 0.0f;
            map.radiance(x, y) *= upper ? 1.1f : 0.5f;
        }
    }
    const auto error = evaluate::compareEnvironment(map, truth);
    EXPECT_NEAR(error.observed.share, 0.5 * (1 - std::cos(std::numbers::pi / 4)), 1e-4);
    EXPECT_NEAR(error.observed.share + error.filled.share, 1, 1e-4);
    EXPECT_NEAR(error.observed.medianError, 0.1, 1e-3);
    EXPECT_NEAR(error.observed.meanRatio, 1.1, 1e-3);
    EXPECT_NEAR(error.filled.medianError, 0.5, 1e-3);
    EXPECT_NEAR(error.filled.meanRatio, 0.5, 1e-3);
    EXPECT_GT(error.filled.blurredRmse, 0.4);
    EXPECT_LT(error.observed.blurredRmse, 0.25);
}

TEST(EvaluateDirectional, NothingObservedIsNoNumber) {
    const ImageRgb truth = gradient(16, Vector3f(0.5f, 0, 0));
    const auto error = evaluate::compareEnvironment({truth, core::ImageF(32, 16, 0.0f)}, truth);
    EXPECT_EQ(error.observed.share, 0);
    EXPECT_TRUE(std::isnan(error.observed.medianError));
    EXPECT_TRUE(std::isnan(error.observed.blurredRmse));
    EXPECT_EQ(error.filled.blurredRmse, 0);
}

}  // namespace
