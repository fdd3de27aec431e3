// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>

#include "core/material/brdf_file.h"
#include "core/shading/environment_sampler.h"
#include "core/shading/reference_renderer.h"
#include "gpu/readback.h"
#include "render/scene_geometry.h"
#include "tests/gpu/render_support.h"
#include "tests/support/merl_file.h"
#include "tests/support/temp_folder.h"

namespace {

using core::Vector3f;
using test::AnalyticScene;
using test::device;
using test::material;
using test::stillLife;

core::Material ggx(float alpha) {
    core::Material m = material("ggx");
    m.values[0] = alpha;
    m.specular = Vector3f(0.9f, 0.7f, 0.5f);
    return m;
}

core::Material marble() {
    core::Material m = material("none");
    m.translucency = core::Translucency();
    m.translucency->sigmaA = Vector3f(0.02f, 0.04f, 0.07f);
    m.translucency->sigmaSPrime = Vector3f(0.3f, 0.35f, 0.4f);
    return m;
}

core::Scene edited(const AnalyticScene& source, std::uint16_t label, const core::Material& m, int samples) {
    core::Scene scene = source.scene;
    scene.findSegment(label)->edit = m;
    scene.render.samples = samples;
    scene.render.filter = false;
    return scene;
}

struct Comparison {
    double nearlyEqual = 0;     ///< share of the segment's pixels that agree within 0.2 % + 1e-3
    double meanDifference = 0;  ///< of the means over the segment, relative
    std::size_t pixels = 0;
};

Comparison compare(const core::ImageRgb& actual, const core::ImageRgb& expected, const core::LabelImage& labels,
                   std::uint16_t label) {
    Comparison result;
    double sumActual = 0;
    double sumExpected = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != label) continue;
        ++result.pixels;
        result.nearlyEqual +=
            (actual[i] - expected[i]).cwiseAbs().maxCoeff() <= 0.002f * expected[i].cwiseAbs().maxCoeff() + 1e-3f;
        sumActual += static_cast<double>(actual[i].sum());
        sumExpected += static_cast<double>(expected[i].sum());
    }
    result.nearlyEqual /= static_cast<double>(result.pixels);
    result.meanDifference = std::abs(sumActual - sumExpected) / sumExpected;
    return result;
}

/// Records and submits until there is nothing left; returns how many submissions were no mere waiting.
int finish(render::Renderer& renderer, double budgetSeconds) {
    int slices = 0;
    for (int i = 1; i < 100000; ++i) {
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "test"});
        const bool worked = renderer.record(encoder, budgetSeconds);
        device().queue().submit(encoder.finish());
        device().waitIdle();
        if (!renderer.progress().waiting) ++slices;
        if (!worked) return slices;
    }
    ADD_FAILURE() << "the renderer does not come to an end";
    return 0;
}

std::vector<float> pixels(const render::Renderer& renderer) {
    return gpu::readTexture<float>(device(), renderer.result());
}

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
        // Paths part where a rounding decides between two pixels; the rest draws the same numbers.
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
        // Every pixel of a translucent body sums all its samples, also the few whose rays part at an edge of the
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
        // The sum over the translucent body's samples has an error of its own (Translucency.MatchesBruteForceInDouble).
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
    AnalyticScene black = test::spheresOnFloor(100, 80, {{Vector3f(0, 0, 1), 0.3f, 2, Vector3f::Zero()}}, 0, white);
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

/// Slices until the renderer has nothing to do; false when it still works after `seconds`.
bool endsWithin(render::Renderer& renderer, double seconds) {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::duration<double>(seconds)) {
        gpu::CommandEncoder encoder = device().createCommandEncoder({});
        const bool worked = renderer.record(encoder, 0.02);
        device().queue().submit(encoder.finish());
        device().waitIdle();
        if (!worked) return true;
    }
    return false;
}

