// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/io/material_json.h"
#include "core/io/photo_loader.h"
#include "core/material/brdf.h"
#include "core/material/translucency.h"
#include "core/scene/segments.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"
#include "tests/support/other_value.h"

using core::DepthKind;
using core::ErrorKind;
using core::Vector3f;
using nlohmann::json;

namespace {

class ProjectTest : public testing::Test {
  protected:
    ProjectTest() {
        test::writePfm(folder / "color.pfm", 4, 2, 3, std::vector<float>(24, 0.5f));
        test::writePfm(folder / "depth.pfm", 4, 2, 1, {1, 2, 3, 4, 5, 6, 7, 8});
        test::writePnm8(folder / "labels.pgm", 4, 2, 1, {0, 1, 1, 2, 0, 1, 1, 2});
    }
    [[nodiscard]] core::CreateOptions options() const {
        core::CreateOptions result;
        result.color = folder / "color.pfm";
        result.depth = folder / "depth.pfm";
        result.segments = folder / "labels.pgm";
        result.intrinsics = core::Camera{0, 0, 4, 4, 2, 1};
        return result;
    }
    /// A valid project document.
    [[nodiscard]] json document() const {
        core::saveProject(core::createScene(options()), folder / "base.patina");
        return json::parse(test::readBytes(folder / "base.patina"));
    }
    /// The keys that `expected` has are written in its order, with its values; others may stand between them.
    static void expectWritten(const nlohmann::ordered_json& saved, const std::string& expected) {
        const auto wanted = nlohmann::ordered_json::parse(expected);
        nlohmann::ordered_json found;
        for (const auto& [key, value] : saved.items())
            if (wanted.contains(key)) found[key] = value;
        EXPECT_EQ(found.dump(), wanted.dump());
    }
    /// Loading the document is refused with a message that names the file and these parts.
    void expectRefused(const json& project, std::vector<std::string> parts) {
        test::writeBytes(folder / "bad.patina", project.dump());
        parts.emplace_back("While loading \"" + (folder / "bad.patina") + "\".");
        test::expectError(ErrorKind::Input, parts, [&] { (void)core::loadProject(folder / "bad.patina"); });
    }

    test::TempFolder folder;
};

}  // namespace

TEST_F(ProjectTest, CreateReadsEverything) {
    core::CreateOptions create = options();
    create.glossy = {"2"};
    const core::Scene scene = core::createScene(create);
    EXPECT_EQ(scene.photo->camera, (core::Camera{4, 2, 4, 4, 2, 1}));
    EXPECT_EQ(scene.photo->depth(3, 1), 8);
    EXPECT_EQ(scene.photo->color(0, 0), Vector3f(0.5f, 0.5f, 0.5f));
    ASSERT_EQ(scene.segments.size(), 2U);
    EXPECT_EQ(scene.segments[0].name, "segment 1");
    EXPECT_FALSE(scene.segments[0].glossy);
    EXPECT_TRUE(scene.segments[1].glossy);
}

TEST_F(ProjectTest, CreateRefusesLabelsThatDoNotExist) {
    core::CreateOptions create = options();
    create.glossy = {"7"};
    test::expectError(ErrorKind::Usage, {"\"7\"", "1, 2", "labels.pgm"}, [&] { (void)core::createScene(create); });
}

