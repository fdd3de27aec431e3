// SPDX-License-Identifier: GPL-3.0-or-later
// Depth along outlines that belongs to what lies behind: blurred maps, flying pixels, generous outlines.
#include "core/analysis/depth/flying_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/analysis/depth/fill_depth.h"
#include "tests/support/ray_scene.h"
#include "tests/support/sensor_noise.h"

namespace {

using core::ImageF;

/// A sphere and a box well before a wall; the box's top is seen too.
test::RayScene thingsBeforeAWall() {
    test::RayScene scene;
    scene.camera = test::testCamera(320, 240);
    scene.objects.push_back(
        {1, std::make_shared<test::Box>(test::Vector3d(0, 0, 2.1), test::Vector3d(5, 5, 0.1)), {}, false});
    scene.objects.push_back({2, std::make_shared<test::Sphere>(test::Vector3d(-0.16, 0, 1), 0.13), {}, false});
    scene.objects.push_back({3,
                             std::make_shared<test::Box>(test::Vector3d(0.17, 0, 1), test::Vector3d(0.1, 0.12, 0.1),
                                                         test::rotation(0.5, {0.5, 1, 0})),
                             {},
                             false});
    return scene;
}

/// Mean of inverse depth over (2·radius + 1)²: what a matcher with such a window, or a scaled-down map, gives.
ImageF blurred(const ImageF& depth, int radius) {
    ImageF result(depth.width(), depth.height());
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            float sum = 0, count = 0;
            for (int v = std::max(y - radius, 0); v <= std::min(y + radius, depth.height() - 1); ++v)
                for (int u = std::max(x - radius, 0); u <= std::min(x + radius, depth.width() - 1); ++u)
                    sum += 1 / depth(u, v), count += 1;
            result(x, y) = count / sum;
        }
    }
    return result;
}

/// Part of the things' pixels whose depth is off by more than `limit` [m].
double wrongPart(const ImageF& depth, const ImageF& truth, const core::LabelImage& labels, float limit) {
    int wrong = 0, count = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (labels[i] < 2) continue;
        ++count;
        if (!(std::abs(depth[i] - truth[i]) < limit)) ++wrong;
    }
    return static_cast<double>(wrong) / count;
}

double wrongPartAfterRemoval(ImageF depth, const ImageF& truth, const core::LabelImage& labels,
                             const core::Camera& camera, float limit, float pixelsPerSample = 1) {
    core::analysis::removeFlyingPixels(depth, labels, camera, pixelsPerSample, {});
    core::analysis::fillWithMembrane(depth, labels);
    return wrongPart(depth, truth, labels, limit);
}

TEST(FlyingPixels, ExactOutlinesAreLeftAlone) {
    const test::RayScene scene = thingsBeforeAWall();
    const core::Photo photo = scene.photograph();
    ImageF depth = photo.depth;
    core::analysis::removeFlyingPixels(depth, photo.labels, photo.camera, 1, {});
    EXPECT_EQ(depth, photo.depth);

    const core::Photo still = test::stillLife(test::testCamera(320, 240)).photograph();
    depth = still.depth;
    core::analysis::removeFlyingPixels(depth, still.labels, still.camera, 1, {});
    EXPECT_EQ(depth, still.depth);
}

TEST(FlyingPixels, RampsOfABlurredMapAreRemoved) {
    const core::Photo photo = thingsBeforeAWall().photograph();
    const ImageF blurry = blurred(photo.depth, 3);
    constexpr float kLimit = 0.06f;
    const double before = wrongPart(blurry, photo.depth, photo.labels, kLimit);
    const double after = wrongPartAfterRemoval(blurry, photo.depth, photo.labels, photo.camera, kLimit);
    std::printf("blurred by 7 pixels: %.1f %% wrong before, %.1f %% after\n", 100 * before, 100 * after);
    ASSERT_GT(before, 0.08);
    EXPECT_LT(after, 0.25 * before);
}

TEST(FlyingPixels, RampsOfAnEnlargedMapThatEndInAJumpAreRemoved) {
    const core::Photo photo = thingsBeforeAWall().photograph();
    // Colours that guide the enlargement put the wall where it is; the things' side stays blurred.
    ImageF guided = blurred(blurred(photo.depth, 2), 2);
    for (std::size_t i = 0; i < guided.size(); ++i)
        if (photo.labels[i] < 2) guided[i] = photo.depth[i];
    constexpr float kLimit = 0.06f;
    const double before = wrongPart(guided, photo.depth, photo.labels, kLimit);
    const double after = wrongPartAfterRemoval(guided, photo.depth, photo.labels, photo.camera, kLimit, 2);
    std::printf("blurred up to the outline: %.1f %% wrong before, %.1f %% after\n", 100 * before, 100 * after);
    ASSERT_GT(before, 0.08);
    EXPECT_LT(after, 0.5 * before);
    ImageF exact = photo.depth;
    core::analysis::removeFlyingPixels(exact, photo.labels, photo.camera, 2, {});
    EXPECT_EQ(exact, photo.depth) << "the rim of a ball is no ramp";
}

