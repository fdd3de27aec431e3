// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "app/cli/devices.h"
#include "app/cli/session.h"
#include "core/base/statistics.h"
#include "core/io/import/import_format.h"
#include "core/io/material_json.h"

namespace cli {

namespace {

using nlohmann::ordered_json;

ordered_json triple(const core::Vector3f& v) { return ordered_json::array({v.x(), v.y(), v.z()}); }

ordered_json describeDepth(const core::ImageF& depth) {
    std::vector<float> valid;
    std::ranges::copy_if(depth.pixels(), std::back_inserter(valid), [](float z) { return z > 0; });
    ordered_json result;
    result["valid_fraction"] = static_cast<double>(valid.size()) / static_cast<double>(depth.size());
    if (valid.empty()) return result;
    result["median"] = core::median(valid);
    const auto [min, max] = std::ranges::minmax(valid);
    result["min"] = min;
    result["max"] = max;
    return result;
}

/// Back-side method, penalty and thickness by label; segments without depth are left out.
std::map<std::uint16_t, ordered_json> describeBackSides(const core::Scene& scene, const core::Analysis& analysis) {
    const core::LabelImage& labels = scene.photo->labels;
    std::map<std::uint16_t, std::vector<float>> thickness;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != 0 && analysis.front->depth[i] > 0)
            thickness[labels[i]].push_back(analysis.back->depth[i] - analysis.front->depth[i]);
    std::map<std::uint16_t, ordered_json> result;
    for (const core::BackSideInfo& info : analysis.backSides) {
        std::vector<float>& values = thickness[info.label];
        if (values.empty()) continue;
        ordered_json& entry = result[info.label];
        entry["method"] = core::wordOf(info.used);
        entry["penalty"] = info.mirrorError;
        entry["thickness"] = core::median(values);
        entry["on_support"] = info.onSupport;
        if (!info.note.empty()) entry["note"] = info.note.english();
    }
    return result;
}

/// Back sides are described only with an `analysis`.
ordered_json describe(const core::Scene& scene, const std::string& project, const core::Analysis* analysis) {
    const core::Photo& photo = *scene.photo;
    const core::Camera& camera = photo.camera;
    ordered_json result;
    result["project"] = project;
    result["width"] = camera.width;
    result["height"] = camera.height;
    result["files"] = {{"color", photo.source.color},
                       {"depth", photo.source.depth},
                       {"segments", photo.source.segments},
                       {"environment", scene.environment.path},
                       {"back_depth", scene.backDepthPath}};
    result["intrinsics"] = {{"fx", camera.fx}, {"fy", camera.fy}, {"cx", camera.cx}, {"cy", camera.cy}};
    result["hfov_degrees"] = 360 / std::numbers::pi * std::atan(0.5 * camera.width / static_cast<double>(camera.fx));
    result["depth"] = describeDepth(photo.depth);
    result["depth"]["kind"] = core::wordOf(photo.source.depthKind);
    result["depth"]["unit"] = photo.source.depthUnit;
    if (photo.source.depth.empty() && result["depth"].contains("median"))
        if (const core::ImportFormat* format = core::findImportFormat(core::ImportFile(photo.source.color)))
            result["depth"]["inside"] = format->name;
    std::map<std::uint16_t, std::size_t> pixels;
    std::map<std::uint16_t, std::size_t> withDepth;
    for (std::size_t i = 0; i < photo.labels.size(); ++i) {
        ++pixels[photo.labels[i]];
        if (photo.depth[i] > 0) ++withDepth[photo.labels[i]];
    }
    std::map<std::uint16_t, ordered_json> backSides;
    if (analysis != nullptr) backSides = describeBackSides(scene, *analysis);
    result["segments"] = ordered_json::array();
    for (const core::Segment& segment : scene.segments) {
        ordered_json entry;
        entry["label"] = segment.label;
        entry["name"] = segment.name;
        entry["glossy"] = segment.glossy;
        entry["pixels"] = pixels[segment.label];
        entry["pixels_with_depth"] = withDepth[segment.label];
        if (segment.reflectance) entry["reflectance"] = triple(*segment.reflectance);
        if (segment.edit) entry["edit"] = ordered_json::parse(core::materialToJson(*segment.edit));
        if (const auto back = backSides.find(segment.label); back != backSides.end()) entry["back_side"] = back->second;
        result["segments"].push_back(std::move(entry));
    }
    result["render"] = {{"samples", scene.render.samples},
                        {"seed", scene.render.seed},
                        {"bounces", scene.render.bounces},
                        {"filter", scene.render.filter}};
    return result;
}

void printText(const ordered_json& info) {
    const auto text = [](const ordered_json& value) {
        const auto name = value.get<std::string>();
        return name.empty() ? std::string("-") : name;
    };
    std::printf("%s\n", text(info["project"]).c_str());
    std::printf("  photograph   %s, %dx%d\n", text(info["files"]["color"]).c_str(), info["width"].get<int>(),
                info["height"].get<int>());
    const ordered_json& depth = info["depth"];
    if (depth.contains("median"))
        std::printf("  depth        %s, %.4g to %.4g m (median %.4g m), valid in %.1f %% of the pixels\n",
                    text(depth.contains("inside") ? depth["inside"] : info["files"]["depth"]).c_str(),
                    depth["min"].get<double>(), depth["max"].get<double>(), depth["median"].get<double>(),
                    100 * depth["valid_fraction"].get<double>());
    else
        std::printf("  depth        none\n");
    std::printf("  camera       fx %g, fy %g, cx %g, cy %g px (%.1f degrees wide)\n",
                info["intrinsics"]["fx"].get<double>(), info["intrinsics"]["fy"].get<double>(),
                info["intrinsics"]["cx"].get<double>(), info["intrinsics"]["cy"].get<double>(),
                info["hfov_degrees"].get<double>());
    std::printf("  environment  %s\n", info["files"]["environment"].get<std::string>().empty()
                                           ? "recovered from the photograph"
                                           : text(info["files"]["environment"]).c_str());
    std::printf("  segments     %s, %zu\n", text(info["files"]["segments"]).c_str(), info["segments"].size());
    for (const ordered_json& segment : info["segments"]) {
        std::printf(
            "    %5d  %-20s %8zu px%s%s\n", segment["label"].get<int>(), segment["name"].get<std::string>().c_str(),
            segment["pixels"].get<std::size_t>(), segment["glossy"].get<bool>() ? "  glossy" : "",
            segment.contains("edit") ? ("  edited: " + segment["edit"]["brdf"].get<std::string>()).c_str() : "");
        if (!segment.contains("back_side")) continue;
        const ordered_json& back = segment["back_side"];
        std::printf("           back: %s, penalty %.2f, %.3g m thick%s\n", back["method"].get<std::string>().c_str(),
                    back["penalty"].get<double>(), back["thickness"].get<double>(),
                    back["on_support"].get<bool>() ? ", on a support" : "");
    }
}

}  // namespace

void addInfo(CLI::App& app, Session& session) {
    struct Arguments {
        std::string project;
        bool json = false;
        bool backSides = false;
    };
    const auto args = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("info", "Describe a project: files, camera, depth range, segments, edits");
    command->add_option("project", args->project, "Project file")->required()->type_name("P.patina");
    command->add_flag("--json", args->json, "Print one JSON document");
    command->add_flag("--back-sides", args->backSides, "Analyse the photograph and say how each back side was made");
    command->callback([&session, args] {
        session.run = [&session, args] {
            const core::Scene scene = loadScene(args->project);
            const auto analysis = args->backSides ? analyse(scene, session) : nullptr;
            const ordered_json info = describe(scene, args->project, analysis.get());
            if (args->json)
                std::cout << info.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
            else
                printText(info);
        };
    });
}

}  // namespace cli