TEST_F(ProjectTest, SavedProjectLoadsAsTheSameScene) {
    core::Scene scene = core::createScene(options());
    scene.segments[0].name = "Vase \"ä\"";
    scene.segments[0].glossy = true;
    scene.segments[0].backSide = {core::BackSideMethod::ParallelMirror, 0.125f, 0.01f, 1.5f, 0.003f};
    scene.segments[0].reflectance = Vector3f(0.1f, 0.2f, 1.3f);
    scene.segments[0].smoothing = 12.3f;
    scene.segments[0].edit =
        core::materialFromJson(R"({"brdf":"phong","exponent":33.3,"albedo":[0.1,0.2,0.3],"specular":[0.7,0.6,0.5],)"
                               R"("blend":{"new":0.75,"original":0.25}})");
    scene.segments[1].edit = core::materialFromJson(
        R"({"brdf":"none","translucency":{"preset":"marble","eta":1.5,"scale":2,"weight":0.5}})");
    scene.depthFilter = {false, false, 1.5f, 0.2f, 0.02f};
    scene.render = {.samples = 17,
                    .timeLimit = 2.5,
                    .seed = 4000000000U,
                    .bounces = 3,
                    .filter = false,
                    .surfaceSamples = 1234,
                    .irradianceSamples = 56};
    scene.environment.rotation = 0.5f;
    scene.environment.scale = 2;
    scene.environment.height = 64;
    test::writePfm(folder / "env.pfm", 4, 2, 3, std::vector<float>(24, 1.0f));
    scene.environment.path = folder / "env.pfm";
    scene.backDepthPath = folder / "back.pfm";
    test::writePfm(folder / "back.pfm", 4, 2, 1, std::vector<float>(8, 9.0f));
    std::filesystem::create_directory(folder / "sub");
    core::saveProject(scene, folder / "sub/p.patina");

    const core::Scene loaded = core::loadProject(folder / "sub/p.patina");
    EXPECT_EQ(loaded.segments, scene.segments);
    EXPECT_EQ(loaded.depthFilter, scene.depthFilter);
    EXPECT_EQ(loaded.render, scene.render);
    EXPECT_EQ(loaded.environment.rotation, scene.environment.rotation);
    EXPECT_EQ(loaded.environment.scale, scene.environment.scale);
    EXPECT_EQ(loaded.environment.height, scene.environment.height);
    ASSERT_TRUE(loaded.environment.image);
    EXPECT_EQ((*loaded.environment.image)(0, 0), Vector3f(1, 1, 1));
    ASSERT_TRUE(loaded.backDepth);
    EXPECT_EQ((*loaded.backDepth)(2, 1), 9);
    EXPECT_EQ(loaded.photo->camera, scene.photo->camera);
    EXPECT_EQ(loaded.photo->depth.image(), scene.photo->depth.image());
    EXPECT_EQ(loaded.photo->color.image(), scene.photo->color.image());
    EXPECT_EQ(loaded.photo->labels, scene.photo->labels);
    EXPECT_EQ(json::parse(test::readBytes(folder / "sub/p.patina"))["photo"]["color"], "../color.pfm");

    core::saveProject(loaded, folder / "again.patina");
    core::saveProject(core::loadProject(folder / "again.patina"), folder / "third.patina");
    EXPECT_EQ(test::readBytes(folder / "again.patina"), test::readBytes(folder / "third.patina"));
}

TEST_F(ProjectTest, EveryParameterSurvivesAFile) {
    const core::Scene plain = core::createScene(options());
    const auto reloaded = [&](const core::Scene& scene) {
        core::saveProject(scene, folder / "param.patina");
        return core::loadProject(folder / "param.patina");
    };
    for (const core::SegmentParam& param : core::segmentParams()) {
        core::Scene scene = plain;
        const core::ParamValue value = test::otherValue(param, param.get(scene.segments[1]));
        param.set(scene.segments[1], value);
        const core::Scene loaded = reloaded(scene);
        EXPECT_EQ(param.get(loaded.segments[1]), value) << param.key;
        EXPECT_EQ(loaded.segments, scene.segments) << param.key;
    }
    for (const core::SceneParam& param : core::sceneParams()) {
        core::Scene scene = plain;
        const core::ParamValue value = test::otherValue(param, param.get(scene));
        param.set(scene, value);
        EXPECT_EQ(param.get(reloaded(scene)), value) << param.key;
    }
}

TEST_F(ProjectTest, EveryParameterIsRefusedOutsideItsRange) {
    const json base = document();
    const auto refuse = [&](const std::string& place, const core::ParamRow& row, const std::string& pointer) {
        SCOPED_TRACE(place);
        const bool isSwitch = std::holds_alternative<bool>(row.initial);
        const bool isWhole = std::holds_alternative<std::int64_t>(row.initial);
        const bool isColor = std::holds_alternative<Vector3f>(row.initial);
        const auto refused = [&](const json& value, std::vector<std::string> parts) {
            json bad = base;
            bad[json::json_pointer(pointer)] = value;
            parts.push_back("\"" + place);
            expectRefused(bad, parts);
        };
        refused({{"a", 1}}, {"expected"});
        if (isSwitch) return refused(1, {"is 1", "true or false"});
        if (!row.words.empty()) return refused("magic", {"magic", row.words.front().key, row.words.back().key});
        for (const double bad : {row.legal.min - 1, 2 * row.legal.max + 1}) {
            if (isColor)
                refused({1, bad, 1}, {"[1]\" is", "expected"});
            else if (isWhole)
                refused(static_cast<std::int64_t>(bad), {"from " + std::to_string(std::llround(row.legal.min)),
                                                         "to " + std::to_string(std::llround(row.legal.max)),
                                                         "is " + std::to_string(std::llround(bad))});
            else
                refused(bad, {"a number in [", "is " + json(bad).dump()});
        }
    };
    const auto pointerOf = [](std::string key) {
        std::ranges::replace(key, '.', '/');
        return "/" + key;
    };
    for (const core::SegmentParam& param : core::segmentParams())
        refuse("segments[1]." + std::string(param.key), param, "/segments/1" + pointerOf(param.key));
    for (const core::SceneParam& param : core::sceneParams()) refuse(param.key, param, pointerOf(param.key));
}

