// SPDX-License-Identifier: GPL-3.0-or-later
// Depth continued into what a sensor missed or got wrong.
#include "core/analysis/depth/continue_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using core::ImageF;

constexpr int kGappedWidth = 100, kGappedHeight = 60;

/// A segment that ends 10 pixels from the right border, on a plane in inverse depth, beside another one.
struct GappedScene {
    core::Camera camera{kGappedWidth, kGappedHeight, 500, 500, 0.5f * kGappedWidth, 0.5f * kGappedHeight};
    core::LabelImage labels{kGappedWidth, kGappedHeight, 7};
    ImageF truth{kGappedWidth, kGappedHeight, 0.5f};
    ImageF depth;
    core::analysis::DepthGaps gaps{core::Image<std::uint8_t>(kGappedWidth, kGappedHeight, 0), 8, 16};

    explicit GappedScene(float slope) {
        for (int y = 0; y < kGappedHeight; ++y)
            for (int x = 0; x < kGappedWidth - 10; ++x) {
                labels(x, y) = 3;
                truth(x, y) = 1 / (1.0f - slope * static_cast<float>(x) + 0.001f * static_cast<float>(y));
            }
        depth = truth;
    }
    [[nodiscard]] bool inside(int x, int y) const { return labels(x, y) == 3; }
    void removeFrom(int first) {
        for (int y = 0; y < kGappedHeight; ++y)
            for (int x = first; x < kGappedWidth - 10; ++x) gaps.isGap(x, y) = 1, depth(x, y) = 0;
    }
    void run() { core::analysis::continueDepth(depth, labels, camera, gaps, {}); }
    [[nodiscard]] float worst() const {
        float result = 0;
        for (std::size_t i = 0; i < depth.size(); ++i)
            if (labels[i] == 3) result = std::max(result, std::abs(depth[i] / truth[i] - 1));
        return result;
    }
};

TEST(ContinueDepth, ASlopeGoesOnToAnOpenOutline) {
    GappedScene scene(0.004f);
    scene.removeFrom(78);
    scene.run();
    EXPECT_LT(scene.worst(), 1e-3f) << "12 pixels that end facing the camera would be 5 % off";
    EXPECT_TRUE(std::ranges::all_of(scene.gaps.isGap.pixels(), [](std::uint8_t gap) { return gap == 0; }));
    for (int y = 0; y < kGappedHeight; ++y) ASSERT_EQ(scene.depth(95, y), 0.5f) << "another segment";
}

TEST(ContinueDepth, JaggedPixelsBesideTheGapDoNotRunOnIntoIt) {
    GappedScene scene(0.001f);
    scene.removeFrom(78);
    for (int y = 0; y < kGappedHeight; ++y)
        if (y % 5 < 2) scene.depth(77, y) *= 1.1f;
    scene.run();
    float worst = 0;
    for (int y = 0; y < kGappedHeight; ++y)
        for (int x = 80; x < kGappedWidth - 10; ++x)
            worst = std::max(worst, std::abs(scene.depth(x, y) / scene.truth(x, y) - 1));
    EXPECT_LT(worst, 0.006f);
}

TEST(ContinueDepth, WhatIsFarFromAnythingKnownIsLeft) {
    GappedScene scene(0.001f);
    scene.removeFrom(60);
    scene.run();
    for (int y = 0; y < kGappedHeight; ++y)
        for (int x = 60; x < kGappedWidth - 10; ++x) {
            const bool near = x < 60 + scene.gaps.reach;
            ASSERT_EQ(scene.gaps.isGap(x, y), near ? 0 : 1) << x;
            ASSERT_EQ(scene.depth(x, y) > 0, near) << x;
        }
}

TEST(ContinueDepth, NoisySlopesStaySmoothAndBelowTheLimit) {
    GappedScene scene(0);
    scene.removeFrom(78);
    // A step of half a metre right before the gap: 16 pixels of such a slope would lead to the horizon.
    for (int y = 0; y < kGappedHeight; ++y)
        for (int x = 70; x < 78; ++x) scene.depth(x, y) = 1 / (1 - 0.06f * static_cast<float>(x - 69));
    scene.run();
    const float limit = 3.8f / scene.camera.fx;  // 75 degrees
    for (int y = 0; y < kGappedHeight; ++y)
        for (int x = 82; x + 1 < kGappedWidth - 10; ++x)
            ASSERT_LT(std::abs(scene.depth(x, y) / scene.depth(x + 1, y) - 1), 2 * limit) << x << ' ' << y;
}

}  // namespace
