// SPDX-License-Identifier: GPL-3.0-or-later
// Progress that follows time: a step that reports one half is about half done.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/analysis/pipeline.h"
#include "core/base/clock.h"
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
    std::array<float, 10> reported{};  ///< fraction reported last before so many tenths of the time had passed
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
        for (const Report& report : all) {
            const double part = (report.seconds - all.front().seconds) / std::max(run.seconds, 1e-9);
            for (std::size_t tenth = 1; tenth < run.reported.size(); ++tenth)
                if (part <= 0.1 * static_cast<double>(tenth)) run.reported[tenth] = report.fraction;
        }
    }
    return runs;
}

/// A step that was reported wrongly at half of its time.
struct Untrue {
    Task task;
    StepRun run;
};

/// Runs the work once and prints what it reported.
std::vector<Untrue> findUntrue(const std::function<void(const core::Progress&)>& work) {
    /// Shorter steps end before anyone reads a bar, and their times mostly measure the scheduler.
    constexpr double kMinSeconds = 0.1;
    constexpr float kTolerance = 0.15f;
    std::vector<Untrue> result;
    int judged = 0;
    for (const auto& [task, run] : runSteps(work)) {
        std::printf("task %d: %.3f s, reported at every tenth of it:", static_cast<int>(task), run.seconds);
        for (std::size_t tenth = 1; tenth < run.reported.size(); ++tenth)
            std::printf(" %.2f", static_cast<double>(run.reported[tenth]));
        std::printf("\n");
        if (run.seconds < kMinSeconds) continue;
        ++judged;
        if (std::abs(run.reported[5] - 0.5f) > kTolerance) result.push_back({task, run});
    }
    EXPECT_GT(judged, 0) << "no step took long enough to be judged";
    return result;
}

/// Other work on the machine may disturb a run, so it is repeated before it counts as wrong.
void expectTrueProgress(const std::function<void(const core::Progress&)>& work) {
    constexpr int kAttempts = 5;
    // Shares of time are measured on two cores: with more, what is not parallel takes a larger share.
    const tbb::global_control twoCores(tbb::global_control::max_allowed_parallelism, 2);
    std::vector<Untrue> untrue = findUntrue(work);
    for (int i = 1; i < kAttempts && !untrue.empty(); ++i) untrue = findUntrue(work);
    for (const auto& [task, run] : untrue)
        ADD_FAILURE() << "task " << static_cast<int>(task) << " of " << run.seconds << " s reported " << run.reported[5]
                      << " at half of it";
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
    expectTrueProgress([&](const core::Progress& progress) { analyze(scene, progress); });
}

TEST(TrueProgress, OfNoisyDepth) {
    Scene scene = studio();
    auto photo = std::make_shared<core::Photo>(*scene.photo);
    photo->depth = core::loadScalar(PATINA_SAMPLES "/studio/depth_mm.png");
    for (float& z : photo->depth.pixels()) z *= 0.001f;
    scene.photo = photo;
    expectTrueProgress([&](const core::Progress& progress) { analyze(scene, progress); });
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
    expectTrueProgress([&](const core::Progress& progress) {
        analyze(core::createScene(options, nullptr, progress.of(Task::LoadPhoto)), progress);
    });
}

}  // namespace