TEST(Renderer, ATimeLimitEndsRefinementButNotTheFirstPicture) {
    const AnalyticScene source = stillLife();
    core::Scene scene = edited(source, 2, ggx(0.3f), 1'000'000);
    scene.render.filter = true;
    scene.render.timeLimit = 1;
    render::Renderer renderer(device());
    renderer.setScene(scene, source.analysis);
    ASSERT_TRUE(endsWithin(renderer, 60));
    const render::Renderer::Progress limited = renderer.progress();
    EXPECT_TRUE(limited.finished);
    EXPECT_TRUE(limited.timeUp);
    EXPECT_GT(limited.samples, 1);
    EXPECT_LT(limited.samples, 1'000'000);

    // Another edit has its own time; one too short for a sample has a picture all the same.
    scene.findSegment(2)->edit->values[0] = 0.5f;
    scene.render.timeLimit = 1e-9;
    renderer.setScene(scene, source.analysis);
    EXPECT_FALSE(renderer.progress().finished);
    ASSERT_TRUE(endsWithin(renderer, 60));
    EXPECT_EQ(renderer.progress().samples, 1);

    scene.render.samples = 3;
    scene.render.timeLimit = 3600;
    renderer.setScene(scene, source.analysis);
    ASSERT_TRUE(endsWithin(renderer, 60));
    EXPECT_EQ(renderer.progress().samples, 3);
    EXPECT_FALSE(renderer.progress().timeUp) << "the samples ended it";
}

TEST(Renderer, PausedItShowsTheFirstPictureAndGoesOnWhereItWas) {
    const AnalyticScene source = stillLife();
    core::Scene scene = edited(source, 2, ggx(0.3f), 40);
    render::Renderer renderer(device());
    renderer.setScene(scene, source.analysis);
    renderer.setRefining(false);
    ASSERT_TRUE(endsWithin(renderer, 60));
    const int first = renderer.progress().samples;
    EXPECT_GE(first, 1);
    EXPECT_LT(first, 40);
    EXPECT_FALSE(renderer.progress().finished);
    ASSERT_TRUE(endsWithin(renderer, 60));
    EXPECT_EQ(renderer.progress().samples, first) << "the device rests";
    renderer.setRefining(true);
    ASSERT_TRUE(endsWithin(renderer, 60));
    EXPECT_EQ(renderer.progress().samples, 40);
    EXPECT_TRUE(renderer.progress().finished);
    EXPECT_FALSE(renderer.progress().timeUp);
    const core::ImageRgb paused = render::readResult(device(), renderer);
    const core::ImageRgb atOnce = render::renderImage(device(), scene, source.analysis);
    EXPECT_EQ(std::memcmp(paused.pixels().data(), atOnce.pixels().data(), paused.size() * sizeof(core::Vector3f)), 0);
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

TEST(Translucency, MatchesBruteForceInDouble) {
    const AnalyticScene source = stillLife();
    for (const float eta : {1.0f, 1.3f}) {
        core::Material m = marble();
        m.translucency->eta = eta;
        m.translucency->weight = 0.8f;
        core::Scene scene = edited(source, 2, m, 1);
        scene.render.surfaceSamples = 700;
        scene.render.irradianceSamples = 16;
        const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
        const core::ImageRgb expected = core::renderReference(scene, source.analysis);
        EXPECT_LE(compare(actual, expected, source.photo->labels, 2).meanDifference, 0.002) << eta;
        // The grids' own error, within what it promises.
        double squares = 0;
        double total = 0;
        double largest = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            if (source.photo->labels[i] != 2) continue;
            squares += static_cast<double>((actual[i] - expected[i]).squaredNorm());
            total += static_cast<double>(expected[i].squaredNorm());
            largest = std::max(
                largest, static_cast<double>((actual[i] - expected[i]).cwiseAbs().maxCoeff() / expected[i].maxCoeff()));
        }
        EXPECT_LE(std::sqrt(squares / total), 0.01) << eta;
        EXPECT_LE(largest, 0.03) << eta;
    }
}

