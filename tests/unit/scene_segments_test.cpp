// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/segments.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace {

using Mask = core::Image<std::uint8_t>;

/// 4x1 pixels: label 3 ("pot", edited), 3, 7, none.
core::Scene fourPixels() {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(4, 1);
    photo->labels(0, 0) = photo->labels(1, 0) = 3;
    photo->labels(2, 0) = 7;
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    scene.findSegment(std::uint16_t{3})->name = "pot";
    scene.findSegment(std::uint16_t{3})->edit.emplace();
    return scene;
}

Mask pixels(std::initializer_list<int> selected) {
    Mask mask(4, 1);
    for (const int x : selected) mask(x, 0) = 1;
    return mask;
}

TEST(WithSegment, ANewNameGetsTheFirstFreeLabel) {
    const core::Scene before = fourPixels();
    core::Scene scene = core::withSegment(before, pixels({1, 3}), "lid");
    ASSERT_NE(scene.findSegment("lid"), nullptr);
    EXPECT_EQ(scene.findSegment("lid")->label, 1);
    EXPECT_EQ(scene.photo->labels(0, 0), 3);
    EXPECT_EQ(scene.photo->labels(1, 0), 1);
    EXPECT_EQ(scene.photo->labels(3, 0), 1);
    EXPECT_TRUE(scene.findSegment("pot")->edit);
    EXPECT_EQ(before.photo->labels(1, 0), 3) << "the old scene is untouched";
}

TEST(WithSegment, AnExistingOneBecomesTheSelectionAndKeepsItsEdit) {
    for (const char* name : {"pot", "3", "03"}) {
        core::Scene scene = core::withSegment(fourPixels(), pixels({1, 3}), name);
        EXPECT_EQ(scene.segments.size(), 2U);
        EXPECT_EQ(scene.photo->labels(0, 0), 0);
        EXPECT_EQ(scene.photo->labels(3, 0), 3);
        EXPECT_TRUE(scene.findSegment("pot")->edit);
    }
}

TEST(WithSegment, ANumberIsALabel) {
    core::Scene scene = core::withSegment(fourPixels(), pixels({3}), "65535");
    EXPECT_EQ(scene.photo->labels(3, 0), 65535);
    EXPECT_EQ(scene.findSegment(std::uint16_t{65535})->name, "segment 65535");
}

TEST(WithSegment, WhatIsCoveredGoesUnlessItIsEdited) {
    core::Notes notes;
    core::Scene scene = core::withSegment(fourPixels(), pixels({2, 3}), "lid", &notes);
    EXPECT_EQ(scene.findSegment(std::uint16_t{7}), nullptr);
    EXPECT_EQ(notes.size(), 1U);
    EXPECT_THROW((void)core::withSegment(fourPixels(), pixels({0, 1}), "lid"), core::Error);
}

TEST(WithSegment, RefusesWhatMakesNoSegment) {
    EXPECT_THROW((void)core::withSegment(fourPixels(), pixels({}), "lid"), core::Error);
    for (const char* name : {"", "0", "65536", "99999999999999999999"})
        EXPECT_THROW((void)core::withSegment(fourPixels(), pixels({3}), name), core::Error) << name;
}

TEST(WithSegment, SaysWhenAllLabelsAreTaken) {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(65536, 1);
    for (int x = 0; x < 65536; ++x) photo->labels(x, 0) = static_cast<std::uint16_t>(x);
    core::Scene scene;
    scene.photo = photo;
    for (int label = 1; label <= 65535; ++label) {
        core::Segment segment;
        segment.label = static_cast<std::uint16_t>(label);
        segment.name = "s" + std::to_string(label);
        scene.segments.push_back(segment);
    }
    Mask mask(65536, 1);
    mask(0, 0) = 1;
    EXPECT_THROW((void)core::withSegment(scene, mask, "one more"), core::Error);
    EXPECT_EQ(core::withSegment(scene, mask, "12").photo->labels(0, 0), 12);
}

}  // namespace
