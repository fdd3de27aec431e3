// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_select.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/clock.h"
#include "core/base/statistics.h"
#include "core/selection/selection_stroke.h"
#include "core/selection/selector.h"

namespace render {

namespace {

/// Clicks along each axis.
constexpr int kClicks = 5;
constexpr double kLargePixels = 12e6;
constexpr double kLargestPixels = 24e6;
/// Radius of the measured brush, and the distance of its events [px].
constexpr float kBrushRadius = 100;
constexpr float kBrushStep = 30;

/// The photograph enlarged by nearest neighbour, so that its width is `width`.
core::Photo enlarged(const core::Photo& photo, int width) {
    const int height =
        std::max(1, static_cast<int>(static_cast<long>(width) * photo.camera.height / photo.camera.width));
    core::Photo large;
    const float scale = static_cast<float>(width) / static_cast<float>(photo.camera.width);
    large.camera = {width,
                    height,
                    photo.camera.fx * scale,
                    photo.camera.fy * scale,
                    photo.camera.cx * scale,
                    photo.camera.cy * scale};
    large.depthSampleSpacing = photo.depthSampleSpacing * scale;
    large.color = core::ImageRgb(width, height);
    large.depth = core::ImageF(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int fromX = std::min(static_cast<int>(static_cast<float>(x) / scale), photo.camera.width - 1);
            const int fromY = std::min(static_cast<int>(static_cast<float>(y) / scale), photo.camera.height - 1);
            large.color(x, y) = photo.color(fromX, fromY);
            large.depth(x, y) = photo.depth(fromX, fromY);
        }
    return large;
}

void measure(const core::Photo& photo, const std::string& suffix, const core::Progress& progress,
             std::vector<BenchResult>& results) {
    const core::Clock::time_point start = core::Clock::now();
    const core::Selector selector({photo.color, photo.depth, photo.camera, photo.depthSampleSpacing},
                                  progress.part(0, 0.5f));
    const double preparation = core::secondsSince(start);
    std::vector<double> clicks;
    for (int y = 1; y <= kClicks; ++y)
        for (int x = 1; x <= kClicks; ++x) {
            const core::Pixel pixel{photo.camera.width * x / (kClicks + 1), photo.camera.height * y / (kClicks + 1)};
            const core::Clock::time_point click = core::Clock::now();
            (void)selector.select({{pixel}, {}}, progress.part(0.5f, 1));
            clicks.push_back(core::secondsSince(click));
        }
    results.push_back({"select", "pixels" + suffix, static_cast<double>(photo.color.size()), "1"});
    results.push_back({"select", "preparation_seconds" + suffix, preparation, "s"});
    results.push_back({"select", "click_seconds" + suffix, core::median(clicks), "s"});
    results.push_back({"select", "slowest_click_seconds" + suffix, *std::ranges::max_element(clicks), "s"});
}

/// Time of one pointer event while a selection is painted, with the brush's most expensive options.
void measureBrush(const core::Photo& photo, const std::string& suffix, std::vector<BenchResult>& results) {
    const int width = photo.camera.width, height = photo.camera.height;
    core::SelectionStroke stroke(core::BinaryMask(width, height),
                                 {.radius = kBrushRadius, .hardness = 0.5f, .stopAtDepthEdges = true}, photo.color,
                                 photo.depth, photo.camera.fx);
    (void)stroke.moveTo(kBrushRadius, static_cast<float>(height) / 2);
    std::vector<double> events;
    for (float x = kBrushRadius + kBrushStep; x < static_cast<float>(width) - kBrushRadius; x += kBrushStep) {
        const core::Clock::time_point event = core::Clock::now();
        (void)stroke.moveTo(x, static_cast<float>(height) / 2);
        events.push_back(core::secondsSince(event));
    }
    results.push_back({"select", "brush_event_seconds" + suffix, core::median(events), "s"});
}

}  // namespace

std::vector<BenchResult> benchSelection(const core::Photo& photo, const core::Progress& progress) {
    std::vector<BenchResult> results;
    measure(photo, "", progress.part(0, 0.3f), results);
    const double ratio = static_cast<double>(photo.camera.width) / photo.camera.height;
    measure(enlarged(photo, static_cast<int>(std::sqrt(kLargePixels * ratio))), ".12_megapixels",
            progress.part(0.3f, 1), results);
    measureBrush(enlarged(photo, static_cast<int>(std::sqrt(kLargestPixels * ratio))), ".24_megapixels", results);
    return results;
}

}  // namespace render
