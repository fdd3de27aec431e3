// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/depth_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace {

constexpr int kRoomWidth = 80;
constexpr int kRoomHeight = 60;

std::size_t count(const core::BinaryMask& mask) {
    std::size_t sum = 0;
    for (const std::uint8_t value : mask.pixels()) sum += value;
    return sum;
}

/// A floor, 1/z = a·y + b below row 20, in front of a wall at 4 m; a box at 1.5 m on it.
core::ImageF makeRoom() {
    core::ImageF depth(kRoomWidth, kRoomHeight, 4.0f);
    for (int y = 20; y < kRoomHeight; ++y)
        for (int x = 0; x < kRoomWidth; ++x) depth(x, y) = 1 / (0.25f + 0.01f * static_cast<float>(y - 20));
    for (int y = 25; y < 45; ++y)
        for (int x = 30; x < 50; ++x) depth(x, y) = 1.5f;
    return depth;
}

TEST(SelectByDepth, ARangeIsWhatIsAsFarAway) {
    const core::ImageF depth = makeRoom();
    const core::BinaryMask box = core::selectByDepth(depth, {40, 30}, {.tolerance = 0.01f});
    for (int y = 0; y < kRoomHeight; ++y)
        for (int x = 0; x < kRoomWidth; ++x) {
            const bool inside = y >= 25 && y < 45 && x >= 30 && x < 50;
            if (inside) {
                EXPECT_EQ(box(x, y), 1) << x << ", " << y;
            }
            if (box(x, y) != 0) {
                EXPECT_NEAR(depth(x, y), 1.5f, 0.016f);
            }
        }
}

TEST(SelectByDepth, OnlyThePieceOfTheSeedUnlessAllIsWanted) {
    core::ImageF depth(kRoomWidth, kRoomHeight, 2.0f);
    for (int y = 0; y < kRoomHeight; ++y) depth(40, y) = 3.0f;
    EXPECT_EQ(count(core::selectByDepth(depth, {3, 3}, {})), std::size_t{40} * kRoomHeight);
    EXPECT_EQ(count(core::selectByDepth(depth, {3, 3}, {.connected = false})),
              std::size_t{kRoomWidth - 1} * kRoomHeight);
}

TEST(SelectByDepth, APlaneIsFoundHoweverItIsTilted) {
    const core::ImageF depth = makeRoom();
    const core::BinaryMask floor =
        core::selectByDepth(depth, {10, 55}, {.shape = core::DepthShape::Plane, .tolerance = 0.005f});
    std::size_t expected = 0;
    for (int y = 0; y < kRoomHeight; ++y)
        for (int x = 0; x < kRoomWidth; ++x) {
            const bool box = y >= 25 && y < 45 && x >= 30 && x < 50;
            // Where the plane meets the wall, both are right.
            if (y >= 21 && !box) {
                ++expected;
                EXPECT_EQ(floor(x, y), 1) << x << ", " << y;
            }
            if (y < 18) {
                EXPECT_EQ(floor(x, y), 0) << x << ", " << y;
            }
        }
    EXPECT_EQ(floor(40, 30), 0) << "the box stands on it";
    EXPECT_GT(expected, 2000u);
}

TEST(SelectByDepth, StatesItsResultForEveryInput) {
    core::ImageF depth = makeRoom();
    depth(5, 5) = 0;
    EXPECT_EQ(count(core::selectByDepth(depth, {5, 5}, {})), 0u) << "no depth at the seed";
    EXPECT_EQ(count(core::selectByDepth(depth, {5, 5}, {.shape = core::DepthShape::Plane})), 0u);
    for (const core::Pixel outside : {core::Pixel{-1, 0}, core::Pixel{kRoomWidth, 0}, core::Pixel{0, kRoomHeight}})
        EXPECT_THROW(static_cast<void>(core::selectByDepth(depth, outside, {})), core::Error);
    // One pixel with depth has no plane.
    core::ImageF lonely(kRoomWidth, kRoomHeight);
    lonely(7, 7) = 1;
    EXPECT_EQ(count(core::selectByDepth(lonely, {7, 7}, {.shape = core::DepthShape::Plane})), 0u);
    EXPECT_EQ(count(core::selectByDepth(lonely, {7, 7}, {})), 1u);
    const core::ImageF tiny(1, 1, 2.0f);
    EXPECT_EQ(count(core::selectByDepth(tiny, {0, 0}, {})), 1u);
    EXPECT_EQ(count(core::selectByDepth(tiny, {0, 0}, {.shape = core::DepthShape::Plane})), 0u);
}

TEST(SelectByDepth, CanBeCancelled) {
    const std::atomic<bool> cancel = true;
    EXPECT_THROW(static_cast<void>(core::selectByDepth(makeRoom(), {40, 30}, {}, core::Progress(nullptr, &cancel))),
                 core::Error);
}

}  // namespace
