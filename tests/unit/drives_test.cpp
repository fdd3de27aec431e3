// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/analysis/pipeline.h"
#include "core/analysis/step.h"
#include "core/base/color.h"
#include "core/io/mask_io.h"
#include "core/io/material_json.h"
#include "core/io/project.h"
#include "core/scene/changes.h"
#include "core/scene/masks.h"
#include "core/shading/drive_table.h"
#include "core/shading/reference_renderer.h"
#include "tests/support/analytic_scene.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"

using core::Drive;
using core::DriveEnd;
using core::DriveSource;
using core::ErrorKind;
using core::Mask;
using core::Vector3f;

namespace {

std::shared_ptr<const Mask> makeMask(int width, int height, const std::function<float(int, int)>& value) {
    core::ImageF values(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) values(x, y) = value(x, y);
    return std::make_shared<Mask>(values);
}

DriveEnd at(float value) { return {.value = Vector3f::Constant(value), .factor = false}; }

Drive maskDrive(const char* parameter, std::shared_ptr<const Mask> mask, float from, float to) {
    Drive drive;
    drive.parameter = parameter;
    drive.mask = std::move(mask);
    drive.from = at(from);
    drive.to = at(to);
    return drive;
}

Drive luminanceDrive(const char* parameter, float strength = 1) {
    Drive drive;
    drive.parameter = parameter;
    drive.source = DriveSource::Luminance;
    drive.strength = strength;
    return drive;
}

/// A sphere of label 1 before a sky; the photograph is grey.
test::AnalyticScene ball(int size) {
    test::AnalyticScene s(test::squareCamera(size, static_cast<float>(size)),
                          test::sphere(0.35f, 1.2f, Vector3f(0.4f, 0.4f, 0.4f)));
    s.setEnvironment([](const Vector3f& d) { return Vector3f(1.2f - d.y(), 1, 1 + 0.8f * d.x()); });
    s.scene.render.bounces = 1;
    s.scene.render.samples = 4;
    return s;
}

/// The step that separates texture from shading, on this scene.
std::shared_ptr<const core::ImageF> textureDetail(const test::AnalyticScene& s) {
    core::analysis::Board board;
    board.scene = &s.scene;
    board.front = s.analysis->front;
    core::analysis::textureDetailStep().run(board, {});
    return board.textureDetail;
}

double meanInside(const core::ImageRgb& image, const core::LabelImage& labels, int channel) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (labels[i] != 1) continue;
        sum += static_cast<double>(image[i][channel]);
        ++count;
    }
    return sum / count;
}

}  // namespace

TEST(Mask, KeepsSixteenBitsAndSharesWhatAStrokeDoesNotTouch) {
    Mask mask(200, 100);
    EXPECT_EQ(mask.value(199, 99), 0.0f);
    mask.change(-5, -5, 3, 3, [](int, int, float) { return 2.0f; });
    EXPECT_EQ(mask.value(3, 3), 1.0f);
    EXPECT_EQ(mask.value(4, 3), 0.0f);
    Mask second = mask;
    second.setPath("kept.png");
    second.change(150, 70, 150, 70, [](int, int, float old) { return old + 0.25f; });
    EXPECT_EQ(second.path(), "");
    EXPECT_NEAR(second.value(150, 70), 0.25f, 0.51f / Mask::kSteps);
    EXPECT_EQ(mask.value(150, 70), 0.0f);
    EXPECT_EQ(second.changedRows(mask), std::make_pair(64, 100));
    EXPECT_EQ(mask.changedRows(mask).first, mask.changedRows(mask).second);
    EXPECT_NE(second.hash(), mask.hash());
    EXPECT_EQ(Mask(second.image()).hash(), second.hash());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(makeMask(2, 2, [&](int, int) { return nan; })->value(1, 1), 0.0f);
}

