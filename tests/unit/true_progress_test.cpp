// SPDX-License-Identifier: GPL-3.0-or-later
// Progress that follows time: a step that reports one half is about half done.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/analysis/pipeline.h"
#include "core/base/clock.h"
#include "core/base/statistics.h"
#include "core/io/image_io.h"
#include "core/io/project.h"
#include "tests/support/temp_folder.h"

namespace {

using core::Scene;
using core::Task;

struct Report {
    double seconds;
    float fraction;
};

/// One run of one step.
struct StepRun {
    double seconds = 0;
    float halfway = 0;  ///< fraction reported last before half of the time had passed
};

/// Runs work and measures the steps that it reports.
std::map<Task, StepRun> runSteps(const std::function<void(const core::Progress&)>& work) {
    std::map<Task, std::vector<Report>> reports;
    std::mutex mutex;
    const auto start = core::Clock::now();
    work(core::Progress([&](Task task, float fraction) {
        const std::scoped_lock lock(mutex);
        reports[task].push_back({core::secondsSince(start), fraction});
    }));
    std::map<Task, StepRun> runs;
    for (const auto& [task, all] : reports) {
        StepRun& run = runs[task];
        run.seconds = all.back().seconds - all.front().seconds;
        for (const Report& report : all)
            if (report.seconds - all.front().seconds <= 0.5 * run.seconds) run.halfway = report.fraction;
    }
    return runs;
}

/// Steps shorter than this are not worth a bar, and their times mostly measure the scheduler.
constexpr double kMinSeconds = 0.05;

/// The median of `count` runs is robust against other work on the machine.
void expectTrueProgress(int count, const std::function<void(const core::Progress&)>& work) {
    std::map<Task, std::vector<StepRun>> all;
    for (int i = 0; i < count; ++i)
        for (const auto& [task, run] : runSteps(work)) all[task].push_back(run);
    for (const auto& [task, runs] : all) {
        std::vector<double> seconds;
        std::vector<float> halfway;
        for (const StepRun& run : runs) {
            seconds.push_back(run.seconds);
            halfway.push_back(run.halfway);
        }
        const double time = core::median(seconds);
        const float fraction = core::median(halfway);
        std::printf("task %d: %.3f s, at half of it %.0f %%\n", static_cast<int>(task), time,
                    100 * static_cast<double>(fraction));
        if (time < kMinSeconds) continue;
        EXPECT_GT(fraction, 0.35f) << "task " << static_cast<int>(task) << ", " << time << " s";
        EXPECT_LT(fraction, 0.65f) << "task " << static_cast<int>(task) << ", " << time << " s";
    }
}

Scene studio() { return core::loadProject(PATINA_SAMPLES "/studio/studio.patina"); }

void analyze(const Scene& scene, const core::Progress& progress) {
    core::AnalysisPipeline pipeline;
    (void)pipeline.run(scene, progress);
}

core::ImageRgb enlarged(const core::ImageRgb& image, int width, int height) {
    core::ImageRgb result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) result(x, y) = image(x * image.width() / width, y * image.height() / height);
    return result;
}

TEST(TrueProgress, OfExactDepth) {
    const Scene scene = studio();
    expectTrueProgress(3, [&](const core::Progress& progress) { analyze(scene, progress); });
}

TEST(TrueProgress, OfNoisyDepth) {
    Scene scene = studio();
    auto photo = std::make_shared<core::Photo>(*scene.photo);
    photo->depth = core::loadScalar(PATINA_SAMPLES "/studio/depth_mm.png");
    for (float& z : photo->depth.pixels()) z *= 0.001f;
    scene.photo = photo;
    expectTrueProgress(3, [&](const core::Progress& progress) { analyze(scene, progress); });
}

/// As a phone stores it: depth and labels are much smaller than the photograph.
TEST(TrueProgress, OfTwelveMegapixels) {
    const test::TempFolder folder;
    const Scene small = studio();
    core::saveColor(enlarged(small.photo->color, 4242, 2828), folder / "color.png");
    core::CreateOptions options;
    options.color = folder / "color.png";
    options.depth = PATINA_SAMPLES "/studio/depth_mm.png";
    options.depthUnit = 0.001;
    options.segments = PATINA_SAMPLES "/studio/segments.png";
    options.glossy = {"2"};
    options.hfov = 0.7f;
    expectTrueProgress(1, [&](const core::Progress& progress) {
        analyze(core::createScene(options, nullptr, progress.of(Task::LoadPhoto)), progress);
    });
}

}  // namespace
