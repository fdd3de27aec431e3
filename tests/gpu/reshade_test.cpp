// SPDX-License-Identifier: GPL-3.0-or-later
// Re-shading, silhouette and filter against the reference renderer.
#include <gtest/gtest.h>

#include <cstring>

#include "core/material/brdf_file.h"
#include "core/shading/environment_sampler.h"
#include "core/shading/reference_renderer.h"
#include "render/renderer.h"
#include "tests/gpu/render_support.h"
#include "tests/support/merl_file.h"
#include "tests/support/temp_folder.h"

namespace {

using core::Vector3f;
using test::AnalyticScene;
using test::compare;
using test::Comparison;
using test::device;
using test::edited;
using test::ggx;
using test::marble;
using test::material;
using test::stillLife;

TEST(Reshade, FollowsTheReferenceRendererPathByPath) {
    const AnalyticScene source = stillLife();
    for (const core::BrdfInfo& info : core::brdfs()) {
        const char* brdf = info.key;
        if (std::string_view(brdf) == "none") continue;
        core::Material m = material(brdf);
        m.specular = Vector3f(0.9f, 0.8f, 0.6f);
        const core::Scene scene = edited(source, 2, m, 4);
        const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
        const core::ImageRgb expected = core::renderReference(scene, source.analysis);
        const Comparison c = compare(actual, expected, source.photo->labels, 2);
        ASSERT_GT(c.pixels, 500u);
        // Paths diverge where rounding decides between two pixels; all others draw the same numbers.
        EXPECT_GE(c.nearlyEqual, 0.98) << brdf;
        EXPECT_LE(c.meanDifference, 0.003) << brdf;
    }
}

TEST(Reshade, FollowsTheReferenceRendererWithMeasuredBrdfs) {
    const test::TempFolder folder;
    test::writeMerl(folder / "glossy.binary",
                    [](double h, double d, double p) { return test::ggxInHalfDiff(0.2, h, d, p); });
    test::writeMerl(folder / "matt.binary", [](double, double, double) { return Vector3f(0.2f, 0.1f, 0.05f); });
    const AnalyticScene source = stillLife();
    core::Scene scene = edited(source, 2, core::fileMaterial(core::loadBrdfFile(folder / "glossy.binary")), 4);
    scene.findSegment(3)->edit = core::fileMaterial(core::loadBrdfFile(folder / "matt.binary"));
    const core::ImageRgb expected = core::renderReference(scene, source.analysis);
    const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
    for (const auto label : {std::uint16_t{2}, std::uint16_t{3}}) {
        const Comparison c = compare(actual, expected, source.photo->labels, label);
        ASSERT_GT(c.pixels, 500u);
        EXPECT_GE(c.nearlyEqual, 0.97) << label;
        EXPECT_LE(c.meanDifference, 0.004) << label;
    }
}

TEST(Reshade, FollowsTheReferenceRendererInSunlight) {
    AnalyticScene source = stillLife();
    source.environment->radiance(20, 12) = Vector3f(900, 800, 500);
    source.environment->radiance(21, 12) = Vector3f(900, 800, 500);
    ASSERT_FALSE(core::EnvironmentSampler(*source.environment).empty());
    core::Scene scene = edited(source, 2, ggx(0.4f), 8);
    scene.findSegment(3)->edit = material("lambert");
    scene.findSegment(1)->edit = marble();
    scene.render.surfaceSamples = 300;
    scene.render.irradianceSamples = 8;
    const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
    const core::ImageRgb expected = core::renderReference(scene, source.analysis);
    for (const auto label : {std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3}}) {
        const Comparison c = compare(actual, expected, source.photo->labels, label);
        // Every pixel of a translucent body sums all samples, including the few whose rays diverge at an edge of the
        // shadow.
        if (label != 1) {
            EXPECT_GE(c.nearlyEqual, 0.96) << label;
        }
        EXPECT_LE(c.meanDifference, 0.004) << label;
    }
}

TEST(Reshade, SeveralEditedSegmentsSeeEachOther) {
    const AnalyticScene source = stillLife();
    core::Scene scene = edited(source, 2, ggx(0.1f), 4);
    scene.findSegment(3)->edit = marble();
    scene.findSegment(3)->edit->brdf = "lambert";
    scene.findSegment(3)->edit->blendOriginal = 0.3f;
    scene.findSegment(1)->glossy = true;
    scene.render.surfaceSamples = 300;
    scene.render.irradianceSamples = 8;
    const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
    const core::ImageRgb expected = core::renderReference(scene, source.analysis);
    for (const auto label : {std::uint16_t{2}, std::uint16_t{3}}) {
        const Comparison c = compare(actual, expected, source.photo->labels, label);
        // The sum over the samples of the translucent body has an error of its own
        // (Translucency.MatchesBruteForceInDouble).
        if (label != 3) {
            EXPECT_GE(c.nearlyEqual, 0.97) << label;
        }
        EXPECT_LE(c.meanDifference, 0.004) << label;
    }
}