TEST(MaskFiles, StoredValuesAreFractions) {
    const test::TempFolder folder;
    test::writePnm8(folder / "m.pgm", 3, 1, 1, {0, 51, 255});
    const auto mask = core::loadMask(folder / "m.pgm");
    EXPECT_EQ(mask->value(0, 0), 0.0f);
    EXPECT_EQ(mask->value(1, 0), 0.2f);
    EXPECT_EQ(mask->value(2, 0), 1.0f);
    EXPECT_EQ(mask->path(), folder / "m.pgm");
    test::writePfm(folder / "f.pfm", 3, 1, 1, {-1, 0.5f, 3});
    EXPECT_NEAR(core::loadMask(folder / "f.pfm")->value(1, 0), 0.5f, 1e-5f);
    EXPECT_EQ(core::loadMask(folder / "f.pfm")->value(2, 0), 1.0f);
}

TEST(MaskFiles, WhatCannotBeUsedIsNamed) {
    const test::TempFolder folder;
    test::writePfm(folder / "nan.pfm", 2, 2, 1, {0, 1, std::numeric_limits<float>::quiet_NaN(), 0});
    test::expectError(ErrorKind::Input, {"nan.pfm", "(0, 1)", "0 to 1"},
                      [&] { (void)core::loadMask(folder / "nan.pfm"); });
    test::writeBytes(folder / "torn.png", "\x89PNG\r\n");
    test::expectError(ErrorKind::Input, {"torn.png"}, [&] { (void)core::loadMask(folder / "torn.png"); });
    test::expectError(ErrorKind::Input, {"none.png"}, [&] { (void)core::loadMask(folder / "none.png"); });
}

TEST(DriveJson, ReadsWhatItWrites) {
    const test::TempFolder folder;
    test::writePnm8(folder / "m.pgm", 2, 1, 1, {0, 255});
    const std::string file = nlohmann::json(folder / "m.pgm").dump();
    const std::string text =
        R"({"brdf":"ggx","translucency":{"preset":"marble"},"drives":[{"parameter":"alpha","mask":)" + file +
        R"(,"from":0.05,"to":0.5,"contrast":2},{"parameter":"specular","mask":)" + file +
        R"(,"from":0.5,"to":[1,0.5,0.25],"invert":true},)" +
        R"({"parameter":"translucency.weight","source":"luminance","strength":0.5},)" +
        R"({"parameter":"blend.new","source":"luminance","from":0,"to":1}]})";
    const core::Material m = core::materialFromJson(text);
    ASSERT_EQ(m.drives.size(), 4u);
    EXPECT_EQ(m.drives[0].strength, 2);
    EXPECT_EQ(m.drives[0].mask, m.drives[1].mask) << "drives that name one file share it";
    EXPECT_EQ(m.drives[1].from, (DriveEnd{.value = Vector3f(0.5f, 0.5f, 0.5f), .factor = true}));
    EXPECT_EQ(m.drives[1].to, (DriveEnd{.value = Vector3f(1, 0.5f, 0.25f), .factor = false}));
    EXPECT_TRUE(m.drives[1].invert);
    EXPECT_FALSE(m.drives[2].from.has_value());
    core::Material again = core::materialFromJson(core::materialToJson(m));
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(again.drives[i].mask->path(), m.drives[i].mask->path());
        again.drives[i].mask = m.drives[i].mask;
    }
    EXPECT_EQ(again, m);
}

