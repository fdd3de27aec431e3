// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/color.h"

namespace {

using core::ImageRgb;
using core::Vector3f;

core::Image<std::uint8_t> fullMask(int width, int height) { return {width, height, 1}; }

TEST(EvaluateMetrics, PsnrOfAKnownDisplayDifference) {
    const ImageRgb truth(16, 16, Vector3f::Constant(core::srgbDecode(0.5f)));
    const ImageRgb picture(16, 16, Vector3f::Constant(core::srgbDecode(0.6f)));
    const auto metrics = evaluate::compare(picture, truth, fullMask(16, 16), 1);
    EXPECT_NEAR(metrics.psnr, 20.0, 1e-3);  // −20·log10(0.1)
    EXPECT_NEAR(metrics.meanRatio, core::srgbDecode(0.6f) / core::srgbDecode(0.5f), 1e-5);
}

TEST(EvaluateMetrics, EqualPicturesHaveNoError) {
    ImageRgb picture(20, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) picture(x, y) = Vector3f::Constant(0.01f * static_cast<float>(x + y));
    const auto metrics = evaluate::compare(picture, picture, fullMask(20, 20), 1);
    EXPECT_TRUE(std::isinf(metrics.psnr));
    EXPECT_NEAR(metrics.ssim, 1.0, 1e-9);
    EXPECT_EQ(metrics.relMse, 0.0);
}

TEST(EvaluateMetrics, OnlyTheMaskCounts) {
    ImageRgb truth(8, 8, Vector3f::Constant(0.25f));
    ImageRgb picture = truth;
    picture(0, 0) = Vector3f::Constant(9.0f);
    auto mask = fullMask(8, 8);
    mask(0, 0) = 0;
    EXPECT_EQ(evaluate::compare(picture, truth, mask, 1).relMse, 0.0);
    EXPECT_LT(evaluate::compare(picture, truth, fullMask(8, 8), 1).psnr, 40.0);
}

TEST(EvaluateMetrics, ErosionTakesOnePixelPerRound) {
    core::LabelImage labels(9, 9, 0);
    for (int y = 1; y < 8; ++y)
        for (int x = 1; x < 8; ++x) labels(x, y) = 3;
    int count = 0;
    const auto mask = evaluate::erodedMask(labels, 3, 2);
    for (const auto value : mask.pixels()) count += value;
    EXPECT_EQ(count, 9);
    EXPECT_EQ(mask(3, 3), 1);
    EXPECT_EQ(mask(2, 2), 0);
}

TEST(EvaluateMetrics, Quantiles) {
    EXPECT_EQ(evaluate::quantile({5, 1, 4, 2, 3}, 0.5), 3);
    EXPECT_EQ(evaluate::quantile({5, 1, 4, 2, 3}, 1), 5);
    std::vector<float> hundred;
    for (int i = 100; i >= 0; --i) hundred.push_back(static_cast<float>(i));
    EXPECT_EQ(evaluate::quantile(hundred, 0.95), 95);
    EXPECT_TRUE(std::isnan(evaluate::quantile({}, 0.5)));
}

TEST(EvaluateMetrics, AnglesOfAllSizes) {
    EXPECT_NEAR(evaluate::angleDegrees({1, 0, 0}, {0, 2, 0}), 90, 1e-9);
    EXPECT_NEAR(evaluate::angleDegrees({1, 0, 0}, {-1, 0, 0}), 180, 1e-9);
    EXPECT_NEAR(evaluate::angleDegrees({1, 0, 0}, {1, 1e-4f, 0}), 5.7296e-3, 1e-6);
}

}  // namespace
