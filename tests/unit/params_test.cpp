// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/params.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/other_value.h"

namespace {

template <class Owner>
void expectSoundRows(std::span<const core::Param<Owner>> params) {
    std::set<std::string> keys;
    for (const core::Param<Owner>& param : params) {
        SCOPED_TRACE(param.key);
        EXPECT_TRUE(keys.insert(param.key).second) << "twice";
        EXPECT_STRNE(param.label, "");
        EXPECT_NE(param.stage, core::Stage::Input);
        // These are about an edit, which this table does not know, and about editing.
        const bool ofEdits = std::string_view(param.key) == "visible" || std::string_view(param.key) == "locked";
        EXPECT_EQ(param.stage == core::Stage::Display, ofEdits) << "a parameter changes something";
        for (const auto& word : param.words) EXPECT_STRNE(word.label, "");
        const bool isSwitch = std::holds_alternative<bool>(param.initial);
        if (isSwitch || !param.words.empty()) continue;
        EXPECT_LT(param.legal.min, param.legal.max);
        if (const auto* color = std::get_if<core::Vector3f>(&param.initial)) {
            EXPECT_GE(static_cast<double>(color->minCoeff()), param.legal.min);
            continue;
        }
        EXPECT_GE(core::toNumber(param.initial), param.legal.min);
        EXPECT_LE(core::toNumber(param.initial), param.legal.max);
        EXPECT_GE(param.slider.min, param.slider.max == 0 ? 0 : param.legal.min);
        EXPECT_LE(param.slider.max, param.legal.max);
        if (param.logScale) {
            EXPECT_GT(param.slider.min, 0);
        }
    }
}

core::Scene sceneWithSegment() {
    core::Scene scene;
    scene.segments.resize(1);
    scene.segments[0].label = 1;
    scene.segments[0].name = "a";
    return scene;
}

TEST(Params, RowsAreSound) {
    expectSoundRows(core::segmentParams());
    expectSoundRows(core::sceneParams());
}

TEST(Params, EveryParameterNamesItsStage) {
    const core::Scene before = sceneWithSegment();
    for (const core::SegmentParam& param : core::segmentParams()) {
        core::Scene after = before;
        param.set(after.segments[0], test::otherValue(param, param.get(after.segments[0])));
        EXPECT_EQ(core::firstChangedStage(before, after), param.stage) << param.key;
        EXPECT_EQ(core::firstChangedStage(after, before), param.stage) << param.key;
    }
    for (const core::SceneParam& param : core::sceneParams()) {
        core::Scene after = before;
        param.set(after, test::otherValue(param, param.get(after)));
        EXPECT_EQ(core::firstChangedStage(before, after), param.stage) << param.key;
    }
}

TEST(Params, TheFirstOfSeveralStagesCounts) {
    const core::Scene before = sceneWithSegment();
    core::Scene after = before;
    after.render.samples = 3;
    after.segments[0].glossy = true;
    EXPECT_EQ(core::firstChangedStage(before, after), core::Stage::Reflectance);
}

TEST(Params, AutomaticParametersCanBeSetAndLeftToTheAnalysis) {
    core::Segment segment;
    const core::SegmentParam& smoothing = core::segmentParam("smoothing");
    EXPECT_TRUE(smoothing.automatic);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(smoothing.get(segment)));
    smoothing.set(segment, 3.0f);
    EXPECT_EQ(segment.smoothing, 3.0f);
    smoothing.set(segment, {});
    EXPECT_EQ(segment.smoothing, std::nullopt);
    EXPECT_FALSE(core::segmentParam("glossy").automatic);
}

TEST(Params, NumbersKeepTheTypeOfTheMember) {
    EXPECT_EQ(core::fromNumber(core::sceneParam("render.seed"), 4294967295.0),
              core::ParamValue(std::int64_t{4294967295}));
    EXPECT_EQ(core::fromNumber(core::sceneParam("render.filter"), 0), core::ParamValue(false));
    EXPECT_EQ(core::fromNumber(core::sceneParam("environment.scale"), 0.1), core::ParamValue(0.1f));
    EXPECT_EQ(core::fromNumber(core::sceneParam("render.time_limit"), 0.1), core::ParamValue(0.1));
}

TEST(Params, KeysNameAnObjectAndAKeyInIt) {
    EXPECT_EQ(core::paramObject(core::segmentParam("back_side.offset")), "back_side");
    EXPECT_STREQ(core::paramName(core::segmentParam("back_side.offset")), "offset");
    EXPECT_EQ(core::paramObject(core::segmentParam("smoothing")), "");
    EXPECT_STREQ(core::paramName(core::segmentParam("smoothing")), "smoothing");
}

}  // namespace
