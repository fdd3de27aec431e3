// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/pipeline.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <mutex>

#include "core/scene/changes.h"
#include "tests/support/ray_scene.h"

namespace {

using core::AnalysisPipeline;
using core::Error;
using core::ErrorKind;
using core::Scene;
using core::Stage;
using core::Task;

struct PipelineTest : testing::Test {
    PipelineTest() {
        scene = test::stillLife(test::testCamera(80, 60)).scene();
        scene.environment.height = 16;
    }
    /// How often each step ran since the last call.
    AnalysisPipeline::RunCounts newRuns() {
        AnalysisPipeline::RunCounts difference;
        for (const auto& [name, count] : pipeline.runCounts())
            if (count != seen[name]) difference[name] = count - seen[name];
        seen = pipeline.runCounts();
        return difference;
    }
    Scene scene;
    AnalysisPipeline pipeline;
    AnalysisPipeline::RunCounts seen;
    using Runs = AnalysisPipeline::RunCounts;
};

TEST_F(PipelineTest, RunsEverythingOnceAndThenNothing) {
    const auto first = pipeline.run(scene);
    EXPECT_EQ(newRuns(), (Runs{{Task::RecoverDepth, 1},
                               {Task::ComputeNormals, 1},
                               {Task::InventBackSides, 1},
                               {Task::BuildDepthLayers, 1},
                               {Task::EstimateReflectance, 1},
                               {Task::RecoverEnvironment, 1},
                               {Task::SeparateTexture, 1}}));
    const auto second = pipeline.run(scene);
    EXPECT_TRUE(newRuns().empty());
    EXPECT_EQ(first->front, second->front);
    EXPECT_EQ(first->environment, second->environment);
    EXPECT_EQ(first->reflectances, second->reflectances);
}

TEST_F(PipelineTest, EqualContentInAnotherImageIsNoChange) {
    (void)pipeline.run(scene);
    newRuns();
    scene.photo = std::make_shared<core::Photo>(*scene.photo);
    (void)pipeline.run(scene);
    EXPECT_TRUE(newRuns().empty());
    auto changed = std::make_shared<core::Photo>(*scene.photo);
    changed->color(3, 3).x() += 0.1f;
    scene.photo = changed;
    (void)pipeline.run(scene);
    EXPECT_EQ(newRuns().size(), 7u);
}

TEST_F(PipelineTest, RecomputesOnlyWhatAnEditInvalidates) {
    const auto before = pipeline.run(scene);
    newRuns();

    scene.findSegment(2)->reflectance = core::Vector3f(0.5f, 0.5f, 0.5f);
    const auto recolored = pipeline.run(scene);
    EXPECT_EQ(newRuns(), (Runs{{Task::EstimateReflectance, 1}, {Task::RecoverEnvironment, 1}}));
    EXPECT_EQ(recolored->layers, before->layers);
    EXPECT_NE(recolored->environment, before->environment);

    scene.findSegment(3)->backSide.minThickness = 0.01f;
    (void)pipeline.run(scene);
    EXPECT_EQ(newRuns(), (Runs{{Task::InventBackSides, 1},
                               {Task::BuildDepthLayers, 1},
                               {Task::EstimateReflectance, 1},
                               {Task::RecoverEnvironment, 1}}));

    scene.environment.image = std::make_shared<core::ImageRgb>(8, 4, core::Vector3f(1, 2, 3));
    const auto lit = pipeline.run(scene);
    EXPECT_EQ(newRuns(), (Runs{{Task::RecoverEnvironment, 1}}));
    EXPECT_TRUE(lit->environment->mean().isApprox(core::Vector3f(1, 2, 3), 1e-4f));
    scene.environment.scale = 2;
    (void)pipeline.run(scene);
    EXPECT_EQ(newRuns(), (Runs{{Task::RecoverEnvironment, 1}}));

    core::Material material;
    scene.findSegment(2)->edit = material;
    scene.render.samples = 7;
    scene.findSegment(2)->name = "ball";
    (void)pipeline.run(scene);
    EXPECT_TRUE(newRuns().empty());

    auto back = std::make_shared<core::ImageF>(80, 60, 3.0f);
    scene.backDepth = back;
    const auto given = pipeline.run(scene);
    EXPECT_EQ(newRuns(), (Runs{{Task::InventBackSides, 1},
                               {Task::BuildDepthLayers, 1},
                               {Task::EstimateReflectance, 1},
                               {Task::RecoverEnvironment, 1}}));
    EXPECT_NEAR(given->back->depth(40, 40), 3, 1e-5f);
}

TEST_F(PipelineTest, CancellingKeepsWhatWasFinished) {
    (void)pipeline.run(scene);
    newRuns();
    const Scene old = scene;
    scene.depthFilter.spatialSigma = 5;

    std::atomic<bool> stop{false};
    const core::Progress progress(
        [&](Task task, float) {
            if (task == Task::EstimateReflectance) stop = true;
        },
        &stop);
    try {
        (void)pipeline.run(scene, progress);
        FAIL() << "the run was not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Cancelled);
    }
    EXPECT_EQ(newRuns(), (Runs{{Task::RecoverDepth, 1},
                               {Task::ComputeNormals, 1},
                               {Task::InventBackSides, 1},
                               {Task::BuildDepthLayers, 1}}));
    const auto resumed = pipeline.run(scene);
    EXPECT_EQ(newRuns(),
              (Runs{{Task::EstimateReflectance, 1}, {Task::RecoverEnvironment, 1}, {Task::SeparateTexture, 1}}));

    AnalysisPipeline fresh;
    const auto expected = fresh.run(scene);
    EXPECT_EQ(resumed->front->depth, expected->front->depth);
    EXPECT_EQ(resumed->reflectances[0]->rho, expected->reflectances[0]->rho);
    EXPECT_EQ(resumed->environment->radiance, expected->environment->radiance);
}

TEST_F(PipelineTest, ACancelledRunNeverStarts) {
    const std::atomic<bool> stop{true};
    EXPECT_THROW((void)pipeline.run(scene, core::Progress(nullptr, &stop)), Error);
    EXPECT_TRUE(newRuns().empty());
}

TEST_F(PipelineTest, ReportsEveryStepFromStartToEnd) {
    std::map<Task, std::pair<float, float>> ranges;
    std::mutex mutex;
    (void)pipeline.run(scene, core::Progress([&](Task task, float fraction) {
                           const std::scoped_lock lock(mutex);
                           auto& [low, high] = ranges.try_emplace(task, 1.0f, 0.0f).first->second;
                           low = std::min(low, fraction);
                           high = std::max(high, fraction);
                       }));
    EXPECT_EQ(ranges.size(), 7u);
    for (const auto& [task, range] : ranges) {
        EXPECT_EQ(range.first, 0) << static_cast<int>(task);
        EXPECT_EQ(range.second, 1) << static_cast<int>(task);
    }
}

TEST_F(PipelineTest, TheSameInputGivesTheSameBytes) {
    AnalysisPipeline other;
    const auto a = pipeline.run(scene);
    const auto b = other.run(scene);
    EXPECT_EQ(a->environment->radiance, b->environment->radiance);
    EXPECT_EQ(a->reflectances[0]->rho, b->reflectances[0]->rho);
    EXPECT_EQ(a->back->depth, b->back->depth);
}

TEST_F(PipelineTest, APhotographWithoutDepthIsDistant) {
    auto photo = std::make_shared<core::Photo>(*scene.photo);
    for (float& z : photo->depth.pixels()) z = std::numeric_limits<float>::quiet_NaN();
    scene.photo = photo;
    const auto analysis = pipeline.run(scene);
    for (const float z : analysis->front->depth.pixels()) EXPECT_EQ(z, 0);
    for (const float z : analysis->back->depth.pixels()) EXPECT_EQ(z, 0);
    EXPECT_THROW((void)pipeline.run(Scene{}), Error) << "but there has to be a photograph";
}

TEST_F(PipelineTest, BackDepthOfAnotherSizeIsRefused) {
    scene.backDepth = std::make_shared<core::ImageF>(3, 3, 1.0f);
    scene.backDepthPath = "back.exr";
    try {
        (void)pipeline.run(scene);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_NE(std::string(error.what()).find("back.exr"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("3x3"), std::string::npos);
    }
}

TEST_F(PipelineTest, FirstChangedStage) {
    const auto stage = [&](const auto& change) {
        Scene after = scene;
        change(after);
        return core::firstChangedStage(scene, after);
    };
    EXPECT_EQ(stage([](Scene&) {}), Stage::Display);
    EXPECT_EQ(stage([](Scene& s) { s.photo = std::make_shared<core::Photo>(*s.photo); }), Stage::Input);
    EXPECT_EQ(stage([](Scene& s) { s.depthFilter.colorSigma = 1; }), Stage::Geometry);
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].smoothing = 0; }), Stage::Geometry);
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].backSide.offset = 1; }), Stage::BackSide);
    EXPECT_EQ(stage([](Scene& s) { s.backDepth = std::make_shared<core::ImageF>(80, 60); }), Stage::BackSide);
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].glossy = true; }), Stage::Reflectance);
    EXPECT_EQ(stage([](Scene& s) { s.environment.height = 8; }), Stage::Reflectance);
    EXPECT_EQ(stage([](Scene& s) { s.environment.rotation = 1; }), Stage::Environment);
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].edit.emplace(); }), Stage::Reshade);
    EXPECT_EQ(stage([](Scene& s) {
                  s.segments[0].edit.emplace();
                  s.segments[0].edit->translucency.emplace();
              }),
              Stage::Irradiance);
    EXPECT_EQ(stage([](Scene& s) { s.render.samples = 3; }), Stage::Reshade);
    EXPECT_EQ(stage([](Scene& s) { s.render.filter = false; }), Stage::Composite);
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].name = "x"; }), Stage::Display);
    scene.segments[0].edit.emplace();
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].edit->blendOriginal = 0.5f; }), Stage::Composite);
    EXPECT_EQ(stage([](Scene& s) { s.segments[0].edit->values[0] = 0.5f; }), Stage::Reshade);
}

}  // namespace