TEST(DriveJson, MistakesAreNamed) {
    const test::TempFolder folder;
    test::writePnm8(folder / "m.pgm", 1, 1, 1, {0});
    const std::string mask = R"("mask":)" + nlohmann::json(folder / "m.pgm").dump();
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {R"({})", {"drives", "list"}},
        {R"([{"mask":"m.png"}])", {"drives[0].parameter", "missing"}},
        {R"([{"parameter":"exponent"}])", {"\"drives[0].parameter\"", "exponent", "\"alpha\""}},
        {R"([{"parameter":"alpha"}])", {"drives[0].mask", "missing"}},
        {R"([{"parameter":"alpha","mask":""}])", {"drives[0].mask", "empty"}},
        {R"([{"parameter":"alpha","source":"noise"}])", {"drives[0].source", "\"luminance\""}},
        {R"([{"parameter":"alpha",)" + mask + "}]", {"\"from\"", "\"to\"", "alpha"}},
        {R"([{"parameter":"alpha",)" + mask + R"(,"to":7}])", {"drives[0].to", "7", "[0.01, 1]"}},
        {R"([{"parameter":"specular",)" + mask + R"(,"to":"red"}])", {"drives[0].to", "[r, g, b]"}},
        {R"([{"parameter":"alpha",)" + mask + R"(,"to":0.5,"strength":1}])", {"drives[0].strength", "unknown"}},
        {R"([{"parameter":"alpha",)" + mask + R"(,"to":0.5},{"parameter":"alpha",)" + mask + R"(,"to":0.5}])",
         {"drives[1].parameter", "already"}},
        {R"([{"parameter":"alpha","mask":"/none/m.png","to":0.5}])", {"/none/m.png"}},
    };
    for (const auto& [drives, parts] : cases) {
        SCOPED_TRACE(drives);
        const std::string text = R"({"brdf":"ggx","drives":)" + drives + "}";
        const ErrorKind kind = parts.front() == "/none/m.png" ? ErrorKind::Input : ErrorKind::Usage;
        test::expectError(kind, parts, [&] { (void)core::materialFromJson(text); });
    }
}

class DriveProjectTest : public testing::Test {
  protected:
    DriveProjectTest() {
        test::writePfm(folder / "color.pfm", 4, 2, 3, std::vector<float>(24, 0.5f));
        test::writePfm(folder / "depth.pfm", 4, 2, 1, {1, 2, 3, 4, 5, 6, 7, 8});
        test::writePnm8(folder / "labels.pgm", 4, 2, 1, {0, 1, 1, 2, 0, 1, 1, 2});
        core::CreateOptions options;
        options.color = folder / "color.pfm";
        options.depth = folder / "depth.pfm";
        options.segments = folder / "labels.pgm";
        scene = core::createScene(options);
        scene.segments[0].edit = core::materialFromJson(R"({"brdf":"artist"})");
    }
    test::TempFolder folder;
    core::Scene scene;
};

TEST_F(DriveProjectTest, PaintedMasksAreKeptBesideTheProject) {
    const auto painted = makeMask(4, 2, [](int x, int y) { return 0.123f * static_cast<float>(x + y); });
    scene.segments[0].edit->drives = {maskDrive("roughness", painted, 0.1f, 0.9f),
                                      maskDrive("metallic", painted, 0, 1)};
    core::saveProject(scene, folder / "p.patina");
    core::saveProject(scene, folder / "p.patina");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "p.masks"), {}), 1) << "one mask, one file";
    const core::Scene loaded = core::loadProject(folder / "p.patina");
    const std::vector<Drive>& drives = loaded.segments[0].edit->drives;
    ASSERT_EQ(drives.size(), 2u);
    EXPECT_EQ(drives[0].mask, drives[1].mask);
    EXPECT_EQ(drives[0].mask->image(), painted->image());
    EXPECT_NE(drives[0].mask->path(), "");

    // Another stroke is another file, and the old project stays loadable.
    auto stroke = std::make_shared<Mask>(*drives[0].mask);
    stroke->change(1, 0, 1, 0, [](int, int, float) { return 1.0f; });
    core::Scene next = loaded;
    next.segments[0].edit->drives[0].mask = stroke;
    std::filesystem::copy_file(folder / "p.patina", folder / "old.patina");
    core::saveProject(next, folder / "p.patina");
    EXPECT_EQ(core::loadProject(folder / "p.patina").segments[0].edit->drives[0].mask->value(1, 0), 1.0f);
    EXPECT_EQ(core::loadProject(folder / "old.patina").segments[0].edit->drives[0].mask->image(), painted->image());
}