TEST_F(ProjectTest, TheOrderOfKeysInAFile) {
    core::Scene scene = core::createScene(options());
    scene.segments.resize(1);
    scene.segments[0].reflectance = Vector3f(0.5f, 0.25f, 1);
    scene.segments[0].lobeWidth = 0.1f;
    scene.segments[0].smoothing = 3;
    test::writePfm(folder / "env.pfm", 4, 2, 3, std::vector<float>(24, 1.0f));
    scene.environment.path = folder / "env.pfm";
    test::writePfm(folder / "back.pfm", 4, 2, 1, std::vector<float>(8, 9.0f));
    scene.backDepthPath = folder / "back.pfm";
    core::saveProject(scene, folder / "order.patina");
    const auto saved = nlohmann::ordered_json::parse(test::readBytes(folder / "order.patina"));
    expectWritten(saved["segments"][0],
                  R"({"label":1,"name":"segment 1","glossy":false,"back_side":{"method":"automatic","offset":0.05,)"
                  R"("plane_shift":0.0,"thickness_scale":1.0,"min_thickness":0.002},"reflectance":[0.5,0.25,1.0],)"
                  R"("lobe_width":0.1,"smoothing":3.0})");
    expectWritten(saved["depth_filter"], R"({"enabled":true,"automatic":true,"spatial_sigma":2.0,"color_sigma":0.1,)"
                                         R"("depth_sigma":0.01})");
    expectWritten(saved["environment"], R"({"path":"env.pfm","rotation":0.0,"scale":1.0,"height":128,)"
                                        R"("use":"replace","fill":"membrane"})");
    expectWritten(saved["render"], R"({"samples":64,"time_limit":0.0,"seed":1,"bounces":4,"filter":true,)"
                                   R"("surface_samples":100000,"irradiance_samples":8,)"
                                   R"("translucency_quality":"standard"})");
    std::string keys;
    for (const auto& [key, value] : saved.items()) keys += key + ' ';
    EXPECT_EQ(keys, "format version photo segments depth_filter environment back_depth render ");
}

TEST_F(ProjectTest, AFileWithTheFormerRadiusOfHolesOpensAndLosesIt) {
    json project = document();
    project["depth_filter"]["hole_radius"] = 30;
    test::writeBytes(folder / "older.patina", project.dump());
    const core::Scene scene = core::loadProject(folder / "older.patina");
    core::saveProject(scene, folder / "newer.patina");
    const auto saved = json::parse(test::readBytes(folder / "newer.patina"));
    EXPECT_FALSE(saved["depth_filter"].contains("hole_radius"));
}

TEST_F(ProjectTest, SmoothingIsANumberOrAutomatic) {
    json project = document();
    const auto smoothing = [&](const json& value) {
        project["segments"][0]["smoothing"] = value;
        test::writeBytes(folder / "smoothing.patina", project.dump());
        return core::loadProject(folder / "smoothing.patina").segments[0].smoothing;
    };
    EXPECT_EQ(smoothing(nullptr), std::nullopt);
    EXPECT_EQ(smoothing(0), 0.0f);
    EXPECT_EQ(smoothing(200), 200.0f);
}

TEST_F(ProjectTest, ProjectAndImagesMoveTogether) {
    std::filesystem::create_directory(folder / "old");
    for (const char* name : {"color.pfm", "depth.pfm", "labels.pgm"})
        std::filesystem::copy(folder / name, (folder / "old") + "/" + name);
    core::CreateOptions create = options();
    create.color = folder / "old/color.pfm";
    create.depth = folder / "old/depth.pfm";
    create.segments = folder / "old/labels.pgm";
    core::saveProject(core::createScene(create), folder / "old/p.patina");
    std::filesystem::rename(folder / "old", folder / "new");
    EXPECT_EQ(core::loadProject(folder / "new/p.patina").photo->depth(0, 0), 1);
}

TEST_F(ProjectTest, ChangedLabelsAreSavedBesideTheProject) {
    const core::Scene scene = core::createScene(options());
    core::BinaryMask mask(4, 2);
    mask(0, 0) = 1;
    const core::Scene changed = core::withSegment(scene, mask, "corner");
    core::saveProject(changed, folder / "p.patina");
    const core::Scene loaded = core::loadProject(folder / "p.patina");
    EXPECT_EQ(loaded.photo->labels, changed.photo->labels);
    EXPECT_EQ(loaded.segments, changed.segments);
    const std::string file = loaded.photo->source.segments;
    EXPECT_NE(file.find("p.segments-"), std::string::npos) << file;
    const std::string bytes = test::readBytes(file);
    core::saveProject(loaded, folder / "p.patina");
    core::saveProject(changed, folder / "p.patina");
    EXPECT_EQ(core::loadProject(folder / "p.patina").photo->source.segments, file);
    EXPECT_EQ(test::readBytes(file), bytes);
    EXPECT_EQ(core::loadProject(folder / "p.patina").photo->labels, changed.photo->labels);
    EXPECT_EQ(core::createScene(options()).photo->labels, scene.photo->labels) << "the first map is untouched";
    const core::Scene none = core::deleteSegments(scene, std::vector<std::uint16_t>{1, 2});
    core::saveProject(none, folder / "none.patina");
    EXPECT_TRUE(core::loadProject(folder / "none.patina").segments.empty());
}

