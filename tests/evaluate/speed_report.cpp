// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/speed_report.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "app/bench/bench.h"
#include "tests/evaluate/analysis_report.h"
#include "tests/evaluate/device.h"
#include "tests/evaluate/markdown.h"

namespace evaluate {

namespace {

/// Resets the process's peak of resident memory to its current value (Linux; no effect elsewhere).
void resetPeakMemory() { std::ofstream("/proc/self/clear_refs") << "5"; }

/// A value of /proc/self/status in bytes, 0 if missing.
double statusBytes(const std::string& key) {
    std::ifstream file("/proc/self/status");
    std::string word;
    while (file >> word)
        if (word == key + ":") {
            double kibibytes = 0;
            file >> kibibytes;
            return 1024 * kibibytes;
        }
    return 0;
}

/// Bilinear interpolation between pixels of the same label with depth, so that edges stay sharp.
template <class T>
T enlargedPixel(const core::Image<T>& image, const core::Photo& photo, float u, float v) {
    const int x = std::clamp(static_cast<int>(u), 0, image.width() - 1);
    const int y = std::clamp(static_cast<int>(v), 0, image.height() - 1);
    T sum = core::zeroPixel<T>();
    float weights = 0;
    const auto x0 = static_cast<int>(std::floor(u - 0.5f));
    const auto y0 = static_cast<int>(std::floor(v - 0.5f));
    for (int j = y0; j <= y0 + 1; ++j) {
        for (int i = x0; i <= x0 + 1; ++i) {
            if (!image.contains(i, j) || photo.labels(i, j) != photo.labels(x, y)) continue;
            if ((photo.depth(i, j) > 0) != (photo.depth(x, y) > 0)) continue;
            const float weight =
                (1 - std::abs(u - 0.5f - static_cast<float>(i))) * (1 - std::abs(v - 0.5f - static_cast<float>(j)));
            sum += weight * image(i, j);
            weights += weight;
        }
    }
    return weights > 0 ? T(sum / weights) : image(x, y);
}

Json measured(const std::string& caseName, const core::Scene& scene, const gpu::Device& device) {
    resetPeakMemory();
    const double before = statusBytes("VmRSS");
    Json report = {{"case", caseName},
                   {"width", scene.photo->camera.width},
                   {"height", scene.photo->camera.height},
                   {"seconds", Json::object()}};
    const auto nothing = std::make_shared<core::Analysis>();
    for (const render::BenchResult& result : render::runBenchmarks({"analyse"}, device, scene, nothing)) {
        constexpr std::string_view kPrefix = "seconds.";
        if (result.metric.starts_with(kPrefix)) report["seconds"][result.metric.substr(kPrefix.size())] = result.value;
    }
    report["resident_before_bytes"] = before;
    report["peak_bytes"] = statusBytes("VmHWM");
    return report;
}

/// Also marks the largest other segment (not the table) as glossy if there are fewer than two glossy ones.
core::Scene withTwoGlossySegments(const core::Scene& scene) {
    core::Scene result = scene;
    const auto glossy = std::ranges::count_if(result.segments, &core::Segment::glossy);
    if (glossy >= 2) return result;
    std::map<std::uint16_t, std::size_t> pixels;
    for (const std::uint16_t label : scene.photo->labels.pixels()) ++pixels[label];
    core::Segment* largest = nullptr;
    for (core::Segment& segment : result.segments) {
        if (segment.glossy || segment.name == kTable) continue;
        if (largest == nullptr || pixels[segment.label] > pixels[largest->label]) largest = &segment;
    }
    if (largest != nullptr) largest->glossy = true;
    return result;
}

core::Scene enlargedTo(const core::Scene& scene, double megapixels) {
    const core::Photo& photo = *scene.photo;
    const double factor = std::sqrt(megapixels * 1e6 / static_cast<double>(photo.color.size()));
    auto large = std::make_shared<core::Photo>();
    core::Camera& camera = large->camera;
    camera = photo.camera;
    camera.width = static_cast<int>(std::lround(factor * photo.camera.width));
    camera.height = static_cast<int>(std::lround(factor * photo.camera.height));
    const float sx = static_cast<float>(camera.width) / static_cast<float>(photo.camera.width);
    const float sy = static_cast<float>(camera.height) / static_cast<float>(photo.camera.height);
    camera.fx *= sx, camera.cx *= sx, camera.fy *= sy, camera.cy *= sy;
    large->color = core::ImageRgb(camera.width, camera.height);
    large->depth = core::ImageF(camera.width, camera.height);
    large->labels = core::LabelImage(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / sx;
            const float v = (static_cast<float>(y) + 0.5f) / sy;
            large->color(x, y) = enlargedPixel(photo.color.image(), photo, u, v);
            large->depth(x, y) = enlargedPixel(photo.depth.image(), photo, u, v);
            large->labels(x, y) = photo.labels(std::min(static_cast<int>(u), photo.camera.width - 1),
                                               std::min(static_cast<int>(v), photo.camera.height - 1));
        }
    }
    core::Scene result = scene;
    result.photo = large;
    return result;
}

}  // namespace

std::vector<Json> speedReports(const SceneFolder& folder) {
    const gpu::Device device = newDevice();
    std::vector<Json> reports;
    const core::Camera& camera = folder.scene.photo->camera;
    if (camera.width == 1024 && camera.height == 1024) {
        reports.push_back(measured("1024² with two glossy segments (" + folder.name + ")",
                                   withTwoGlossySegments(folder.scene), device));
        reports.back()["limit_seconds"] = 2;
    } else {
        reports.push_back(measured(folder.name, folder.scene, device));
    }
    if (folder.name == "studio") {
        reports.push_back(measured("12 megapixels (studio, enlarged)", enlargedTo(folder.scene, 12), device));
        reports.back()["limit_seconds"] = 30;
        reports.back()["limit_bytes"] = 4.0 * 1024 * 1024 * 1024;
    }
    return reports;
}

std::string gibibytes(const Json& bytes) { return fixed(bytes.get<double>() / (1024.0 * 1024 * 1024), 2) + " GiB"; }

void printSpeed(std::ostream& out, const Json& reports) {
    if (reports.empty()) return;
    constexpr const char* kSteps[] = {"filter", "geometry", "backside", "reflectance", "environment", "total"};
    out << "\n### Time and memory of the analysis\n\nSeconds by step; peak of this process's resident memory, and what "
           "it held before, the picture included.\n\n";
    std::vector<std::string> columns = {"case", "size"};
    columns.insert(columns.end(), std::begin(kSteps), std::end(kSteps));
    columns.insert(columns.end(), {"peak", "before"});
    Table table(out, columns);
    for (const Json& report : reports) {
        std::vector<std::string> cells = {report.at("case"), std::to_string(report.at("width").get<int>()) + " × " +
                                                                 std::to_string(report.at("height").get<int>())};
        for (const char* step : kSteps) cells.push_back(fixed(report.at("seconds").value(step, Json()), 2));
        cells.push_back(gibibytes(report.at("peak_bytes")));
        cells.push_back(gibibytes(report.at("resident_before_bytes")));
        table.row(cells);
    }
}

}  // namespace evaluate