TEST_F(DriveProjectTest, MasksOfAnotherSizeAreRefusedAndOnesOfAnotherSegmentNoted) {
    test::writePnm8(folder / "small.pgm", 3, 2, 1, std::vector<std::uint8_t>(6, 9));
    scene.segments[0].edit->drives = {maskDrive("roughness", core::loadMask(folder / "small.pgm"), 0.1f, 0.9f)};
    core::saveProject(scene, folder / "p.patina");
    test::expectError(ErrorKind::Input, {"small.pgm", "roughness", "segment 1", "3x2", "4x2", "p.patina"},
                      [&] { (void)core::loadProject(folder / "p.patina"); });

    test::writePnm8(folder / "elsewhere.pgm", 4, 2, 1, {0, 0, 0, 255, 0, 0, 0, 255});
    scene.segments[0].edit->drives[0].mask = core::loadMask(folder / "elsewhere.pgm");
    const core::Notes notes = core::maskNotes(scene);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].english().find("elsewhere.pgm"), std::string::npos);
    scene.segments[1].edit = scene.segments[0].edit;
    scene.segments[0].edit.reset();
    EXPECT_EQ(core::maskNotes(scene).size(), 1u) << "it is 1 in all of the other segment";
}

TEST(Drives, ConstantMaskIsTheConstantParameter) {
    for (const float value : {0.0f, 1.0f}) {
        test::AnalyticScene driven = ball(32);
        driven.scene.render.bounces = 3;
        core::Material& m = driven.edit(1, "ggx");
        m.values[0] = 0.9f;
        m.drives = {maskDrive("alpha", makeMask(32, 32, [&](int, int) { return value; }), 0.1f, 0.4f),
                    maskDrive("blend.original", makeMask(32, 32, [&](int, int) { return value; }), 0.5f, 0.2f)};
        test::AnalyticScene constant = ball(32);
        constant.scene.render.bounces = 3;
        constant.edit(1, "ggx").values[0] = value == 0 ? 0.1f : 0.4f;
        constant.scene.findSegment(1)->edit->blendOriginal = value == 0 ? 0.5f : 0.2f;
        EXPECT_EQ(core::renderReference(driven.scene, driven.analysis),
                  core::renderReference(constant.scene, constant.analysis));
    }
}

TEST(Drives, EachPixelIsThatOfAConstantEdit) {
    // One bounce: a pixel knows nothing of its neighbours. Four bands of roughness, colour ends and inverted contrast.
    const auto band = [](int x) { return static_cast<float>(x / 8) / 3; };
    test::AnalyticScene driven = ball(32);
    core::Material& m = driven.edit(1, "artist");
    m.albedo = Vector3f(0.5f, 0.4f, 0.3f);
    const auto mask = makeMask(32, 32, [&](int x, int) { return band(x); });
    m.drives = {maskDrive("roughness", mask, 0.2f, 0.8f), maskDrive("albedo", mask, 0, 0)};
    m.drives[1].from = DriveEnd{.value = Vector3f(0.5f, 0.5f, 0.5f), .factor = true};
    m.drives[1].to = DriveEnd{.value = Vector3f(0.1f, 0.8f, 0.6f), .factor = false};
    m.drives[1].invert = true;
    m.drives[1].strength = 2;
    const core::ImageRgb actual = core::renderReference(driven.scene, driven.analysis);
    const core::ImageRgb map =
        core::effectiveParameter(driven.scene, *driven.analysis, driven.scene.segments[0], "albedo");
    for (int i = 0; i < 4; ++i) {
        const float t = std::clamp(0.5f - 2 * (band(8 * i) - 0.5f), 0.0f, 1.0f);
        test::AnalyticScene constant = ball(32);
        core::Material& c = constant.edit(1, "artist");
        c.values[1] = 0.2f + 0.6f * band(8 * i);
        c.albedo = Vector3f(0.25f, 0.2f, 0.15f) * (1 - t) + Vector3f(0.1f, 0.8f, 0.6f) * t;
        const core::ImageRgb expected = core::renderReference(constant.scene, constant.analysis);
        int compared = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 8 * i; x < 8 * i + 8; ++x) {
                if (driven.scene.photo->labels(x, y) != 1) continue;
                EXPECT_LE((actual(x, y) - expected(x, y)).norm(), 2e-4f * expected(x, y).norm()) << x << ' ' << y;
                EXPECT_LE((map(x, y) - c.albedo).norm(), 1e-4f);
                ++compared;
            }
        EXPECT_GT(compared, 10) << i;
    }
}

