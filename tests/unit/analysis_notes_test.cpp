// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/analysis/pipeline.h"
#include "tests/support/ray_scene.h"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> notesOf(const core::Scene& scene) {
    core::AnalysisPipeline pipeline;
    return core::english(core::analysisNotes(scene, *pipeline.run(scene)));
}

TEST(AnalysisNotes, NothingToSayAboutAGoodScene) {
    core::Scene scene = test::stillLife(test::testCamera(160, 120)).scene();
    scene.environment.height = 32;
    EXPECT_THAT(notesOf(scene), IsEmpty());
}

TEST(AnalysisNotes, NoGlossySegment) {
    core::Scene scene = test::stillLife(test::testCamera(80, 60)).scene();
    for (core::Segment& segment : scene.segments) segment.glossy = false;
    EXPECT_THAT(notesOf(scene), ElementsAre(HasSubstr("No segment is flagged as glossy")));

    // Without a distant pixel either, nothing at all is known.
    core::Photo photo = *scene.photo;
    for (float& z : photo.depth.pixels())
        if (!(z > 0)) z = 5;
    scene.photo = std::make_shared<core::Photo>(photo);
    EXPECT_THAT(notesOf(scene), ElementsAre(HasSubstr("shading")));
    scene.environment.image = std::make_shared<core::ImageRgb>(8, 4, core::Vector3f(1, 1, 1));
    EXPECT_THAT(notesOf(scene), IsEmpty());
}

TEST(AnalysisNotes, GlossySegmentOfFivePixelsAndOneWithoutDepth) {
    core::Scene scene = test::stillLife(test::testCamera(80, 60)).scene();
    scene.environment.height = 32;
    core::Photo photo = *scene.photo;
    for (int x = 0; x < 5; ++x) photo.labels(20 + x, 50) = 40;
    for (std::size_t i = 0; i < photo.labels.size(); ++i)
        if (photo.labels[i] == 3) photo.depth[i] = 0;
    scene.photo = std::make_shared<core::Photo>(photo);
    core::addMissingSegments(scene);
    scene.findSegment(40)->glossy = true;
    const auto notes = notesOf(scene);
    EXPECT_THAT(notes, testing::Contains(HasSubstr("only 5 pixels")));
    EXPECT_THAT(notes, testing::Contains(HasSubstr("has no pixel with depth")));
}

TEST(AnalysisNotes, ThoseOfGlossySegmentsAlone) {
    core::Scene scene = test::stillLife(test::testCamera(80, 60)).scene();
    scene.environment.height = 32;
    core::Photo photo = *scene.photo;
    for (int x = 0; x < 5; ++x) photo.labels(20 + x, 50) = 40;
    scene.photo = std::make_shared<core::Photo>(photo);
    core::addMissingSegments(scene);
    core::AnalysisPipeline pipeline;
    for (core::Segment& segment : scene.segments) segment.glossy = false;
    EXPECT_THAT(core::glossyNotes(scene, *pipeline.run(scene)), IsEmpty());
    scene.findSegment(40)->glossy = true;
    EXPECT_THAT(core::english(core::glossyNotes(scene, *pipeline.run(scene))), ElementsAre(HasSubstr("only 5 pixels")));
}

TEST(AnalysisNotes, ClippedLight) {
    core::Scene scene = test::stillLife(test::testCamera(160, 120)).scene();
    scene.environment.height = 32;
    core::Photo photo = *scene.photo;
    photo.clipLevel = 0.3f;
    for (core::Vector3f& c : photo.color.pixels()) c = c.cwiseMin(0.3f);
    scene.photo = std::make_shared<core::Photo>(photo);
    const auto notes = notesOf(scene);
    EXPECT_THAT(notes, testing::Contains(HasSubstr("clipped the light")));
}

}  // namespace
