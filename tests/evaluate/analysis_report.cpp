// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/analysis_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tests/evaluate/directional_metrics.h"
#include "tests/evaluate/markdown.h"
#include "tests/evaluate/metrics.h"
#include "tests/support/sensor_noise.h"

namespace evaluate {

namespace {

using core::Vector3f;

constexpr std::uint32_t kNoiseSeed = 1;

const std::vector<std::pair<const char*, core::BackSideMethod>>& backSideMethods() {
    static const std::vector<std::pair<const char*, core::BackSideMethod>> kMethods = {
        {"offset", core::BackSideMethod::Offset},        {"parallel_mirror", core::BackSideMethod::ParallelMirror},
        {"pca_mirror", core::BackSideMethod::PcaMirror}, {"spanned_mirror", core::BackSideMethod::SpannedMirror},
        {"flat_faces", core::BackSideMethod::FlatFaces}, {"automatic", core::BackSideMethod::Automatic},
    };
    return kMethods;
}

const std::vector<std::pair<const char*, core::EnvironmentFill>>& environmentFills() {
    static const std::vector<std::pair<const char*, core::EnvironmentFill>> kFills = {
        {"shepard", core::EnvironmentFill::Shepard},
        {"membrane", core::EnvironmentFill::Membrane},
    };
    return kFills;
}

/// The scene without glossy segments and with a tiny environment: nearly no work after the back side.
core::Scene geometryOnly(core::Scene scene) {
    for (core::Segment& segment : scene.segments) segment.glossy = false;
    scene.environment.height = 4;
    return scene;
}

/// Angles between estimated and true normals [degrees] of every segment.
std::vector<std::pair<std::string, std::vector<float>>> normalErrors(const core::Scene& scene,
                                                                     const core::ImageV3& normals,
                                                                     const core::ImageV3& truth) {
    std::vector<std::pair<std::string, std::vector<float>>> errors;
    for (const core::Segment& segment : scene.segments) {
        std::vector<float>& list = errors.emplace_back(segment.name, std::vector<float>()).second;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            if (scene.photo->labels[i] != segment.label || truth[i].isZero() || normals[i].isZero()) continue;
            list.push_back(static_cast<float>(angleDegrees(normals[i], truth[i])));
        }
    }
    return errors;
}

Json quantiles(const std::vector<float>& values) {
    return {{"median", quantile(values, 0.5)}, {"p95", quantile(values, 0.95)}};
}

/// One entry per segment, kAllButTable and kAll.
Json normalReport(const SceneFolder& folder, const core::ImageV3& truth) {
    Json segments = Json::object();
    for (const char* depth : {"exact", "noisy"}) {
        core::Scene scene = geometryOnly(folder.scene);
        for (core::Segment& segment : scene.segments) segment.backSide.method = core::BackSideMethod::Offset;
        if (std::string(depth) == "noisy") {
            auto photo = std::make_shared<core::Photo>(*scene.photo);
            photo->depth = test::withSensorNoise(photo->depth, {}, kNoiseSeed);
            scene.photo = photo;
        }
        for (const bool filter : {false, true}) {
            scene.depthFilter.enabled = filter;
            const auto analysis = core::AnalysisPipeline().run(scene);
            std::vector<float> objects, all;
            const auto add = [&](const std::string& name, const std::vector<float>& values) {
                segments[name]["pixels"] = values.size();
                segments[name][depth][filter ? "filtered" : "unfiltered"] = quantiles(values);
            };
            for (const auto& [name, values] : normalErrors(scene, analysis->front->normal, truth)) {
                add(name, values);
                all.insert(all.end(), values.begin(), values.end());
                if (name != kTable) objects.insert(objects.end(), values.begin(), values.end());
            }
            add(kAllButTable, objects);
            add(kAll, all);
        }
    }
    return segments;
}

/// Relative error of the total patch area against the one computed from true depth and normals. Viewing angles are
/// clamped to 88.9 degrees in both; otherwise a single grazing pixel would dominate.
Json areaReport(const SceneFolder& folder, const core::Surface& front, const core::ImageV3& truth) {
    const core::Photo& photo = *folder.scene.photo;
    const core::Camera& camera = photo.camera;
    std::map<std::string, std::pair<double, double>> areas;
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const core::Segment* segment = folder.scene.findSegment(photo.labels(x, y));
            const float z = photo.depth(x, y);
            if (segment == nullptr || z <= 0 || truth(x, y).isZero()) continue;
            const Eigen::Vector3d p = camera.backProject(x, y, z).cast<double>();
            const double cosine = std::max(std::abs(truth(x, y).cast<double>().dot(p)), 0.02 * p.norm());
            const double expected = p.z() * p.z() * p.z() / (static_cast<double>(camera.fx) * camera.fy * cosine);
            const auto add = [&](const std::string& name) {
                areas[name].first += front.area(x, y);
                areas[name].second += expected;
            };
            add(segment->name);
            if (segment->name != kTable) add(kAllButTable);
            add(kAll);
        }
    }
    Json report = Json::object();
    const auto add = [&](const std::string& name) {
        if (areas.contains(name)) report[name] = areas[name].first / areas[name].second - 1;
    };
    for (const core::Segment& segment : folder.scene.segments) add(segment.name);
    add(kAllButTable);
    add(kAll);
    return report;
}

