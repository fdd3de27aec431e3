// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sensor_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using core::ImageF;
using test::SensorNoise;
using test::withSensorNoise;

/// Two slanted planes, the left one nearer, that meet in a jump at x = 64; no depth in the first row.
ImageF twoPlanes() {
    ImageF depth(128, 96);
    for (int y = 1; y < 96; ++y)
        for (int x = 0; x < 128; ++x) depth(x, y) = (x < 64 ? 0.8f : 1.6f) + 0.0005f * static_cast<float>(x);
    return depth;
}

TEST(SensorNoise, SigmaGrowsWithTheSquareOfDepth) {
    for (const float z : {0.6f, 1.2f, 2.4f}) {
        ImageF depth(256, 256);
        // A spread of depths over several steps of disparity, so that rounding errs evenly.
        for (std::size_t i = 0; i < depth.size(); ++i)
            depth[i] = z * (1 + 0.02f * static_cast<float>(i % 997) / 997.0f);
        const ImageF measured = withSensorNoise(depth);
        double sum = 0, squared = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const double error = measured[i] - depth[i];
            sum += error;
            squared += error * error;
        }
        const auto n = static_cast<double>(depth.size());
        const double middle = 1.01 * z;
        EXPECT_NEAR(std::sqrt(squared / n), 1.43e-3 * middle * middle, 0.05e-3 * middle * middle) << z;
        EXPECT_NEAR(sum / n, 0, 0.02e-3 * middle * middle) << "unbiased at " << z;
    }
}

TEST(SensorNoise, DisparityIsAMultipleOfItsStep) {
    const SensorNoise noise;
    const ImageF measured = withSensorNoise(twoPlanes(), noise);
    for (const float z : measured.pixels()) {
        if (z <= 0) continue;
        const float steps = noise.focalBaseline / z / noise.disparityStep;
        ASSERT_NEAR(steps, std::round(steps), 1e-3);
    }
}

TEST(SensorNoise, PixelsFlyOnlyAtEdgesAndOnlyBetweenTheSurfaces) {
    const ImageF depth = twoPlanes();
    const ImageF measured = withSensorNoise(depth);
    int flying = 0;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (depth(x, y) <= 0) {
                ASSERT_EQ(measured(x, y), 0);
                continue;
            }
            ASSERT_GT(measured(x, y), 0.78f);
            ASSERT_LT(measured(x, y), 1.70f);
            const bool far = std::abs(measured(x, y) - depth(x, y)) > 0.02f;
            const bool edge = x == 63 || x == 64;
            ASSERT_EQ(test::isDepthEdge(depth, x, y, SensorNoise().edgeJump), edge) << x << " " << y;
            ASSERT_TRUE(!far || edge) << x << " " << y;
            flying += far ? 1 : 0;
        }
    }
    // Of 190 pixels at the edge about a third, less those that hardly moved.
    EXPECT_GT(flying, 40);
    EXPECT_LT(flying, 85);
}

TEST(SensorNoise, TheSeedDecides) {
    const ImageF depth = twoPlanes();
    EXPECT_EQ(withSensorNoise(depth, {}, 3), withSensorNoise(depth, {}, 3));
    EXPECT_NE(withSensorNoise(depth, {}, 3), withSensorNoise(depth, {}, 4));
}

}  // namespace
