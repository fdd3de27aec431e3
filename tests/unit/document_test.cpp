// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/document.h"
#include "core/scene/changes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

namespace {

core::Scene makeScene() {
    auto photo = std::make_shared<core::Photo>();
    photo->camera = {2, 1, 1, 1, 1, 0.5f};
    photo->color = core::ImageRgb(2, 1, core::Vector3f(1, 1, 1));
    photo->depth = core::ImageF(2, 1, 1.0f);
    photo->labels = core::LabelImage(2, 1, 3);
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    return scene;
}

void setExponent(core::Scene& scene, float exponent) {
    core::Material material;
    material.brdf = "phong";
    material.values[0] = exponent;
    scene.segments[0].edit = material;
}

float exponent(const core::Document& document) {
    const auto& edit = document.scene().segments[0].edit;
    return edit ? edit->values[0] : 0.0f;
}

}  // namespace

TEST(Document, UndoAndRedoRestoreScenesAndLabels) {
    core::Document document(makeScene());
    EXPECT_FALSE(document.canUndo());
    document.edit("Exponent", [](core::Scene& s) { setExponent(s, 10); });
    document.edit("Glossy", [](core::Scene& s) { s.segments[0].glossy = true; });
    EXPECT_EQ(document.undoLabel(), "Glossy");
    document.undo();
    EXPECT_FALSE(document.scene().segments[0].glossy);
    EXPECT_EQ(document.undoLabel(), "Exponent");
    EXPECT_EQ(document.redoLabel(), "Glossy");
    document.undo();
    EXPECT_EQ(exponent(document), 0);
    EXPECT_FALSE(document.canUndo());
    document.redo();
    EXPECT_EQ(exponent(document), 10);
    document.redo();
    EXPECT_TRUE(document.scene().segments[0].glossy);
    EXPECT_FALSE(document.canRedo());
}

TEST(Document, ANewEditForgetsWhatWasUndone) {
    core::Document document(makeScene());
    document.edit("a", [](core::Scene& s) { setExponent(s, 1); });
    document.undo();
    document.edit("b", [](core::Scene& s) { setExponent(s, 2); });
    EXPECT_FALSE(document.canRedo());
    EXPECT_EQ(exponent(document), 2);
}

TEST(Document, ADraggedSliderIsOneStep) {
    core::Document document(makeScene());
    for (const float value : {1.0f, 2.0f, 3.0f})
        document.edit(
            "Exponent", [&](core::Scene& s) { setExponent(s, value); }, "exponent");
    document.endMerge();
    document.edit(
        "Exponent", [](core::Scene& s) { setExponent(s, 9); }, "exponent");
    document.undo();
    EXPECT_EQ(exponent(document), 3);
    document.undo();
    EXPECT_EQ(exponent(document), 0);
    EXPECT_FALSE(document.canUndo());
}

TEST(Document, UndoEndsADrag) {
    core::Document document(makeScene());
    document.edit(
        "a", [](core::Scene& s) { setExponent(s, 1); }, "exponent");
    document.edit("b", [](core::Scene& s) { s.segments[0].glossy = true; });
    document.undo();
    document.edit(
        "c", [](core::Scene& s) { setExponent(s, 2); }, "exponent");
    document.undo();
    EXPECT_EQ(exponent(document), 1) << "the edit after an undo is a step of its own";
}

TEST(Document, ModifiedFollowsTheSavedState) {
    core::Document document(makeScene(), "a.patina");
    EXPECT_FALSE(document.modified());
    document.edit("a", [](core::Scene& s) { setExponent(s, 1); });
    EXPECT_TRUE(document.modified());
    document.setSaved("b.patina");
    EXPECT_EQ(document.path(), "b.patina");
    EXPECT_FALSE(document.modified());
    document.undo();
    EXPECT_TRUE(document.modified());
    document.redo();
    EXPECT_FALSE(document.modified());
    document.undo();
    document.edit("b", [](core::Scene& s) { setExponent(s, 1); });
    EXPECT_TRUE(document.modified()) << "another way to the same values is still another step";
}

TEST(Document, SavingEndsADrag) {
    core::Document document(makeScene());
    document.edit(
        "a", [](core::Scene& s) { setExponent(s, 1); }, "exponent");
    document.setSaved("a.patina");
    document.edit(
        "a", [](core::Scene& s) { setExponent(s, 2); }, "exponent");
    document.undo();
    EXPECT_FALSE(document.modified());
    EXPECT_EQ(exponent(document), 1);
}