TEST(Translucency, NeverBrighterThanAWhiteSurface) {
    // Spheres that are one body with gaps and necks, in white light among white things.
    const Vector3f one(1, 1, 1);
    const AnalyticScene source = test::spheresOnFloor(80, 60,
                                                      {{Vector3f(-0.12f, 0, 0.9f), 0.1f, 2, one},
                                                       {Vector3f(0.1f, 0, 0.9f), 0.1f, 2, one},
                                                       {Vector3f(-0.01f, 0.13f, 0.95f), 0.1f, 2, one},
                                                       {Vector3f(-0.01f, -0.1f, 0.85f), 0.03f, 2, one}},
                                                      0, [&](const Vector3f&) { return one; });
    core::Material lambert = material("lambert");
    lambert.albedo = one;
    const core::ImageRgb white = render::renderImage(device(), edited(source, 2, lambert, 4), source.analysis);
    for (const bool matched : {true, false}) {
        core::Material m = marble();
        m.translucency->sigmaA = Vector3f(0, 0, 0.002f);
        m.translucency->sigmaSPrime = Vector3f(0.4f, 0.05f, 0.05f);
        m.translucency->eta = matched ? 1.0f : 1.3f;
        m.translucency->model = matched ? core::ScatteringModel::Dipole : core::ScatteringModel::BetterDipole;
        core::Scene scene = edited(source, 2, m, 1);
        scene.render.surfaceSamples = 1500;
        scene.render.irradianceSamples = 8;
        const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
        float largest = 0;
        for (std::size_t i = 0; i < actual.size(); ++i)
            if (source.photo->labels[i] == 2) largest = std::max(largest, actual[i].cwiseQuotient(white[i]).maxCoeff());
        EXPECT_LE(largest, 1 + 1e-4f) << m.translucency->eta;
        if (matched) {
            EXPECT_GE(largest, 1 - 1e-4f) << "as bright as white";
        }
    }
}

TEST(Renderer, SameBytesOnAnySchedule) {
    AnalyticScene source = stillLife();
    source.environment->radiance(20, 12) = Vector3f(900, 800, 500);  // sampled by itself
    core::Scene scene = edited(source, 2, ggx(0.2f), 6);
    scene.findSegment(3)->edit = marble();
    scene.render.filter = true;
    scene.render.surfaceSamples = 600;
    scene.render.irradianceSamples = 8;
    std::vector<std::vector<float>> pictures;
    std::vector<int> submissions;
    for (const double budget : {0.0, 0.004, 0.5}) {
        render::Renderer renderer(device());
        renderer.setScene(scene, source.analysis);
        submissions.push_back(finish(renderer, budget));
        const render::Renderer::Progress progress = renderer.progress();
        EXPECT_TRUE(progress.finished);
        EXPECT_EQ(progress.samples, 6);
        EXPECT_EQ(progress.fraction, 1.0f);
        EXPECT_EQ(progress.droppedSamples, 0u);
        pictures.push_back(pixels(renderer));
    }
    EXPECT_GT(submissions[0], submissions[2]) << "the budgets must have made a difference";
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        ASSERT_EQ(pictures[i].size(), pictures[0].size());
        EXPECT_EQ(std::memcmp(pictures[i].data(), pictures[0].data(), pictures[0].size() * sizeof(float)), 0) << i;
    }
}

