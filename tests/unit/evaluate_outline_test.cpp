// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using core::LabelImage;
using evaluate::fillOutlines;
using evaluate::Outline;

int countOf(const LabelImage& labels, std::uint16_t label) {
    int count = 0;
    for (const auto value : labels.pixels()) count += value == label ? 1 : 0;
    return count;
}

TEST(EvaluateOutline, TakesThePixelsWhoseCentresAreInside) {
    LabelImage labels(10, 8);
    fillOutlines(labels, {Outline{{2.4f, 1.6f}, {6.6f, 1.6f}, {6.6f, 5.4f}, {2.4f, 5.4f}}}, 3);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 10; ++x)
            EXPECT_EQ(labels(x, y), x >= 2 && x <= 6 && y >= 2 && y <= 4 ? 3 : 0) << x << " " << y;
}

TEST(EvaluateOutline, NeighboursShareNoPixelAndLeaveNone) {
    // Two triangles that make up a square through pixel centres: each pixel belongs to exactly one.
    LabelImage labels(32, 32);
    fillOutlines(labels, {Outline{{0, 0}, {32, 0}, {32, 32}}}, 1);
    const int first = countOf(labels, 1);
    LabelImage other(32, 32);
    fillOutlines(other, {Outline{{0, 0}, {32, 32}, {0, 32}}}, 1);
    EXPECT_EQ(first + countOf(other, 1), 32 * 32);
    fillOutlines(labels, {Outline{{0, 0}, {32, 32}, {0, 32}}}, 2);
    EXPECT_EQ(countOf(labels, 1), first);
    EXPECT_EQ(countOf(labels, 0), 0);
}

TEST(EvaluateOutline, ASecondOutlineInsideIsAHole) {
    LabelImage labels(100, 100);
    fillOutlines(labels, {evaluate::ellipseOutline({50, 50}, {40, 30}), evaluate::ellipseOutline({50, 50}, {20, 10})},
                 1);
    EXPECT_NEAR(countOf(labels, 1), std::numbers::pi * (40 * 30 - 20 * 10), 25);
    EXPECT_EQ(labels(50, 50), 0);
    EXPECT_EQ(labels(80, 50), 1);
}

TEST(EvaluateOutline, ACurveThroughFewPointsOfACircleIsNearIt) {
    Outline corners;
    for (int i = 0; i < 12; ++i) {
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 6;
        corners.emplace_back(50 + 40 * std::cos(angle), 50 + 40 * std::sin(angle));
    }
    for (const core::Vector2f& point : evaluate::curveOutline(corners))
        EXPECT_NEAR((point - core::Vector2f(50, 50)).norm(), 40, 0.1);
    LabelImage labels(100, 100);
    fillOutlines(labels, {evaluate::curveOutline(corners)}, 1);
    EXPECT_NEAR(countOf(labels, 1), std::numbers::pi * 40 * 40, 40);
}

TEST(EvaluateOutline, IsCutAtTheBorderAndByTheMask) {
    LabelImage labels(16, 16);
    core::ImageF mask(16, 16, 1.0f);
    for (int y = 0; y < 16; ++y) mask(5, y) = 0;
    fillOutlines(labels, {Outline{{-10, -10}, {8, -10}, {8, 40}, {-10, 40}}}, 1, &mask);
    EXPECT_EQ(countOf(labels, 1), 7 * 16);
    EXPECT_EQ(labels(5, 3), 0);
    EXPECT_EQ(labels(7, 15), 1);
    EXPECT_EQ(labels(8, 0), 0);
}

}  // namespace
