// SPDX-License-Identifier: GPL-3.0-or-later
// What a photograph says of itself: the unit of its depth, the level where it clips, how far its depth was enlarged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/analysis/notes.h"
#include "core/analysis/pipeline.h"
#include "core/io/project.h"
#include "tests/support/image_files.h"
#include "tests/support/ray_scene.h"

namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct PhotoTest : testing::Test {
    PhotoTest() {
        test::writePfm(folder / "color.pfm", 4, 2, 3, std::vector<float>(24, 0.5f));
        test::writePfm(folder / "depth.pfm", 4, 2, 1, {1, 2, 3, 4, 5, 6, 7, 8});
    }
    [[nodiscard]] core::Scene create(const std::string& color, const std::string& depth, double unit) {
        notes.clear();
        core::CreateOptions options;
        options.color = folder / color;
        options.depth = folder / depth;
        options.depthUnit = unit;
        options.hfov = 0.9f;
        return core::createScene(options, &notes);
    }
    test::TempFolder folder;
    core::Notes notes;
};

TEST_F(PhotoTest, DepthInTheWrongUnitIsSaid) {
    (void)create("color.pfm", "depth.pfm", 0.001);  // metres read as millimetres
    EXPECT_THAT(core::english(notes), Contains(HasSubstr("unit is probably wrong")));
    EXPECT_THAT(core::english(notes), Contains(HasSubstr("depth.pfm")));
    test::writePfm(folder / "millimetres.pfm", 4, 2, 1, {3000, 3100, 3200, 3300, 3400, 3500, 3600, 3700});
    (void)create("color.pfm", "millimetres.pfm", 1);  // millimetres read as metres
    EXPECT_THAT(core::english(notes), Contains(HasSubstr("unit is probably wrong")));
    (void)create("color.pfm", "millimetres.pfm", 0.001);
    EXPECT_THAT(core::english(notes), Not(Contains(HasSubstr("unit"))));
    (void)create("color.pfm", "depth.pfm", 1);
    EXPECT_THAT(core::english(notes), Not(Contains(HasSubstr("unit"))));
}

TEST_F(PhotoTest, ClipsWhereItsLargestCodeIs) {
    test::writePnm8(folder / "color.ppm", 4, 2, 3, std::vector<std::uint8_t>(24, 255));
    const core::Scene coded = create("color.ppm", "depth.pfm", 1);
    EXPECT_NEAR(coded.photo->clipLevel, 1, 1e-6f);
    EXPECT_NEAR(coded.photo->color(0, 0).x(), coded.photo->clipLevel, 1e-6f);
    EXPECT_TRUE(std::isinf(create("color.pfm", "depth.pfm", 1).photo->clipLevel));
}

TEST_F(PhotoTest, KnowsHowFarItsDepthWasEnlarged) {
    EXPECT_EQ(create("color.pfm", "depth.pfm", 1).photo->depthSampleSpacing, 1);
    test::writePfm(folder / "half.pfm", 2, 1, 1, {2, 2});
    const core::Scene enlarged = create("color.pfm", "half.pfm", 1);
    EXPECT_EQ(enlarged.photo->depthSampleSpacing, 2);
    EXPECT_TRUE(enlarged.photo->depth.sameSize(enlarged.photo->color));
    EXPECT_THAT(core::english(notes), Contains(HasSubstr("enlarged")));
}

TEST_F(PhotoTest, WithoutAnyDepthTheAnalysisSaysOfEachSegmentThatItCannotBeEdited) {
    core::Scene scene = test::stillLife(test::testCamera(80, 60)).scene();
    scene.environment.height = 32;
    core::Photo photo = *scene.photo;
    photo.depth = core::ImageF(80, 60, 0.0f);
    scene.photo = std::make_shared<core::Photo>(photo);
    for (core::Segment& segment : scene.segments) {
        segment.glossy = true;
        segment.edit = core::Material{};
    }
    const auto analysis = core::AnalysisPipeline().run(scene);
    EXPECT_TRUE(std::ranges::all_of(analysis->front->depth.pixels(), [](float z) { return z == 0; }));
    EXPECT_TRUE(analysis->backSides.empty());
    const std::vector<std::string> said = core::english(core::analysisNotes(scene, *analysis));
    for (const core::Segment& segment : scene.segments)
        EXPECT_THAT(said,
                    Contains(HasSubstr("\"" + segment.name + "\" has no pixel with depth, so it cannot be edited")));
}

TEST_F(PhotoTest, SegmentsWithoutAnyDepthAreAnalysedAsTheDistance) {
    core::Scene scene = test::stillLife(test::testCamera(80, 60)).scene();
    scene.environment.height = 32;
    core::Photo photo = *scene.photo;
    for (std::size_t i = 0; i < photo.labels.size(); ++i)
        if (photo.labels[i] == 3) photo.depth[i] = 0;
    scene.photo = std::make_shared<core::Photo>(photo);
    scene.findSegment(3)->glossy = true;
    scene.findSegment(3)->edit = core::Material{};
    const auto analysis = core::AnalysisPipeline().run(scene);
    EXPECT_TRUE(std::ranges::none_of(analysis->backSides, [](const auto& info) { return info.label == 3; }));
    for (std::size_t i = 0; i < photo.labels.size(); ++i) {
        if (photo.labels[i] != 3) continue;
        EXPECT_EQ(analysis->front->depth[i], 0);
        EXPECT_EQ(analysis->back->depth[i], 0);
        EXPECT_EQ(analysis->front->area[i], 0);
    }
}

}  // namespace
