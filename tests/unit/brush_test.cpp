// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/brush.h"

#include <gtest/gtest.h>

using core::Brush;
using core::BrushStroke;
using core::Mask;

TEST(BrushStroke, IsARoundLineInsideItsSegment) {
    core::LabelImage labels(120, 80, 1);
    for (int y = 0; y < 80; ++y)
        for (int x = 90; x < 120; ++x) labels(x, y) = 2;
    BrushStroke stroke(Mask(120, 80), Brush{.radius = 10, .hardness = 1}, labels, 1);
    stroke.moveTo(30, 40);
    stroke.moveTo(110, 40);
    const Mask& mask = stroke.mask();
    EXPECT_EQ(mask.value(60, 40), 1.0f);
    EXPECT_EQ(mask.value(60, 31), 1.0f) << "full up to the radius";
    EXPECT_EQ(mask.value(60, 28), 0.0f);
    EXPECT_EQ(mask.value(18, 40), 0.0f) << "round ends";
    EXPECT_EQ(mask.value(23, 40), 1.0f);
    EXPECT_EQ(mask.value(21, 32), 0.0f);
    EXPECT_EQ(mask.value(89, 40), 1.0f);
    EXPECT_EQ(mask.value(90, 40), 0.0f) << "another segment";
}

TEST(BrushStroke, StrengthIsThatOfTheStrokeHoweverOftenItCrossesItself) {
    const core::LabelImage labels(60, 60, 1);
    Mask before(60, 60);
    before.change(0, 0, 59, 59, [](int, int, float) { return 0.2f; });
    const auto scribble = [&](const Mask& mask, const Brush& brush) {
        BrushStroke stroke(mask, brush, labels, 1);
        for (int i = 0; i < 9; ++i) stroke.moveTo(i % 2 == 0 ? 10.0f : 50.0f, 30);
        return stroke.mask();
    };
    const Mask once = scribble(before, {.radius = 8, .hardness = 0.5f, .strength = 0.5f});
    EXPECT_NEAR(once.value(30, 30), 0.6f, 1e-4f);
    EXPECT_GT(once.value(30, 35), 0.2f);
    EXPECT_LT(once.value(30, 35), 0.6f) << "a soft rim";
    const Mask erased = scribble(once, {.radius = 8, .hardness = 1, .strength = 0.5f, .erase = true});
    EXPECT_NEAR(erased.value(30, 30), 0.3f, 1e-4f);
    EXPECT_NEAR(erased.value(30, 50), 0.2f, 1e-4f);
}

TEST(BrushStroke, FarOutsideThePictureNothingHappens) {
    const core::LabelImage labels(20, 20, 1);
    BrushStroke stroke(Mask(20, 20), {}, labels, 1);
    stroke.moveTo(-1e9f, 1e9f);
    stroke.moveTo(3e9f, 1e9f);
    EXPECT_EQ(stroke.mask().hash(), Mask(20, 20).hash());
}
