// SPDX-License-Identifier: GPL-3.0-or-later
// Rounded depth maps against the analytic surfaces that were rounded.
#include "core/analysis/depth/unround_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <vector>

#include "core/base/error.h"

namespace {

using core::ImageF;
using core::analysis::findDepthRounding;
using core::analysis::unroundDepth;

constexpr int kPictureSide = 160;
constexpr float kUnroundFocal = 200;
using Surface = std::function<float(float, float)>;  // inverse depth [1/m] at a pixel

ImageF depthOf(const Surface& surface, const std::function<float(float)>& stored) {
    ImageF depth(kPictureSide, kPictureSide);
    for (int y = 0; y < kPictureSide; ++y)
        for (int x = 0; x < kPictureSide; ++x)
            depth(x, y) = stored(surface(static_cast<float>(x), static_cast<float>(y)));
    return depth;
}

/// As a phone stores it: `bits` bits of disparity over [0.4, 1.4] 1/m.
std::function<float(float)> disparity(int bits) {
    const auto levels = static_cast<float>((1 << bits) - 1);
    return [levels](float w) { return 1 / (0.4f + std::round((w - 0.4f) * levels) / levels); };
}

float exact(float w) { return 1 / w; }

/// A ball of 60 pixels in front of a wall that is tilted.
float ballAndWall(float x, float y) {
    const float r2 = (x - 80) * (x - 80) + (y - 76) * (y - 76);
    if (r2 < 60 * 60) return 1 / (1.0f - std::sqrt(60 * 60 - r2) / kUnroundFocal);
    return 0.5f + 0.0003f * x + 0.0002f * y;
}

float plane(float x, float y) { return 0.7f + 0.0011f * x - 0.0007f * y; }

/// Median error of the slope [degrees] where the surface is smooth over two pixels.
double medianTilt(const ImageF& depth, const Surface& surface) {
    std::vector<double> tilts;
    for (int y = 2; y + 2 < kPictureSide; ++y) {
        for (int x = 2; x + 2 < kPictureSide; ++x) {
            const auto u = static_cast<float>(x), v = static_cast<float>(y);
            const float w = surface(u, v);
            if (std::abs(surface(u + 2, v) - 2 * w + surface(u - 2, v)) > 0.02f ||
                std::abs(surface(u, v + 2) - 2 * w + surface(u, v - 2)) > 0.02f)
                continue;
            const float du = 1 / depth(x + 1, y) - 1 / depth(x - 1, y) - surface(u + 1, v) + surface(u - 1, v);
            const float dv = 1 / depth(x, y + 1) - 1 / depth(x, y - 1) - surface(u, v + 1) + surface(u, v - 1);
            tilts.push_back(std::atan(static_cast<double>(0.5f * std::hypot(du, dv) * kUnroundFocal / w)) * 57.2958);
        }
    }
    std::ranges::nth_element(tilts, tilts.begin() + static_cast<std::ptrdiff_t>(tilts.size() / 2));
    return tilts[tilts.size() / 2];
}

TEST(UnroundDepth, FindsTheStepOfDisparityAndOfDepth) {
    const auto ofDisparity = findDepthRounding(depthOf(ballAndWall, disparity(8)));
    ASSERT_TRUE(ofDisparity);
    EXPECT_TRUE(ofDisparity->ofInverse);
    EXPECT_NEAR(ofDisparity->step, 1.0f / 255, 1e-5f);
    const auto ofDepth =
        findDepthRounding(depthOf(ballAndWall, [](float w) { return std::round(1 / w / 0.01f) * 0.01f; }));
    ASSERT_TRUE(ofDepth);
    EXPECT_FALSE(ofDepth->ofInverse);
    EXPECT_NEAR(ofDepth->step, 0.01f, 1e-5f);
}

TEST(UnroundDepth, ExactDepthIsUnchangedBitForBit) {
    for (const Surface& surface : {Surface(ballAndWall), Surface(plane)}) {
        const ImageF depth = depthOf(surface, exact);
        EXPECT_FALSE(findDepthRounding(depth));
        const ImageF result = unroundDepth(depth);
        EXPECT_TRUE(std::ranges::equal(result.pixels(), depth.pixels()));
    }
    EXPECT_FALSE(findDepthRounding(depthOf(ballAndWall, disparity(14)))) << "fine rounding is the filter's business";
    EXPECT_FALSE(findDepthRounding(ImageF(kPictureSide, kPictureSide, 1.0f)));
    EXPECT_FALSE(findDepthRounding(ImageF(kPictureSide, kPictureSide, 0.0f)));
}

TEST(UnroundDepth, SlopesOfABallInEightBitsAreMuchCloserToTheTruth) {
    const ImageF rounded = depthOf(ballAndWall, disparity(8));
    const double before = medianTilt(rounded, ballAndWall);
    const double after = medianTilt(unroundDepth(rounded), ballAndWall);
    EXPECT_LT(after, 0.25 * before) << before << " degrees before";
}

TEST(UnroundDepth, ARoundedPlaneBecomesThePlane) {
    const ImageF rounded = depthOf(plane, disparity(8));
    const double before = medianTilt(rounded, plane);
    const double after = medianTilt(unroundDepth(rounded), plane);
    EXPECT_LT(after, 0.1 * before) << before << " degrees before";
}

TEST(UnroundDepth, ResultStillRoundsToWhatIsStoredAndGapsStay) {
    ImageF rounded = depthOf(ballAndWall, disparity(8));
    for (int x = 40; x < 70; ++x) rounded(x, 50) = 0;
    const ImageF result = unroundDepth(rounded);
    for (std::size_t i = 0; i < rounded.size(); ++i) {
        if (rounded[i] <= 0)
            ASSERT_EQ(result[i], 0);
        else
            ASSERT_NEAR(1 / result[i], 1 / rounded[i], 0.5001f / 255);
    }
}

TEST(UnroundDepth, CanBeCancelled) {
    std::atomic<bool> cancel{true};
    EXPECT_THROW((void)unroundDepth(depthOf(ballAndWall, disparity(8)), core::Progress({}, &cancel)), core::Error);
}

}  // namespace