TEST(Drives, LaterBouncesSeeTheHitPixelsParameters) {
    // A mirror wall behind the camera's left ball would see it: here a glossy slab below shows the ball above it.
    const auto scene = [](float left, float right, bool driven) {
        const auto hit = [](const Vector3f& ray) {
            test::AnalyticHit h = test::sphere(0.25f, 1.0f, Vector3f(0.1f, 0.1f, 0.1f))(ray);
            if (h.front > 0 || ray.y() <= 0.1f) return h;
            h.front = 0.25f / ray.y();
            h.back = 0.3f / ray.y();
            h.frontNormal = Vector3f(0, -1, 0);
            h.backNormal = Vector3f(0, 1, 0);
            h.label = 2;
            return h;
        };
        test::AnalyticScene s(test::squareCamera(48, 48), hit);
        s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
        s.scene.render.bounces = 3;
        s.scene.render.samples = 1;
        s.edit(2, "ggx").values[0] = 0.05f;
        core::Material& m = s.edit(1, "lambert");
        m.albedo = Vector3f::Constant(left);
        if (driven)
            m.drives = {
                maskDrive("albedo", makeMask(48, 48, [](int x, int) { return x < 24 ? 0.0f : 1.0f; }), left, right)};
        return core::renderReference(s.scene, s.analysis);
    };
    const core::ImageRgb dark = scene(0.2f, 0, false);
    const core::ImageRgb bright = scene(0.8f, 0, false);
    const core::ImageRgb both = scene(0.2f, 0.8f, true);
    int asDark = 0;
    int asBright = 0;
    for (int y = 36; y < 48; ++y)
        for (int x = 0; x < 48; ++x) {
            if ((dark(x, y) - bright(x, y)).norm() < 0.01f) continue;
            const bool isDark = (both(x, y) - dark(x, y)).norm() < 1e-4f;
            const bool isBright = (both(x, y) - bright(x, y)).norm() < 1e-4f;
            EXPECT_TRUE(isDark || isBright) << x << ' ' << y;
            asDark += isDark;
            asBright += isBright;
        }
    EXPECT_GT(asDark, 20);
    EXPECT_GT(asBright, 20);
}

TEST(TextureDetail, FlatColourHasNoneAndShadingIsNotTexture) {
    test::AnalyticScene s = ball(96);
    s.edit(1, "lambert").drives = {luminanceDrive("albedo")};
    s.analysis->textureDetail = textureDetail(s);
    const core::ImageRgb flat = core::effectiveParameter(s.scene, *s.analysis, s.scene.segments[0], "albedo");
    for (std::size_t i = 0; i < flat.size(); ++i) {
        if (s.scene.photo->labels[i] == 1) {
            ASSERT_LE((flat[i] - Vector3f(1, 1, 1)).norm(), 1e-5f);
        }
    }

    // Shading by the direction of the surface, and a fine check of ±30 % on it.
    auto photo = std::make_shared<core::Photo>(*s.scene.photo);
    const auto check = [](int x, int y) { return (x / 2 + y / 2) % 2 == 0 ? 1.3f : 0.7f; };
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const float shading = 0.5f - 0.4f * s.analysis->front->normal(x, y).y();
            photo->color(x, y) = Vector3f::Constant(shading * check(x, y));
        }
    s.scene.photo = photo;
    const auto detail = textureDetail(s);
    double error = 0;
    double mean = 0;
    double count = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            if (photo->labels(x, y) != 1) continue;
            mean += static_cast<double>((*detail)(x, y));
            error += std::abs(static_cast<double>((*detail)(x, y) - check(x, y)));
            ++count;
        }
    EXPECT_NEAR(mean / count, 1, 1e-5);
    EXPECT_LE(error / count, 0.06);
    s.scene.findSegment(1)->edit->drives.clear();
    EXPECT_EQ(textureDetail(s), nullptr);
}