TEST_F(ProjectTest, AMapForAnOpenPhotographHasItsShape) {
    core::Camera camera;
    camera.width = 8;
    camera.height = 4;
    const core::LabelImage labels = core::loadLabelMap(folder / "labels.pgm", camera);
    ASSERT_EQ(labels.width(), 8);
    const std::array<int, 4> row{0, 1, 1, 2};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(labels(x, y), row[static_cast<std::size_t>(x / 2)]);
    camera.height = 8;
    test::expectError(ErrorKind::Input, {"labels.pgm", "4x2", "8x8"},
                      [&] { (void)core::loadLabelMap(folder / "labels.pgm", camera); });
}

TEST_F(ProjectTest, TheBundledSampleLoads) {
    const core::Scene scene = core::loadProject(PATINA_SAMPLES "/studio/studio.patina");
    EXPECT_EQ(scene.photo->camera, (core::Camera{960, 640, 1320, 1320, 480, 320}));
    EXPECT_EQ(scene.segments.size(), 11U);
    for (const core::Segment& segment : scene.segments) {
        EXPECT_EQ(segment.glossy, segment.name == "vase" || segment.name == "sphere") << segment.name;
        EXPECT_FALSE(segment.edit) << segment.name;
    }
}

TEST_F(ProjectTest, UnknownKeysAreNamed) {
    const json base = document();
    for (const char* pointer : {"", "/photo", "/photo/intrinsics", "/segments/1", "/segments/1/back_side",
                                "/depth_filter", "/environment", "/render"}) {
        json bad = base;
        bad[json::json_pointer(pointer)]["colour"] = 1;
        expectRefused(bad, {"colour", "unknown"});
    }
    json bad = base;
    bad["segments"][1]["edit"] = {{"brdf", "ggx"}, {"exponent", 3}};
    expectRefused(bad, {"segments[1].edit.exponent", "unknown", "\"ggx\" has the parameters \"alpha\""});
}

TEST_F(ProjectTest, WrongTypesAndRangesAreNamed) {
    const json base = document();
    const std::vector<std::tuple<std::string, json, std::vector<std::string>>> cases = {
        {"/format", "photoshop", {"\"format\": \"patina\""}},
        {"/version", 2, {"version 2", "up to version 1"}},
        {"/version", "1", {"\"version\" is \"1\""}},
        {"/photo", 3, {"\"photo\" is 3", "object"}},
        {"/photo/color", 3, {"\"photo.color\" is 3", "text"}},
        {"/photo/depth_kind", "fuzzy", {"photo.depth_kind", "fuzzy", "\"disparity\""}},
        {"/photo/depth_unit", 0, {"photo.depth_unit", "is 0"}},
        {"/photo/intrinsics/fx", -1, {"photo.intrinsics.fx", "-1"}},
        {"/photo/intrinsics/fx", 1e7, {"do not fit"}},
        {"/segments", {{"a", 1}}, {"segments", "list"}},
        {"/segments/0/label", 0, {"segments[0].label", "is 0", "1 to 65535"}},
        {"/segments/0/label", 9, {"segments[0].label", "is 9", "labels.pgm", "no such label"}},
        {"/segments/0/label", 2, {"segments[1].label", "another segment"}},
        {"/segments/0/name", "segment 2", {"segments[1].name", "another segment"}},
        {"/segments/0/name", "", {"segments[0].name", "empty"}},
        {"/segments/0/glossy", 1, {"segments[0].glossy", "true or false"}},
        {"/segments/0/back_side/method", "magic", {"segments[0].back_side.method", "pca_mirror"}},
        {"/segments/0/reflectance", {1, 2}, {"segments[0].reflectance", "three numbers"}},
        {"/segments/0/smoothing", 200.5, {"segments[0].smoothing", "is 200.5", "[0, 200]"}},
        {"/segments/0/smoothing", "much", {"segments[0].smoothing", "much"}},
        {"/segments/0/edit", {{"brdf", "ggx"}, {"alpha", 7}}, {"segments[0].edit.alpha", "is 7", "[0.01, 1]"}},
        {"/depth_filter/spatial_sigma", "wide", {"depth_filter.spatial_sigma", "wide"}},
        {"/render/samples", 0, {"render.samples", "is 0", "1 to 1000000"}},
        {"/render/seed", -1, {"render.seed", "-1", "4294967295"}},
        {"/environment/scale", "big", {"environment.scale"}},
        {"/environment/path", "no.exr", {"no.exr", "does not exist"}},
        {"/back_depth", "no.exr", {"no.exr", "does not exist"}},
    };
    for (const auto& [pointer, value, parts] : cases) {
        json bad = base;
        bad[json::json_pointer(pointer)] = value;
        SCOPED_TRACE(pointer);
        expectRefused(bad, parts);
    }
    json missing = base;
    missing.erase("photo");
    expectRefused(missing, {"\"photo\"", "missing"});
}

