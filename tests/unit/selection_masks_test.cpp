// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/selection/mask_operations.h"
#include "core/selection/refine_outline.h"

namespace {

using core::BinaryMask;

int selectedPixels(const BinaryMask& mask) { return std::accumulate(mask.pixels().begin(), mask.pixels().end(), 0); }

BinaryMask randomMask(int width, int height, unsigned seed, unsigned oneIn) {
    std::mt19937 random(seed);
    BinaryMask mask(width, height);
    for (std::uint8_t& value : mask.pixels()) value = random() % oneIn == 0 ? 1 : 0;
    return mask;
}

/// Whether a pixel with `value` lies within `radius`, by looking at all.
bool hasNear(const BinaryMask& mask, int x, int y, int radius, std::uint8_t value) {
    for (int py = 0; py < mask.height(); ++py)
        for (int px = 0; px < mask.width(); ++px)
            if (mask(px, py) == value && (px - x) * (px - x) + (py - y) * (py - y) <= radius * radius) return true;
    return false;
}

TEST(MaskOperations, GrowAndShrinkByDiscs) {
    for (const int radius : {1, 2, 5, 9}) {
        const BinaryMask sparse = randomMask(37, 29, 3, 60);
        const BinaryMask dense = core::invertMask(sparse);
        const BinaryMask grown = core::growMask(sparse, radius);
        const BinaryMask shrunk = core::shrinkMask(dense, radius);
        for (int y = 0; y < sparse.height(); ++y)
            for (int x = 0; x < sparse.width(); ++x) {
                ASSERT_EQ(grown(x, y) != 0, hasNear(sparse, x, y, radius, 1)) << radius;
                ASSERT_EQ(shrunk(x, y) == 0, hasNear(dense, x, y, radius, 0)) << radius;
            }
    }
}

TEST(MaskOperations, TheEdgeOfThePictureIsNoOutline) {
    const BinaryMask all(20, 10, 1);
    EXPECT_EQ(core::shrinkMask(all, 100000), all);
    EXPECT_EQ(core::growMask(BinaryMask(20, 10), 100000), BinaryMask(20, 10));
    EXPECT_EQ(core::smoothMask(all, 4), all);
    EXPECT_EQ(core::growMask(BinaryMask(), 3), BinaryMask());
}

TEST(MaskOperations, HolesAreFilledButBaysStay) {
    BinaryMask ring(20, 20);
    for (int y = 4; y < 16; ++y)
        for (int x = 4; x < 16; ++x) ring(x, y) = x < 7 || x >= 13 || y < 7 || y >= 13 ? 1 : 0;
    EXPECT_EQ(selectedPixels(core::fillHoles(ring)), 12 * 12);
    for (int x = 13; x < 16; ++x) ring(x, 10) = 0;  // a way out
    EXPECT_EQ(core::fillHoles(ring), ring);
}

TEST(MaskOperations, SmoothingRemovesSpecksAndKeepsStraightEdges) {
    BinaryMask half(40, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 20; ++x) half(x, y) = 1;
    EXPECT_EQ(core::smoothMask(half, 3), half);
    BinaryMask specks = half;
    specks(30, 10) = 1;
    specks(8, 25) = 0;
    EXPECT_EQ(core::smoothMask(specks, 3), half);
}

TEST(MaskOperations, PiecesAreFourConnected) {
    BinaryMask mask(6, 6);
    mask(1, 1) = mask(2, 2) = mask(2, 3) = 1;
    const BinaryMask piece = core::piecesUnder(mask, {{2, 3}});
    EXPECT_EQ(selectedPixels(piece), 2);
    EXPECT_EQ(piece(1, 1), 0);
    EXPECT_EQ(selectedPixels(core::piecesUnder(mask, {{5, 5}, {-1, 0}})), 0);
}

TEST(RefineOutline, MovesToTheEdgeOfTheColour) {
    // The selection ends 5 px before the red square does.
    core::Image<core::PackedLab> lab(80, 80, core::packLab({0.7f, 0, 0}));
    BinaryMask truth(80, 80), mask(80, 80);
    for (int y = 20; y < 60; ++y)
        for (int x = 20; x < 60; ++x) {
            lab(x, y) = core::packLab({0.5f, 0.15f, 0.1f});
            truth(x, y) = 1;
            mask(x, y) = x < 55 ? 1 : 0;
        }
    EXPECT_EQ(core::refineOutline(mask, lab, 1, 8, {}, {}), truth);
}

TEST(RefineOutline, EnlargesToTheEdgeOfTheColour) {
    // A third of the size; the square covers no whole number of coarse pixels.
    core::Image<core::PackedLab> lab(91, 89, core::packLab({0.7f, 0, 0}));
    BinaryMask truth(91, 89), coarse(31, 30);
    for (int y = 19; y < 61; ++y)
        for (int x = 23; x < 60; ++x) {
            lab(x, y) = core::packLab({0.5f, 0.15f, 0.1f});
            truth(x, y) = coarse(x / 3, y / 3) = 1;
        }
    EXPECT_EQ(core::refineOutline(coarse, lab, 3, 1, {}, {}), truth);
}

TEST(RefineOutline, KeepsNarrowPartsAndFixedPixels) {
    const core::Image<core::PackedLab> lab(60, 60, core::packLab({0.5f, 0, 0}));
    BinaryMask mask(60, 60);
    for (int y = 5; y < 55; ++y)
        for (int x = 28; x < 31; ++x) mask(x, y) = 1;  // 3 px wide
    EXPECT_EQ(core::refineOutline(mask, lab, 1, 6, {}, {}), mask);
    BinaryMask disc(60, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) disc(x, y) = (x - 30) * (x - 30) + (y - 30) * (y - 30) < 400 ? 1 : 0;
    disc(50, 30) = 1;
    BinaryMask fixed(60, 60);
    EXPECT_EQ(core::refineOutline(disc, lab, 1, 4, fixed, {})(50, 30), 0);
    fixed(50, 30) = 1;
    EXPECT_EQ(core::refineOutline(disc, lab, 1, 4, fixed, {})(50, 30), 1);
}

TEST(RefineOutline, ColoursDecideBetweenTwoEdges) {
    // Around a yellow square, the floor is grey, with a black line 4 px away: its edges are stronger than the square's.
    core::Image<core::PackedLab> lab(100, 100, core::packLab({0.75f, 0, 0}));
    BinaryMask truth(100, 100), mask(100, 100);
    const auto within = [](int x, int y, int from, int to) { return std::min(x, y) >= from && std::max(x, y) < to; };
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            if (within(x, y, 26, 74) && !within(x, y, 28, 72)) lab(x, y) = core::packLab({0.2f, 0, 0});
            truth(x, y) = within(x, y, 32, 68) ? 1 : 0;
            mask(x, y) = within(x, y, 30, 70) ? 1 : 0;
            if (truth(x, y) != 0) lab(x, y) = core::packLab({0.7f, 0, 0.12f});
        }
    const BinaryMask found = core::refineOutline(mask, lab, 1, 6, {}, {});
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) wrong += found[i] != truth[i] ? 1 : 0;
    EXPECT_LE(wrong, 12) << "but for the corners";
}

}  // namespace