TEST(Renderer, RestartsOnlyWhatAnEditInvalidates) {
    const AnalyticScene source = stillLife();
    core::Scene scene = edited(source, 2, ggx(0.2f), 4);
    scene.findSegment(3)->edit = marble();
    scene.render.bounces = 1;
    scene.render.surfaceSamples = 300;
    scene.render.irradianceSamples = 4;
    const auto analysis = source.analysis;
    render::Renderer renderer(device());
    renderer.setScene(scene, analysis);
    finish(renderer, 0.1);
    const auto state = [&](std::size_t i) { return renderer.progress().segments[i]; };
    ASSERT_EQ(renderer.progress().segments.size(), 2u);
    ASSERT_EQ(state(0).samples, 4);
    ASSERT_EQ(state(1).gatheredSamples, 300);

    // Weights: nothing restarts, the picture changes.
    const auto before = pixels(renderer);
    scene.findSegment(2)->edit->blendNew = 0.5f;
    scene.findSegment(2)->edit->blendOriginal = 0.5f;
    scene.findSegment(3)->edit->translucency->weight = 0.5f;
    renderer.setScene(scene, analysis);
    EXPECT_EQ(state(0).samples, 4);
    EXPECT_EQ(state(1).samples, 4);
    EXPECT_EQ(state(1).gatheredSamples, 300);
    finish(renderer, 0.1);
    EXPECT_NE(pixels(renderer), before);

    // Roughness of one segment: that one restarts.
    scene.findSegment(2)->edit->values[0] = 0.4f;
    renderer.setScene(scene, analysis);
    EXPECT_EQ(state(0).samples, 0);
    EXPECT_EQ(state(1).samples, 4);
    EXPECT_EQ(state(1).gatheredSamples, 300);
    finish(renderer, 0.1);

    // Scattering: the light on the surface stays, what is gathered from it restarts.
    scene.findSegment(3)->edit->translucency->sigmaA *= 2;
    renderer.setScene(scene, analysis);
    EXPECT_EQ(state(1).samples, 4);
    EXPECT_EQ(state(1).irradianceSamples, 300);
    EXPECT_EQ(state(1).gatheredSamples, 0);
    finish(renderer, 0.1);

    // What is on show after all edits is what a new renderer makes of the last scene.
    render::Renderer fresh(device());
    fresh.setScene(scene, analysis);
    finish(fresh, 0.1);
    EXPECT_EQ(pixels(renderer), pixels(fresh));

    // With several bounces the segments see each other: both restart.
    scene.render.bounces = 3;
    renderer.setScene(scene, analysis);
    finish(renderer, 0.1);
    scene.findSegment(2)->edit->values[0] = 0.1f;
    renderer.setScene(scene, analysis);
    EXPECT_EQ(state(0).samples, 0);
    EXPECT_EQ(state(1).samples, 0);
    finish(renderer, 0.1);
    render::Renderer freshAgain(device());
    freshAgain.setScene(scene, analysis);
    finish(freshAgain, 0.1);
    EXPECT_EQ(pixels(renderer), pixels(freshAgain));

    // An edit taken back shows the photograph again.
    scene.findSegment(2)->edit.reset();
    renderer.setScene(scene, analysis);
    finish(renderer, 0.1);
    const auto after = pixels(renderer);
    for (std::size_t i = 0; i < source.photo->labels.size(); ++i) {
        if (source.photo->labels[i] == 2) {
            ASSERT_EQ(after[4 * i], source.photo->color[i].x()) << i;
        }
    }
}

TEST(Renderer, ShowsAPictureWithTheFirstSlice) {
    const AnalyticScene source = stillLife();
    render::Renderer renderer(device());
    gpu::CommandEncoder idle = device().createCommandEncoder({.label = "idle"});
    EXPECT_FALSE(renderer.record(idle, 0.03)) << "without a scene there is nothing to do";
    device().queue().submit(idle.finish());

    renderer.setScene(edited(source, 2, ggx(0.2f), 64), source.analysis);
    EXPECT_FALSE(renderer.result());
    do {
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "first"});
        ASSERT_TRUE(renderer.record(encoder, 0.03));
        device().queue().submit(encoder.finish());
        device().waitIdle();
    } while (renderer.progress().waiting);
    const auto picture = pixels(renderer);
    ASSERT_EQ(picture.size(), source.photo->color.size() * 4);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < source.photo->color.size(); ++i) {
        ASSERT_TRUE(std::isfinite(picture[4 * i]));
        changed += picture[4 * i] != source.photo->color[i].x();
    }
    EXPECT_GT(changed, 0u);
    EXPECT_FALSE(renderer.progress().finished);
    EXPECT_GT(renderer.progress().fraction, 0.0f);
}

TEST(Renderer, EveryPixelFollowsAChangeThatRestartsEverySlice) {
    const AnalyticScene source = stillLife();
    core::Material paint = test::material("lambert");
    paint.albedo = Vector3f(0.9f, 0.05f, 0.05f);
    core::Scene scene = edited(source, 2, paint, 1);
    scene.render.bounces = 1;
    scene.render.filter = false;
    const auto analysis = source.analysis;
    render::Renderer renderer(device());
    renderer.setScene(scene, analysis);
    finish(renderer, 0.1);
    const auto red = pixels(renderer);
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < source.photo->labels.size(); ++i)
        if (source.photo->labels[i] == 2 && red[4 * i] > 0) own.push_back(i);
    const auto changed = [&] {
        const auto now = pixels(renderer);
        return std::ranges::count_if(own, [&](std::size_t i) { return now[4 * i + 1] > now[4 * i]; });
    };

    constexpr int kLeastSlice = 64;  // pixels
    const auto slices = static_cast<int>(own.size()) / kLeastSlice + 2;
    ASSERT_GT(slices, 8);
    for (int i = 0; i < slices; ++i) {
        scene.findSegment(2)->edit->albedo = Vector3f(0.05f, 0.9f - 0.001f * static_cast<float>(i), 0.05f);
        renderer.setScene(scene, analysis);
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "slice"});
        ASSERT_TRUE(renderer.record(encoder, 1e-9));
        device().queue().submit(encoder.finish());
        device().waitIdle();
        if (i > 0) continue;
        EXPECT_GT(changed(), 0);
        EXPECT_LE(changed(), 2 * kLeastSlice) << "a slice changes what it advanced, the rest stays as it was";
    }
    EXPECT_EQ(changed(), static_cast<std::ptrdiff_t>(own.size()));
}