TEST_F(ProjectTest, TextThatIsNoProject) {
    const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
        test::writeBytes(folder / "x.patina", text);
        test::expectError(ErrorKind::Input, parts, [&] { (void)core::loadProject(folder / "x.patina"); });
    };
    refused("{\n\"format\": \"patina\",,}", {"x.patina", "line 2"});
    refused("[]", {"x.patina", "object"});
    refused("{\"format\":\"patina\",\"format\":\"patina\"}", {"\"format\"", "twice"});
    refused(std::string(100000, '['), {"nested"});
    refused("{\"format\":\"patina\",\"version\":1e999}", {"x.patina"});
    refused("\xff\xfe\x00", {"x.patina"});
    refused("", {"x.patina", "empty"});
    test::expectError(ErrorKind::Input, {"none.patina", "does not exist"},
                      [&] { (void)core::loadProject(folder / "none.patina"); });
}

TEST_F(ProjectTest, SavingFailsCleanly) {
    const core::Scene scene = core::createScene(options());
    core::saveProject(scene, folder / "p.patina");
    const std::string before = test::readBytes(folder / "p.patina");
    test::expectError(ErrorKind::Output, {"does not exist"},
                      [&] { core::saveProject(scene, folder / "missing/p.patina"); });
    test::expectError(ErrorKind::Output, {"is a folder"}, [&] { core::saveProject(scene, folder.path().string()); });
    core::Scene bad = scene;
    bad.segments[0].name = "\xff\xfe";
    test::expectError(ErrorKind::Output, {"p.patina", "UTF-8"}, [&] { core::saveProject(bad, folder / "p.patina"); });
    EXPECT_EQ(test::readBytes(folder / "p.patina"), before);
}

TEST_F(ProjectTest, DepthKindsGivePlanarMetres) {
    const core::Camera camera{3, 1, 2, 2, 1.5f, 0.5f};
    const core::ImageF stored(3, 1, 4.0f);
    EXPECT_FLOAT_EQ(core::planarDepth(stored, DepthKind::Z, 0.5, camera)(0, 0), 2);
    // Pixel 0 looks along (-0.5, 0, 1): of 4 units along the ray, 4 / sqrt(1.25) are planar.
    EXPECT_FLOAT_EQ(core::planarDepth(stored, DepthKind::Distance, 0.5, camera)(0, 0),
                    static_cast<float>(2 / std::sqrt(1.25)));
    EXPECT_FLOAT_EQ(core::planarDepth(stored, DepthKind::Distance, 0.5, camera)(1, 0), 2);
    EXPECT_FLOAT_EQ(core::planarDepth(stored, DepthKind::Disparity, 0.5, camera)(0, 0), 0.125f);
    EXPECT_FLOAT_EQ(core::planarDepth(stored, DepthKind::Inverse, 1, camera)(2, 0), 0.25f);
}

TEST_F(ProjectTest, InvalidDepthIsDistant) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    test::writePfm(folder / "depth.pfm", 4, 2, 1, {nan, inf, -inf, -1, 0, 1e10f, 1, 2});
    const core::ImageF depth = core::createScene(options()).photo->depth;
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(depth[i], 0) << i;
    EXPECT_EQ(depth[6], 1);
    test::writePfm(folder / "depth.pfm", 4, 2, 1, std::vector<float>(8, nan));
    test::expectError(ErrorKind::Input, {"depth.pfm", "no valid pixel"}, [&] { (void)core::createScene(options()); });
}

TEST_F(ProjectTest, SmallerDepthIsEnlargedWithoutBlending) {
    test::writePfm(folder / "small.pfm", 2, 1, 1, {1, 5});
    core::CreateOptions create = options();
    create.depth = folder / "small.pfm";
    core::Notes notes;
    const core::ImageF depth = core::createScene(create, &notes).photo->depth;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_EQ(depth(x, y), x < 2 ? 1 : 5);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].english(), testing::HasSubstr("small.pfm"));
}

