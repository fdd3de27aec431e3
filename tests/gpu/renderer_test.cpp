// SPDX-License-Identifier: GPL-3.0-or-later
// Progress, restarts and schedules of the renderer.
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>

#include "core/base/clock.h"
#include "render/scene_geometry.h"
#include "tests/gpu/render_support.h"

namespace {

using core::Vector3f;
using test::AnalyticScene;
using test::device;
using test::edited;
using test::finish;
using test::ggx;
using test::marble;
using test::pixels;
using test::stillLife;

/// Records slices until there is nothing left to do; false if that takes longer than `seconds`.
bool endsWithin(render::Renderer& renderer, double seconds) {
    const auto start = core::Clock::now();
    while (core::secondsSince(start) < seconds) {
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

    // Another edit has its own time; a limit too short for one sample still gives a picture.
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

class RendererSchedule : public testing::TestWithParam<bool> {};

TEST_P(RendererSchedule, SameBytesOnAnySchedule) {
    AnalyticScene source = stillLife();
    source.environment->radiance(20, 12) = Vector3f(900, 800, 500);  // bright enough to be sampled
    core::Scene scene = edited(source, 2, ggx(0.2f), 6);
    scene.findSegment(3)->edit = marble();
    scene.render.filter = GetParam();
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

INSTANTIATE_TEST_SUITE_P(FilterOffAndOn, RendererSchedule, testing::Bool());

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

    // Weights: nothing restarts, but the picture changes.
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

    // Scattering: the light on the surface stays, the sum of it restarts.
    scene.findSegment(3)->edit->translucency->sigmaA *= 2;
    renderer.setScene(scene, analysis);
    EXPECT_EQ(state(1).samples, 4);
    EXPECT_EQ(state(1).irradianceSamples, 300);
    EXPECT_EQ(state(1).gatheredSamples, 0);
    finish(renderer, 0.1);

    // After all edits the picture equals that of a new renderer for the last scene.
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

    // Removing an edit shows the photograph again.
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

    constexpr int kMinSlice = 64;  // pixels
    const auto slices = static_cast<int>(own.size()) / kMinSlice + 2;
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
        EXPECT_LE(changed(), 2 * kMinSlice) << "a slice changes what it advanced, the rest stays as it was";
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

TEST(Renderer, AdvancesWhereTheCompositeExceedsTheBudget) {
    constexpr int kSlices = 10;
    constexpr int kRounds = 6;  // a slice held up by another program makes the next ones smaller, so one round may fail
    constexpr double kBudget = 0.01;
    constexpr double kMinPaths = 64;  // of a slice
    const AnalyticScene source = test::spheresOnFloor(640, 640, {{Vector3f(0, 0, 1), 0.4f, 2}}, 0,
                                                      [](const Vector3f&) { return Vector3f(1, 1, 1); });
    const auto count = std::count(source.photo->labels.pixels().begin(), source.photo->labels.pixels().end(), 2);
    core::Scene scene = edited(source, 2, ggx(0.2f), 2);
    scene.render.bounces = 1;  // with more, paths depend on the weights
    const auto analysis = source.analysis;
    render::Renderer renderer(device());
    renderer.setScene(scene, analysis);
    finish(renderer, 0.1);
    scene.render.samples = 40;
    const auto paths = [&] {
        return 40 * static_cast<double>(renderer.progress().fraction) * static_cast<double>(count);
    };
    double most = 0;
    for (int round = 0; round < kRounds && most <= 1.5 * kMinPaths * kSlices; ++round) {
        double before = 0;
        for (int i = 0; i <= kSlices; ++i) {
            scene.findSegment(2)->edit->blendNew = i % 2 == 0 ? 0.5f : 1.0f;  // makes the composite stale
            renderer.setScene(scene, analysis);
            gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "slice"});
            ASSERT_TRUE(renderer.record(encoder, kBudget));
            device().queue().submit(encoder.finish());
            device().waitIdle();
            if (i == 0) before = paths();
        }
        most = std::max(most, paths() - before);
    }
    EXPECT_GT(most, 1.5 * kMinPaths * kSlices) << "the smallest slices only";
}

TEST(Renderer, CanBeCancelled) {
    const AnalyticScene source = stillLife();
    const core::Scene scene = edited(source, 2, ggx(0.2f), 100000);
    const std::atomic<bool> cancel = true;
    EXPECT_THROW((void)render::renderImage(device(), scene, source.analysis, core::Progress({}, &cancel)), core::Error);
}

}  // namespace
