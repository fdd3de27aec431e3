// SPDX-License-Identifier: GPL-3.0-or-later
// Missing and wrong depth filled from the surface around it.
#include "core/analysis/depth/fill_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/ray_scene.h"

namespace {

using core::ImageF;
using core::LabelImage;

constexpr int kGappedWidth = 100, kGappedHeight = 60;

/// A segment that ends 10 pixels from the right border, on a plane in inverse depth, beside another one.
struct GappedScene {
    core::Camera camera{kGappedWidth, kGappedHeight, 500, 500, 0.5f * kGappedWidth, 0.5f * kGappedHeight};
    LabelImage labels{kGappedWidth, kGappedHeight, 7};
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
    void run() { core::analysis::fillWithPlanes(depth, labels, camera, gaps, {}); }
    [[nodiscard]] float worst() const {
        float result = 0;
        for (std::size_t i = 0; i < depth.size(); ++i)
            if (labels[i] == 3) result = std::max(result, std::abs(depth[i] / truth[i] - 1));
        return result;
    }
};

TEST(FillWithPlanes, ASlopeGoesOnToAnOpenOutline) {
    GappedScene scene(0.004f);
    scene.removeFrom(78);
    scene.run();
    EXPECT_LT(scene.worst(), 1e-3f) << "12 pixels that end facing the camera would be 5 % off";
    EXPECT_TRUE(std::ranges::all_of(scene.gaps.isGap.pixels(), [](std::uint8_t gap) { return gap == 0; }));
    for (int y = 0; y < kGappedHeight; ++y) ASSERT_EQ(scene.depth(95, y), 0.5f) << "another segment";
}

TEST(FillWithPlanes, JaggedPixelsBesideTheGapDoNotRunOnIntoIt) {
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

TEST(FillWithPlanes, WhatIsFarFromAnythingKnownIsLeft) {
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

TEST(FillWithPlanes, NoisySlopesStaySmoothAndBelowTheLimit) {
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

TEST(FillWithMembrane, SpansHolesFromTheSegmentOnly) {
    LabelImage labels(40, 30, 0);
    ImageF depth(40, 30, 0.0f);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            if (x < 20) labels(x, y) = 1;
            if (x >= 24) labels(x, y) = 2;
            // A plane in inverse depth is harmonic, so the membrane over a hole inside it is that plane.
            if (labels(x, y) == 1) depth(x, y) = 1.0f / (1.0f + 0.01f * static_cast<float>(x + y));
            if (labels(x, y) == 2) depth(x, y) = 5.0f;
        }
    }
    for (int y = 8; y < 20; ++y)
        for (int x = 5; x < 14; ++x) depth(x, y) = 0;
    for (int y = 0; y < 30; ++y) depth(24, y) = 0;

    core::analysis::fillWithMembrane(depth, labels);
    for (int y = 8; y < 20; ++y)
        for (int x = 5; x < 14; ++x)
            EXPECT_NEAR(1.0f / depth(x, y), 1.0f + 0.01f * static_cast<float>(x + y), 1e-3f) << x << ' ' << y;
    for (int y = 0; y < 30; ++y) {
        EXPECT_NEAR(depth(24, y), 5.0f, 1e-4f);  // continued from its own segment, not from the nearer one
        EXPECT_EQ(depth(22, y), 0.0f);           // unlabelled: distant
    }
}

TEST(FillWithMembrane, LeavesValidPixelsAndEmptySegmentsAlone) {
    LabelImage labels(8, 8, 3);
    ImageF depth(8, 8, 2.0f);
    depth(4, 4) = 0;
    for (int y = 0; y < 8; ++y) labels(0, y) = 4, depth(0, y) = 0;
    core::analysis::fillWithMembrane(depth, labels);
    EXPECT_NEAR(depth(4, 4), 2.0f, 1e-5f);
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(depth(0, y), 0.0f);  // nothing is known of segment 4
        for (int x = 1; x < 8; ++x) {
            if (x == 4 && y == 4) continue;
            EXPECT_EQ(depth(x, y), 2.0f);
        }
    }
}

/// Largest error [m] in holes of 1, 4 × 4 and 1 × 30 pixels that are cut into an exact photograph and filled.
float worstFilledHole(const test::RayScene& scene) {
    core::Photo photo = scene.photograph();
    const ImageF truth = photo.depth;
    std::vector<std::size_t> holes;
    const auto punch = [&](int x0, int y0, int width, int height) {
        for (int y = y0; y < y0 + height; ++y)
            for (int x = x0; x < x0 + width; ++x) {
                EXPECT_GT(photo.depth(x, y), 0);
                photo.depth(x, y) = 0;
                holes.push_back(photo.depth.index(x, y));
            }
    };
    punch(170, 115, 1, 1);
    punch(150, 110, 4, 4);
    punch(140, 100, 1, 30);
    core::ImageF filled = photo.depth;
    core::analysis::fillDepth(filled, photo, true, {});
    EXPECT_EQ(filled(0, 0), 0) << "the background stays distant";
    float worst = 0;
    for (const std::size_t i : holes) worst = std::max(worst, std::abs(filled[i] - truth[i]));
    return worst;
}

TEST(FillDepth, SmallHolesOfExactDepthFollowTheSurface) {
    test::RayScene square;
    square.camera = test::testCamera(320, 240);
    square.objects.push_back(
        {1,
         std::make_shared<test::Box>(Eigen::Vector3d(0.02, -0.01, 1), Eigen::Vector3d(0.3, 0.3, 1e-6),
                                     test::rotation(0.8, {0.3, 1, 0})),
         {}});
    EXPECT_LT(worstFilledHole(square), 1e-5f);
    test::RayScene ball;
    ball.camera = test::testCamera(320, 240);
    ball.objects.push_back({1, std::make_shared<test::Sphere>(Eigen::Vector3d(0, 0, 1), 0.25), {}});
    EXPECT_LT(worstFilledHole(ball), 2e-4f) << "with the margin of measured depth it would be more";
}

}  // namespace