TEST_F(ProjectTest, TheCodeOfUnmeasuredDepthIsNoWall) {
    const auto noted = [&](const std::vector<std::uint16_t>& values) {
        OIIO::ImageSpec spec(4, 2, 1, OIIO::TypeUInt16);
        test::writeWith("png", folder / "mm.png", spec, OIIO::TypeUInt16, values.data());
        core::CreateOptions create = options();
        create.depth = folder / "mm.png";
        core::Notes notes;
        const float last = core::createScene(create, &notes).photo->depth(3, 1);
        std::string text;
        for (const core::Message& note : notes) text += note.english();
        return std::pair(last, text);
    };
    const auto [code, said] = noted({1000, 1100, 1200, 1300, 1000, 1100, 65535, 65535});
    EXPECT_EQ(code, 0);
    EXPECT_THAT(said, testing::HasSubstr("25 % of the values"));
    const auto [measured, unsaid] = noted({1000, 1100, 1200, 1300, 1000, 60000, 65000, 65535});
    EXPECT_FLOAT_EQ(measured, 65.535f) << "other values are as large";
    EXPECT_THAT(unsaid, testing::Not(testing::HasSubstr("not measured")));
    const auto [relative, guessed] = noted({0, 1100, 1200, 1300, 1000, 60000, 65000, 65535});
    EXPECT_FLOAT_EQ(relative, 65.535f);
    EXPECT_THAT(guessed, testing::HasSubstr("probably relative depth"));
}

TEST_F(ProjectTest, LargerMapsAreReducedAndOtherShapesRefused) {
    test::writePfm(folder / "other.pfm", 3, 2, 1, std::vector<float>(6, 1));
    core::CreateOptions create = options();
    create.depth = folder / "other.pfm";
    test::expectError(ErrorKind::Input,
                      {"Depth image size (3x2) differs in shape from colour image size (4x2)", "other.pfm"},
                      [&] { (void)core::createScene(create); });
    std::vector<float> depth(32, 1);
    depth[8 * 3 + 5] = 9;  // in the last row: under the photograph's pixel (2, 1)
    test::writePfm(folder / "large.pfm", 8, 4, 1, depth);
    create.depth = folder / "large.pfm";
    core::Notes notes;
    const core::ImageF reduced = core::createScene(create, &notes).photo->depth;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_EQ(reduced(x, y), x == 2 && y == 1 ? 9 : 1) << "not a mixture";
    EXPECT_THAT(notes.front().english(), testing::HasSubstr("reduced to the colour image (4x2)"));
    create = options();
    create.segments = folder / "other.pfm";
    test::expectError(ErrorKind::Input, {"Label map size (3x2)"}, [&] { (void)core::createScene(create); });
}

TEST_F(ProjectTest, MapsWithoutOrientationTurnWithThePhotograph) {
    // Stored 4x2, shown 2x4 (orientation 6); the depth map has the stored layout and no tag.
    OIIO::ImageSpec spec(4, 2, 3, OIIO::TypeUInt8);
    spec["Orientation"] = 6;
    test::writeWith("tiff", folder / "turned.tif", spec, OIIO::TypeUInt8, std::vector<std::uint8_t>(24, 9).data());
    core::CreateOptions create = options();
    create.color = folder / "turned.tif";
    create.intrinsics = core::Camera{0, 0, 4, 4, 1, 2};
    const core::Scene scene = core::createScene(create);
    EXPECT_EQ(scene.photo->camera.width, 2);
    EXPECT_EQ(scene.photo->depth(0, 0), 5) << "clockwise: the lower left corner comes to the upper left";
    EXPECT_EQ(scene.photo->depth(1, 3), 4);
    EXPECT_EQ(scene.photo->labels(0, 3), 2);
}

TEST_F(ProjectTest, IntegerUnits) {
    test::writeBytes(folder / "d16.png", test::pngBytes(4, 2, 16, 0,
                                                        {std::string("\x03\xe8\x03\xe8\x03\xe8\x03\xe8", 8),
                                                         std::string("\x07\xd0\x07\xd0\x07\xd0\x07\xd0", 8)}));
    core::CreateOptions create = options();
    create.depth = folder / "d16.png";
    EXPECT_FLOAT_EQ(core::createScene(create).photo->depth(0, 1), 2.0f);
    create.depthUnit = 0.0002;
    EXPECT_FLOAT_EQ(core::createScene(create).photo->depth(0, 1), 0.4f);
    create.depthUnit = std::nullopt;
    create.depthKind = DepthKind::Disparity;
    test::expectError(ErrorKind::Usage, {"d16.png", "16-bit", "metres per stored unit"},
                      [&] { (void)core::createScene(create); });
    test::writePnm8(folder / "d8.pgm", 4, 2, 1, std::vector<std::uint8_t>(8, 100));
    create.depth = folder / "d8.pgm";
    create.depthKind = DepthKind::Z;
    test::expectError(ErrorKind::Usage, {"d8.pgm", "8-bit"}, [&] { (void)core::createScene(create); });
    create.depthUnit = 0.0;
    test::expectError(ErrorKind::Usage, {"depth unit"}, [&] { (void)core::createScene(create); });
}