/// |z_back − truth| relative to the object's median true thickness, by method.
Json backSideReport(const SceneFolder& folder) {
    const core::ImageF truth = trueBackDepth(folder);
    const core::Photo& photo = *folder.scene.photo;
    core::Scene scene = geometryOnly(folder.scene);
    core::AnalysisPipeline pipeline;
    Json report = Json::object();
    for (const auto& [method, value] : backSideMethods()) {
        for (core::Segment& segment : scene.segments) segment.backSide.method = value;
        const auto analysis = pipeline.run(scene);
        for (const core::Segment& segment : scene.segments) {
            std::vector<float> errors, thickness;
            for (std::size_t i = 0; i < truth.size(); ++i) {
                if (photo.labels[i] != segment.label || photo.depth[i] <= 0 || truth[i] <= 0) continue;
                errors.push_back(std::abs(analysis->back->depth[i] - truth[i]));
                thickness.push_back(truth[i] - photo.depth[i]);
            }
            const double scale = quantile(thickness, 0.5);
            report[segment.name]["thickness"] = scale;
            report[segment.name][method] = {{"median", quantile(errors, 0.5) / scale},
                                            {"p90", quantile(errors, 0.9) / scale}};
        }
    }
    return report;
}

Json reflectanceReport(const SceneFolder& folder, const core::Analysis& analysis) {
    Json report = Json::object();
    for (const auto& [label, truth] : folder.gloss) {
        const core::Reflectance* found = analysis.findReflectance(label);
        if (found == nullptr) continue;
        const Vector3f error = found->rho.cwiseQuotient(truth.specularColor) - Vector3f::Ones();
        report[folder.scene.findSegment(label)->name] = {{"error", {error.x(), error.y(), error.z()}},
                                                         {"reliable", found->reliable},
                                                         {"alpha", found->alpha},
                                                         {"alpha_reliable", found->alphaReliable},
                                                         {"true_alpha", truth.alpha}};
    }
    return report;
}

Json toJson(const DirectionalError& error) {
    return {{"share", error.share},
            {"median_error", error.medianError},
            {"rmse_blurred", error.blurredRmse},
            {"mean_ratio", error.meanRatio}};
}

Json environmentReport(const SceneFolder& folder, core::AnalysisPipeline& pipeline) {
    const core::ImageRgb truth = trueEnvironment(folder);
    Json report = Json::object();
    for (const auto& [name, fill] : environmentFills()) {
        core::Scene scene = folder.scene;
        scene.environment.fill = fill;
        const EnvironmentError error = compareEnvironment(*pipeline.run(scene)->environment, truth);
        report[name] = {{"observed", toJson(error.observed)}, {"filled", toJson(error.filled)}};
    }
    return report;
}

std::string medianAndTail(const Json& entry, const char* tail, int digits) {
    return fixed(entry.at("median"), digits) + " / " + fixed(entry.at(tail), digits);
}

std::string percentPair(const Json& entry, const char* tail) {
    return fixed(100 * entry.at("median").get<double>(), 1) + " / " + fixed(100 * entry.at(tail).get<double>(), 1);
}

void printNormals(std::ostream& out, const Json& reports) {
    out << "\n### Normals\n\nAngle to the true normal [degrees], median / 95 %. Exact depth, and depth as a Kinect "
           "would measure it.\n\n";
    Table table(out, {"scene", "segment", "exact, no filter", "exact, filter", "noisy, no filter", "noisy, filter"});
    for (const Json& report : reports) {
        for (const auto& [segment, entry] : report.at("normals").items()) {
            std::vector<std::string> cells = {report.at("scene"), segment};
            for (const char* depth : {"exact", "noisy"})
                for (const char* filter : {"unfiltered", "filtered"})
                    cells.push_back(medianAndTail(entry.at(depth).at(filter), "p95", 2));
            table.row(cells);
        }
    }
}