TEST(FlyingPixels, TheWholeMixedBandOfABlurredEnlargedMapIsRemoved) {
    const core::Photo photo = thingsBeforeAWall().photograph();
    constexpr int kSpacing = 2, kDepthOfBand = 6;
    ImageF depth = blurred(blurred(photo.depth, 2), 2);
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (photo.labels[i] < 2) depth[i] = photo.depth[i];
    core::analysis::removeFlyingPixels(depth, photo.labels, photo.camera, kSpacing, {});
    int kept = 0, all = 0, left = 0;
    for (int y = 0; y < depth.height(); ++y)
        for (int x = kDepthOfBand; x < depth.width(); ++x) {
            if (photo.labels(x, y) < 2) continue;
            if (depth(x, y) > 0) ++left;
            const int outside = x - kDepthOfBand;
            if (photo.labels(outside, y) >= 2 || photo.depth(outside, y) < 1.2f * photo.depth(x, y)) continue;
            ++all;
            if (depth(x, y) > 0) ++kept;
        }
    std::printf("band of %d pixels: %d left, %d inside\n", all, kept, left);
    EXPECT_LT(kept, all / 20);
    EXPECT_GT(left, 5 * all) << "the inside stays";
}

TEST(FlyingPixels, OfASensorAreRemoved) {
    const core::Photo photo = thingsBeforeAWall().photograph();
    const ImageF measured = test::withSensorNoise(photo.depth);
    // Less than a third of the way to the wall is for the filter, which draws outliers back.
    constexpr float kLimit = 0.35f;
    const double before = wrongPart(measured, photo.depth, photo.labels, kLimit);
    const double after = wrongPartAfterRemoval(measured, photo.depth, photo.labels, photo.camera, kLimit);
    std::printf("sensor: %.2f %% wrong before, %.2f %% after\n", 100 * before, 100 * after);
    ASSERT_GT(before, 0.005);
    EXPECT_LT(after, 0.25 * before);
}

TEST(FlyingPixels, AGenerousOutlineTakesNoBackgroundIn) {
    const core::Photo photo = thingsBeforeAWall().photograph();
    core::LabelImage generous = photo.labels;
    for (int y = 0; y < generous.height(); ++y)
        for (int x = 0; x < generous.width(); ++x)
            for (int dy = -3; dy <= 3; ++dy)
                for (int dx = -3; dx <= 3; ++dx)
                    if (generous.contains(x + dx, y + dy) && photo.labels(x + dx, y + dy) > 1)
                        generous(x, y) = photo.labels(x + dx, y + dy);
    ImageF depth = photo.depth;
    core::analysis::removeFlyingPixels(depth, generous, photo.camera, 1, {});
    core::analysis::fillWithMembrane(depth, generous);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (generous[i] > 1) {
            EXPECT_LT(depth[i], 1.3f) << "the wall is 2 m away";
        }
    }
}

/// A book of 3 cm on a floor seen from above, and the floor by itself.
test::RayScene bookOnAFloor(bool book) {
    test::RayScene scene;
    scene.camera = test::testCamera(640, 480);
    const Eigen::Matrix3d tilt = test::rotation(0.8, {1, 0, 0});
    const test::Vector3d top(0, 0, 0.6);
    scene.objects.push_back(
        {1, std::make_shared<test::Box>(top + 0.05 * tilt.col(1), test::Vector3d(3, 0.05, 3), tilt), {}, false});
    if (book)
        scene.objects.push_back(
            {2,
             std::make_shared<test::Box>(top - 0.015 * tilt.col(1), test::Vector3d(0.1, 0.015, 0.06), tilt),
             {},
             false});
    return scene;
}

TEST(FlyingPixels, AStripOfTheFloorBehindIsRemoved) {
    const core::Photo photo = bookOnAFloor(true).photograph();
    const ImageF floor = bookOnAFloor(false).photograph().depth;
    // What a stereo camera gives: the floor goes on for three pixels inside the outline, and six have no depth, where
    // the floor is well behind.
    ImageF measured = photo.depth;
    int strip = 0;
    for (int y = 0; y < measured.height(); ++y) {
        for (int x = 0; x < measured.width(); ++x) {
            if (photo.labels(x, y) < 2) continue;
            for (int k = 1; k <= 9; ++k) {
                if (!photo.labels.contains(x, y - k) || photo.labels(x, y - k) == photo.labels(x, y)) continue;
                if (photo.labels(x, y - k) != 1 || floor(x, y) - photo.depth(x, y) < 0.03f) break;
                measured(x, y) = k <= 3 ? floor(x, y) : 0;
                strip += k <= 3 ? 1 : 0;
                break;
            }
        }
    }
    ASSERT_GT(strip, 100);
    ImageF depth = measured;
    core::analysis::removeFlyingPixels(depth, photo.labels, photo.camera, 1, {});
    int left = 0, lost = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (photo.labels[i] < 2 || measured[i] <= 0) continue;
        if (measured[i] == photo.depth[i])
            lost += depth[i] > 0 ? 0 : 1;
        else
            left += depth[i] > 0 ? 1 : 0;
    }
    std::printf("strip of %d pixels: %d left, %d others removed\n", strip, left, lost);
    EXPECT_LT(left, strip / 20);
    EXPECT_EQ(lost, 0);
}

}  // namespace