TEST_F(ProjectTest, FocalLengthFromOptionsExifOrAssumed) {
    core::CreateOptions create = options();
    create.intrinsics.reset();
    core::Notes notes;
    const auto camera = [&] {
        notes.clear();
        return core::createScene(create, &notes).photo->camera;
    };
    EXPECT_NEAR(static_cast<double>(camera().fx), 2 / std::tan(std::numbers::pi / 6), 1e-5);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].english(), testing::HasSubstr("60 degrees"));
    create.hfov = std::numbers::pi_v<float> / 2;
    EXPECT_NEAR(static_cast<double>(camera().fx), 2, 1e-5);
    EXPECT_TRUE(notes.empty());
    create.hfov.reset();

    OIIO::ImageSpec spec(48, 32, 3, OIIO::TypeUInt8);
    spec["Exif:FocalLengthIn35mmFilm"] = 36;
    test::writeWith("jpeg", folder / "photo.jpg", spec, OIIO::TypeUInt8,
                    std::vector<std::uint8_t>(48 * 32 * 3, 90).data());
    test::writePfm(folder / "deep.pfm", 48, 32, 1, std::vector<float>(48 * 32, 1.0f));
    create.color = folder / "photo.jpg";
    create.depth = folder / "deep.pfm";
    create.segments.clear();
    EXPECT_NEAR(static_cast<double>(camera().fx), 48, 1e-3) << "36 mm on a frame of 3:2 is as wide as far";
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].english(), testing::HasSubstr("36 mm"));

    create.hfov = 4.0f;
    test::expectError(ErrorKind::Usage, {"field of view"}, [&] { (void)camera(); });
}

TEST_F(ProjectTest, DepthInsideTheColourFile) {
    OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeFloat);
    spec.channelnames = {"R", "G", "B", "Z"};
    const float pixels[] = {1, 2, 3, 4, 5, 6, 7, 8};
    test::writeWith("openexr", folder / "rgbz.exr", spec, OIIO::TypeFloat, pixels);
    core::CreateOptions create;
    create.color = folder / "rgbz.exr";
    EXPECT_EQ(core::createScene(create).photo->depth(1, 0), 8);
    core::saveProject(core::createScene(create), folder / "rgbz.patina");
    EXPECT_EQ(core::loadProject(folder / "rgbz.patina").photo->depth(1, 0), 8);
    create.color = folder / "color.pfm";
    core::Notes notes;
    EXPECT_EQ(core::createScene(create, &notes).photo->depth(1, 0), 0);
    EXPECT_THAT(core::english(notes), testing::Contains(testing::HasSubstr("no depth")));
}

TEST_F(ProjectTest, EnvironmentHasToBeLatitudeLongitude) {
    test::writePfm(folder / "square.pfm", 2, 2, 3, std::vector<float>(12, 1));
    test::expectError(ErrorKind::Input, {"square.pfm", "2x2", "twice as wide"},
                      [&] { (void)core::loadEnvironment(folder / "square.pfm"); });
}

TEST(MaterialJson, EveryBrdfRoundTripsWithItsInitialValues) {
    for (const core::BrdfInfo& brdf : core::brdfs()) {
        const core::Material material = core::materialFromJson("{\"brdf\": \"" + std::string(brdf.key) + "\"}");
        EXPECT_EQ(material.brdf, brdf.key);
        EXPECT_EQ(material.fresnel, brdf.defaultFresnel);
        EXPECT_FALSE(material.specular) << "estimated";
        for (std::size_t i = 0; i < brdf.params.size(); ++i)
            EXPECT_EQ(material.values[i], brdf.params[i].initial) << brdf.params[i].key;
        EXPECT_EQ(core::materialFromJson(core::materialToJson(material)), material);
        for (std::size_t i = 0; i < brdf.params.size(); ++i)
            for (const float edge : {brdf.params[i].min, brdf.params[i].max}) {
                json edit{{"brdf", brdf.key}, {brdf.params[i].key, edge}};
                EXPECT_EQ(core::materialFromJson(edit.dump()).values[i], edge);
            }
    }
}

TEST(MaterialJson, AllKeys) {
    const core::Material m = core::materialFromJson(
        R"({"brdf":"ggx","albedo":[0,0.5,1],"specular":[0.95,0.68,0.3],"alpha":0.05,"fresnel":"conductor",)"
        R"("eta":[0.2,0.9,1.1],"k":3,"blend":{"new":0.5},)"
        R"("translucency":{"sigma_a":[1,2,3],"sigma_s_prime":[4,5,6],"eta":1,"scale":2,"weight":0.5}})");
    EXPECT_EQ(m.albedo, Vector3f(0, 0.5f, 1));
    EXPECT_EQ(m.specular, Vector3f(0.95f, 0.68f, 0.3f));
    EXPECT_EQ(m.values[0], 0.05f);
    EXPECT_EQ(m.fresnel, core::Fresnel::Conductor);
    EXPECT_EQ(m.eta, Vector3f(0.2f, 0.9f, 1.1f));
    EXPECT_EQ(m.k, Vector3f(3, 3, 3));
    EXPECT_EQ(m.blendNew, 0.5f);
    EXPECT_EQ(m.blendOriginal, 0);
    ASSERT_TRUE(m.translucency);
    EXPECT_EQ(m.translucency->sigmaA, Vector3f(1, 2, 3));
    EXPECT_EQ(m.translucency->sigmaSPrime, Vector3f(4, 5, 6));
    EXPECT_EQ(m.translucency->eta, 1);
    EXPECT_EQ(m.translucency->scale, 2);
    EXPECT_EQ(m.translucency->weight, 0.5f);
    EXPECT_EQ(core::materialFromJson(core::materialToJson(m)), m);
}