void printAreas(std::ostream& out, const Json& reports) {
    out << "\n### Patch areas\n\nTotal area of the patches over that computed from true normals, minus 1, exact "
           "depth.\n\n";
    Table table(out, {"scene", "segment", "error"});
    for (const Json& report : reports)
        for (const auto& [segment, error] : report.at("areas").items())
            table.row({report.at("scene"), segment, percent(error, 2)});
}

void printBackSides(std::ostream& out, const Json& reports) {
    out << "\n### Back sides\n\nDepth error of the back side in per cent of the object's median thickness, median / "
           "90 %.\n\n";
    std::vector<std::string> columns = {"scene", "segment", "thickness [mm]"};
    for (const auto& method : backSideMethods()) columns.emplace_back(method.first);
    Table table(out, columns);
    for (const Json& report : reports) {
        for (const auto& [segment, entry] : report.at("back_sides").items()) {
            std::vector<std::string> cells = {report.at("scene"), segment,
                                              fixed(1000 * entry.at("thickness").get<double>(), 1)};
            for (const auto& method : backSideMethods()) cells.push_back(percentPair(entry.at(method.first), "p90"));
            table.row(cells);
        }
    }
}

void printReflectances(std::ostream& out, const Json& reports) {
    out << "\n### Reflectance and lobe of glossy segments\n\nEstimated over true, minus 1, per channel; GGX width "
           "alpha. In brackets: the estimate itself says that it is a guess.\n\n";
    Table table(out, {"scene", "segment", "red", "green", "blue", "alpha", "true alpha"});
    const auto flagged = [](const std::string& text, bool reliable) { return reliable ? text : "(" + text + ")"; };
    for (const Json& report : reports) {
        for (const auto& [segment, entry] : report.at("reflectance").items()) {
            const bool reliable = entry.at("reliable");
            std::vector<std::string> cells = {report.at("scene"), segment};
            for (const Json& error : entry.at("error")) cells.push_back(flagged(percent(error), reliable));
            cells.push_back(flagged(fixed(entry.at("alpha"), 3), entry.at("alpha_reliable")));
            cells.push_back(fixed(entry.at("true_alpha"), 3));
            table.row(cells);
        }
    }
}

void printEnvironments(std::ostream& out, const Json& reports) {
    out << "\n### Environment\n\nLuminance of the recovered light against the true one, weighted by solid angle: "
           "median relative error; RMSE over the true mean after blurring both by 10 degrees; mean over true mean.\n\n";
    Table table(out, {"scene", "fill", "observed", "median", "RMSE, blurred", "mean", "filled", "median",
                      "RMSE, blurred", "mean"});
    for (const Json& report : reports) {
        for (const auto& [fill, entry] : report.at("environment").items()) {
            std::vector<std::string> cells = {report.at("scene"), fill};
            for (const char* part : {"observed", "filled"}) {
                const Json& error = entry.at(part);
                cells.push_back(percent(error.at("share"), 0));
                cells.push_back(percent(error.at("median_error")));
                cells.push_back(percent(error.at("rmse_blurred")));
                cells.push_back(fixed(error.at("mean_ratio"), 2));
            }
            table.row(cells);
        }
    }
}

}  // namespace

Json analysisReport(const SceneFolder& folder, core::AnalysisPipeline& pipeline) {
    const auto analysis = pipeline.run(folder.scene);
    const core::ImageV3 normals = trueNormals(folder);
    return {{"scene", folder.name},
            {"normals", normalReport(folder, normals)},
            {"areas", areaReport(folder, *analysis->front, normals)},
            {"back_sides", backSideReport(folder)},
            {"reflectance", reflectanceReport(folder, *analysis)},
            {"environment", environmentReport(folder, pipeline)}};
}

void printAnalysis(std::ostream& out, const Json& reports) {
    if (reports.empty()) return;
    printNormals(out, reports);
    printAreas(out, reports);
    printBackSides(out, reports);
    printReflectances(out, reports);
    printEnvironments(out, reports);
}

}  // namespace evaluate