TEST(Reshade, WhiteFurnaceIsWhite) {
    const auto white = [](const Vector3f&) { return Vector3f(1, 1, 1); };
    const AnalyticScene source =
        test::spheresOnFloor(100, 80, {{Vector3f(0, 0, 1), 0.3f, 2, Vector3f(1, 1, 1)}}, 0, white);
    core::Material m = material("lambert");
    m.albedo = Vector3f(1, 1, 1);
    const core::Scene scene = edited(source, 2, m, 16);
    const core::ImageRgb image = render::renderImage(device(), scene, source.analysis);
    for (std::size_t i = 0; i < image.size(); ++i) ASSERT_NEAR((image[i] - Vector3f(1, 1, 1)).norm(), 0, 1e-4) << i;

    // A convex body does not see itself: with a black photograph a false hit would be a dark speck.
    AnalyticScene black =
        test::spheresOnFloor(100, 80, {{Vector3f(0, 0, 1), 0.3f, 2, Vector3f::Zero()}}, 0, white);
    core::Scene once = edited(black, 2, m, 16);
    once.render.bounces = 1;
    const core::ImageRgb seen = render::renderImage(device(), once, black.analysis);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (black.photo->labels[i] != 2) continue;
        sum += static_cast<double>(seen[i].x());
        ++count;
    }
    EXPECT_GE(sum / static_cast<double>(count), 0.995);
    EXPECT_LE(sum / static_cast<double>(count), 1.0001);
}

TEST(Reshade, UneditedPixelsAreThePhotograph) {
    const AnalyticScene source = stillLife();
    core::Scene scene = edited(source, 2, ggx(0.2f), 2);
    scene.render.filter = true;
    const core::ImageRgb image = render::renderImage(device(), scene, source.analysis);
    const core::LabelImage& labels = source.photo->labels;
    const auto atOutline = [&](int x, int y) {
        for (int v = y - 2; v <= y + 2; ++v)
            for (int u = x - 2; u <= x + 2; ++u)
                if (labels.contains(u, v) && labels(u, v) == 2) return true;
        return false;
    };
    std::size_t changed = 0;
    std::size_t changedAtOutline = 0;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) {
            const bool same = std::memcmp(image(x, y).data(), source.photo->color(x, y).data(), sizeof(float) * 3) == 0;
            if (labels(x, y) == 2)
                changed += !same;
            else if (atOutline(x, y))
                changedAtOutline += !same;
            else
                ASSERT_TRUE(same) << x << " " << y;
        }
    EXPECT_GT(changed, 500u);
    EXPECT_LE(changedAtOutline, 4u) << "no pixel of this scene is mixed";
}

TEST(Silhouette, IsTheTwinOfTheCpuVersion) {
    AnalyticScene source = stillLife();
    const core::ImageRgb sharp = source.photo->color;
    for (int y = 1; y + 1 < sharp.height(); ++y)
        for (int x = 1; x + 1 < sharp.width(); ++x) {
            Vector3f sum = Vector3f::Zero();
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) sum += sharp(x + i, y + j);
            source.photo->color(x, y) = sum / 9;
        }
    core::Scene scene = edited(source, 2, ggx(0.3f), 2);
    scene.findSegment(2)->edit->blendOriginal = 0.25f;
    const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
    const core::ImageRgb expected = core::renderReference(scene, source.analysis);
    std::size_t changedOutside = 0;
    std::size_t different = 0;
    for (std::size_t i = 0; i < actual.size(); ++i) {
        if (source.photo->labels[i] == 2) continue;
        changedOutside += actual[i] != source.photo->color[i];
        different += (actual[i] - expected[i]).cwiseAbs().maxCoeff() > 1e-3f + 0.002f * expected[i].maxCoeff();
    }
    EXPECT_GT(changedOutside, 50u);
    EXPECT_LE(different, changedOutside / 20);
    const Comparison c = compare(actual, expected, source.photo->labels, 2);
    EXPECT_GE(c.nearlyEqual, 0.97);
}

TEST(Filter, IsTheTwinOfTheCpuFilter) {
    const AnalyticScene source = stillLife();
    for (const int samples : {2, 8}) {
        core::Scene scene = edited(source, 2, ggx(0.3f), samples);
        scene.render.filter = true;
        const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
        const core::ImageRgb expected = core::renderReference(scene, source.analysis);
        const Comparison c = compare(actual, expected, source.photo->labels, 2);
        EXPECT_GE(c.nearlyEqual, 0.9) << samples;
        EXPECT_LE(c.meanDifference, 0.003) << samples;

        scene.render.filter = false;
        const core::ImageRgb raw = render::renderImage(device(), scene, source.analysis);
        EXPECT_LT(compare(raw, expected, source.photo->labels, 2).nearlyEqual, 0.5) << "the filter does something";
    }
}

}  // namespace