TEST(MaterialJson, TranslucencyByPresetAndByDiffuseColour) {
    const core::Material preset = core::materialFromJson(R"({"brdf":"none","translucency":{"preset":"marble"}})");
    ASSERT_TRUE(preset.translucency);
    EXPECT_EQ(preset.translucency->preset, "marble");
    EXPECT_EQ(preset.translucency->sigmaA, Vector3f(0.0021f, 0.0041f, 0.0071f));  // [JMLH01], figure 5
    EXPECT_EQ(preset.translucency->sigmaSPrime, Vector3f(2.19f, 2.62f, 3.00f));
    EXPECT_EQ(preset.translucency->eta, 1.5f);

    const core::Material diffuse = core::materialFromJson(
        R"({"brdf":"none","translucency":{"diffuse_color":[0.8,0.5,0.2],"mean_free_path_mm":[5,2,1],"eta":1.4}})");
    ASSERT_TRUE(diffuse.translucency);
    EXPECT_EQ(diffuse.translucency->eta, 1.4f);
    const core::Vector3f color = core::diffuseReflectance(*diffuse.translucency);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(static_cast<double>(color[c]), (std::array{0.8, 0.5, 0.2}[static_cast<std::size_t>(c)]), 2e-3);
        const auto sigmaA = static_cast<double>(diffuse.translucency->sigmaA[c]);
        const auto sigmaS = static_cast<double>(diffuse.translucency->sigmaSPrime[c]);
        EXPECT_NEAR(1 / std::sqrt(3 * sigmaA * (sigmaA + sigmaS)),
                    (std::array{5.0, 2.0, 1.0}[static_cast<std::size_t>(c)]), 0.01);
    }
}

TEST(MaterialJson, MistakesAreNamed) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {R"({"alpha":0.1})", {"\"brdf\"", "missing"}},
        {R"({"brdf":"velvet"})", {"\"brdf\"", "velvet", "\"ggx\""}},
        {R"({"brdf":"ggx","shiny":1})", {"shiny", "unknown"}},
        {R"({"brdf":"ggx","alpha":2})", {"\"alpha\" is 2", "[0.01, 1]"}},
        {R"({"brdf":"ggx","alpha":"0.1"})", {"\"alpha\"", "a number"}},
        {R"({"brdf":"lambert","albedo":[0.1,0.2]})", {"\"albedo\"", "three numbers"}},
        {R"({"brdf":"lambert","albedo":[0.1,0.2,1.5]})", {"\"albedo[2]\" is 1.5", "[0, 1]"}},
        {R"({"brdf":"ggx","specular":"shiny"})", {"\"specular\"", "estimated"}},
        {R"({"brdf":"ggx","fresnel":"fancy"})", {"\"fresnel\"", "\"schlick\""}},
        {R"({"brdf":"ggx","eta":0})", {"\"eta\" is 0"}},
        {R"({"brdf":"ggx","blend":{"newer":1}})", {"blend.newer", "unknown"}},
        {R"({"brdf":"ggx","translucency":{}})", {"\"translucency\"", "exactly one"}},
        {R"({"brdf":"ggx","translucency":{"preset":"marble","sigma_a":[1,1,1]}})", {"exactly one"}},
        {R"({"brdf":"ggx","translucency":{"sigma_a":[1,1,1]}})", {"sigma_s_prime", "missing"}},
        {R"({"brdf":"ggx","translucency":{"preset":"unobtainium"}})", {"unobtainium", "\"marble\""}},
        {R"({"brdf":"ggx","translucency":{"preset":"marble","eta":0.5}})", {"translucency.eta", "0.5", "[1, 3]"}},
        {R"({"brdf":)", {"JSON", "damaged"}},
        {R"(["ggx"])", {"object"}},
        {R"({"brdf":"ggx","brdf":"phong"})", {"\"brdf\"", "twice"}},
    };
    for (const auto& [text, parts] : cases) {
        SCOPED_TRACE(text);
        test::expectError(ErrorKind::Usage, parts, [&, &edit = text] { (void)core::materialFromJson(edit); });
    }
}