TEST(TextureDetail, KeepsTheMeanUnlessTheLimitTakesTooMuch) {
    test::AnalyticScene s = ball(64);
    auto photo = std::make_shared<core::Photo>(*s.scene.photo);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            photo->color(x, y) *= 1 + 0.5f * std::sin(static_cast<float>(3 * x)) * std::cos(static_cast<float>(2 * y));
    s.scene.photo = photo;
    core::Material& m = s.edit(1, "lambert");
    m.albedo = Vector3f(0.75f, 0.5f, 0.1f);
    for (const float strength : {0.5f, 1.0f, 2.0f}) {
        m.drives = {luminanceDrive("albedo", strength)};
        s.analysis->textureDetail = textureDetail(s);
        const core::ImageRgb map = core::effectiveParameter(s.scene, *s.analysis, s.scene.segments[0], "albedo");
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(meanInside(map, photo->labels, c) / static_cast<double>(m.albedo[c]), 1, 2e-3) << strength;
        float greatest = 0;
        for (const Vector3f& v : map.pixels()) greatest = std::max(greatest, v.maxCoeff());
        EXPECT_LE(greatest, 1.0001f);
        EXPECT_GE(greatest, 0.8f);
    }
    // As a mask: the mean is in the middle.
    m.drives = {luminanceDrive("albedo")};
    m.drives[0].from = DriveEnd{.value = Vector3f(0.2f, 0.2f, 0.2f), .factor = false};
    m.drives[0].to = DriveEnd{.value = Vector3f(0.4f, 0.4f, 0.4f), .factor = false};
    const core::ImageRgb map = core::effectiveParameter(s.scene, *s.analysis, s.scene.segments[0], "albedo");
    EXPECT_NEAR(meanInside(map, photo->labels, 0), 0.3, 5e-3);
}

TEST(TextureDetail, IsComputedWhenADriveAsksForIt) {
    test::AnalyticScene s = ball(48);
    s.edit(1, "lambert");
    core::Scene driven = s.scene;
    driven.findSegment(1)->edit->drives = {luminanceDrive("albedo")};
    EXPECT_EQ(core::firstChangedStage(s.scene, driven), core::Stage::Environment);
    core::AnalysisPipeline pipeline;
    EXPECT_EQ(pipeline.run(s.scene)->textureDetail, nullptr);
    const auto analysis = pipeline.run(driven);
    ASSERT_NE(analysis->textureDetail, nullptr);
    EXPECT_EQ(pipeline.runCounts().at(core::Task::SeparateTexture), 2);
    EXPECT_EQ(pipeline.runCounts().at(core::Task::RecoverEnvironment), 1);
    driven.findSegment(1)->edit->drives[0].strength = 0.5f;
    EXPECT_EQ(pipeline.run(driven)->textureDetail, analysis->textureDetail);
}

TEST(EffectiveParameter, SaysWhatThereIs) {
    test::AnalyticScene s = ball(16);
    test::expectError(ErrorKind::Usage, {"segment 1", "not edited"},
                      [&] { (void)core::effectiveParameter(s.scene, *s.analysis, s.scene.segments[0], "alpha"); });
    s.edit(1, "lambert");
    test::expectError(ErrorKind::Usage, {"segment 1", "alpha", "albedo, blend.new, blend.original"},
                      [&] { (void)core::effectiveParameter(s.scene, *s.analysis, s.scene.segments[0], "alpha"); });
}