TEST(Renderer, FollowsANewPhotographOfAnotherSize) {
    const AnalyticScene first = stillLife();
    const AnalyticScene second = test::spheresOnFloor(70, 110, {{Vector3f(0, 0, 1), 0.2f, 2}}, 0,
                                                      [](const Vector3f&) { return Vector3f(1, 1, 1); });
    render::Renderer renderer(device());
    renderer.setScene(edited(first, 2, ggx(0.2f), 2), first.analysis);
    finish(renderer, 0.1);
    core::Scene scene = edited(second, 2, marble(), 2);
    scene.render.surfaceSamples = 300;
    scene.render.irradianceSamples = 4;
    renderer.setScene(scene, second.analysis);
    finish(renderer, 0.1);
    EXPECT_EQ(renderer.result().width(), 70u);
    EXPECT_EQ(renderer.result().height(), 110u);
    render::Renderer fresh(device());
    fresh.setScene(scene, second.analysis);
    finish(fresh, 0.1);
    EXPECT_EQ(pixels(renderer), pixels(fresh));
}

TEST(Renderer, NothingEditedIsThePhotograph) {
    const AnalyticScene source = stillLife();
    const core::ImageRgb image = render::renderImage(device(), source.scene, source.analysis);
    EXPECT_EQ(image, source.photo->color);
}

TEST(Renderer, SaysWhenThePictureIsTooLarge) {
    const render::SceneGeometry geometry(device());
    EXPECT_NO_THROW(geometry.requireFits(1024, 768));
    const std::uint32_t side = device().limits().maxTextureDimension2D + 1;
    try {
        geometry.requireFits(side, 10);
        FAIL() << "a picture wider than the device's textures must be refused";
    } catch (const gpu::Error& error) {
        EXPECT_EQ(error.kind(), gpu::ErrorKind::OutOfMemory);
        EXPECT_NE(std::string(error.what()).find(std::to_string(side) + "x10"), std::string::npos) << error.what();
    }
}

TEST(Renderer, AdvancesWhereTheCompositeIsDearerThanTheBudget) {
    constexpr int kSlices = 10;
    constexpr double kBudget = 0.01;
    const AnalyticScene source = test::spheresOnFloor(640, 640, {{Vector3f(0, 0, 1), 0.4f, 2}}, 0,
                                                      [](const Vector3f&) { return Vector3f(1, 1, 1); });
    const auto count = std::count(source.photo->labels.pixels().begin(), source.photo->labels.pixels().end(), 2);
    core::Scene scene = edited(source, 2, ggx(0.2f), 2);
    scene.render.bounces = 1;  // with more, weights are part of what paths meet
    const auto analysis = source.analysis;
    render::Renderer renderer(device());
    renderer.setScene(scene, analysis);
    finish(renderer, 0.1);
    scene.render.samples = 4;
    for (int i = 0; i < kSlices; ++i) {
        scene.findSegment(2)->edit->blendNew = i % 2 == 0 ? 0.5f : 1.0f;  // what is on show is old
        renderer.setScene(scene, analysis);
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "slice"});
        ASSERT_TRUE(renderer.record(encoder, kBudget));
        device().queue().submit(encoder.finish());
        device().waitIdle();
    }
    const double paths = (4 * static_cast<double>(renderer.progress().fraction) - 2) * static_cast<double>(count);
    EXPECT_GT(paths, 2 * 64 * kSlices) << "no more than the least that is ever dispatched";
}

TEST(Renderer, CanBeCancelled) {
    const AnalyticScene source = stillLife();
    const core::Scene scene = edited(source, 2, ggx(0.2f), 100000);
    const std::atomic<bool> cancel = true;
    EXPECT_THROW((void)render::renderImage(device(), scene, source.analysis, core::Progress({}, &cancel)), core::Error);
}

}  // namespace