TEST(Document, RevisionsAreNeverShared) {
    core::Document document(makeScene());
    std::vector<std::uint64_t> seen{document.revision()};
    document.edit("a", [](core::Scene& s) { setExponent(s, 1); });
    seen.push_back(document.revision());
    document.undo();
    seen.push_back(document.revision());
    document.redo();
    seen.push_back(document.revision());
    for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_GT(seen[i], seen[i - 1]);
}

TEST(Document, TheListenerHearsTheFirstStage) {
    core::Document document(makeScene());
    std::vector<core::Stage> stages;
    document.setChangeListener([&](core::Stage stage) { stages.push_back(stage); });
    document.edit("a", [](core::Scene& s) { setExponent(s, 1); });
    document.edit("b", [](core::Scene& s) { s.segments[0].backSide.offset = 1; });
    document.undo();
    ASSERT_EQ(stages.size(), 3U);
    EXPECT_EQ(stages[0], core::Stage::Reshade);
    EXPECT_EQ(stages[1], core::Stage::BackSide);
    EXPECT_EQ(stages[2], core::Stage::BackSide);
}

TEST(Document, NothingHappensWhenNothingChangesOrTheChangeThrows) {
    core::Document document(makeScene());
    int calls = 0;
    document.setChangeListener([&](core::Stage) { ++calls; });
    const std::uint64_t revision = document.revision();
    document.edit("same", [](core::Scene& s) { s.segments[0].glossy = false; });
    const auto refuse = [](core::Scene& s) {
        s.segments.clear();
        throw std::runtime_error("no");
    };
    EXPECT_THROW(document.edit("throws", refuse), std::runtime_error);
    EXPECT_EQ(document.revision(), revision);
    EXPECT_EQ(document.scene().segments.size(), 1U);
    EXPECT_FALSE(document.canUndo());
    EXPECT_EQ(calls, 0);
}

TEST(Document, SelectingIsUndoneAndIsNoChangeOfTheProject) {
    core::Document document(makeScene());
    const auto select = [&](int x) {
        auto selection = std::make_shared<core::PixelSelection>();
        selection->mask = core::BinaryMask(2, 1);
        selection->mask(x, 0) = 1;
        document.edit("select", [&](core::Scene& scene) { scene.selection = selection; });
    };
    select(0);
    EXPECT_FALSE(document.modified());
    select(1);
    EXPECT_EQ(document.scene().selection->mask(1, 0), 1);
    document.edit("edit", [](core::Scene& scene) { setExponent(scene, 5); });
    EXPECT_TRUE(document.modified());
    document.undo();
    EXPECT_FALSE(document.modified());
    document.undo();
    EXPECT_EQ(document.scene().selection->mask(0, 0), 1);
    document.undo();
    EXPECT_EQ(document.scene().selection, nullptr);
    EXPECT_FALSE(document.canUndo());
    document.redo();
    EXPECT_NE(document.scene().selection, nullptr);
    EXPECT_FALSE(document.modified());
}

// 128 MiB a label map: the first steps are forgotten, the latest can be undone.
TEST(Document, TheHistoryOfLabelMapsIsBounded) {
    constexpr int kSide = 8192;
    core::Scene scene = makeScene();
    core::Document document(scene);
    const auto relabel = [&] {
        auto photo = std::make_shared<core::Photo>(*scene.photo);
        photo->labels = core::LabelImage(kSide, kSide, 3);
        document.edit("labels", [&](core::Scene& next) { next.photo = photo; });
    };
    for (int i = 0; i < 12; ++i) relabel();
    int steps = 0;
    for (; document.canUndo(); ++steps) document.undo();
    EXPECT_EQ(steps, 8) << "1 GiB";
}

TEST(Document, CopiesOfAPhotographShareItsPixels) {
    const core::Scene scene = makeScene();
    core::Photo copy = *scene.photo;
    EXPECT_TRUE(copy.color.shares(scene.photo->color));
    copy.labels(0, 0) = 7;
    EXPECT_TRUE(copy.color.shares(scene.photo->color));
    EXPECT_EQ(scene.photo->labels(0, 0), 3);
    copy.color(0, 0) = {9, 9, 9};
    EXPECT_FALSE(copy.color.shares(scene.photo->color)) << "what is written to is its own";
    EXPECT_EQ(scene.photo->color(0, 0), core::Vector3f(1, 1, 1));
    EXPECT_TRUE(copy.depth.shares(scene.photo->depth));
}
