// SPDX-License-Identifier: GPL-3.0-or-later
// Compares Patina's analysis and edits with path-traced ground truth for every scene below a folder, and measures their
// speed. Prints Markdown; figures (JSON) and pictures go to the output folder. docs/evaluation.md explains the tables.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/analysis/pipeline.h"
#include "core/io/image_io.h"
#include "tests/evaluate/analysis_report.h"
#include "tests/evaluate/contact_sheet.h"
#include "tests/evaluate/device.h"
#include "tests/evaluate/edit_report.h"
#include "tests/evaluate/metrics.h"
#include "tests/evaluate/phone_report.h"
#include "tests/evaluate/photo_report.h"
#include "tests/evaluate/selection_report.h"
#include "tests/evaluate/sheets.h"
#include "tests/evaluate/speed_report.h"
#include "tests/evaluate/targets.h"

namespace {

namespace fs = std::filesystem;
using evaluate::Json;

struct Options {
    std::string root;
    std::string output = "evaluation";
    std::vector<std::string> parts = {"analysis", "speed", "edits", "phone", "photos", "selection"};
    std::string scene;
    std::string edit;
    int samples = 64;
    evaluate::PhotoOptions photos;
    std::string commit = "unknown";

    [[nodiscard]] bool has(const char* part) const { return std::ranges::find(parts, part) != parts.end(); }
};

void addOptions(CLI::App& app, Options& options) {
    app.add_option("folder", options.root, "Folder of reference data (default: PATINA_REFERENCE_DATA)");
    app.add_option("-o,--output", options.output, "Output folder for evaluation.md, evaluation.json and pictures");
    app.add_option("--only", options.parts, "Parts to run: analysis, speed, edits, phone, photos, selection")
        ->delimiter(',')
        ->check(CLI::IsMember({"analysis", "speed", "edits", "phone", "photos", "selection"}));
    app.add_option("--scene", options.scene, "Evaluate only this scene or photo");
    app.add_option("--edit", options.edit, "Evaluate only this edit");
    app.add_option("--samples", options.samples, "Paths per pixel of the edits")->check(CLI::PositiveNumber);
    app.add_option("--photo-samples", options.photos.samples, "Paths per pixel of the photos' edits")
        ->check(CLI::PositiveNumber);
    app.add_option("--photo-size", options.photos.longerSide, "Reduce photos to this longer side [px]; 0 = full size")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--commit", options.commit, "Version named in the report");
}

void progress(const std::string& message) { std::cerr << message << std::endl; }

Json evaluatePhotos(const Options& options) {
    Json reports = Json::array();
    evaluate::ContactSheet sheet(300, 300);
    const Json list = evaluate::readJson(PATINA_SOURCE_DIR "/tests/evaluate/photos.json");
    for (const Json& entry : list.at("photos")) {
        const fs::path folder = fs::path(options.root) / "rgbd" / entry.at("folder").get<std::string>();
        const std::string name = entry.at("name");
        if (!fs::exists(folder) || (!options.scene.empty() && name != options.scene)) continue;
        progress("photo " + name);
        reports.push_back(evaluate::photoReport(folder, entry, options.photos, sheet, options.output));
    }
    if (!sheet.empty()) sheet.save((fs::path(options.output) / "photos.png").string());
    return reports;
}

/// The outlined objects of the photographs, selected in the photographs at the size in which these are evaluated.
void selectInPhotos(const Options& options, Json& reports) {
    const Json list = evaluate::readJson(PATINA_SOURCE_DIR "/tests/evaluate/photos.json");
    for (const Json& entry : list.at("photos")) {
        const fs::path folder = fs::path(options.root) / "rgbd" / entry.at("folder").get<std::string>();
        const std::string name = entry.at("name");
        if (!fs::exists(folder) || (!options.scene.empty() && name != options.scene)) continue;
        progress("photo " + name + ": selection");
        try {
            reports.push_back(
                evaluate::selectionReport(evaluate::loadPhotoScene(folder, entry, options.photos.longerSide), name));
        } catch (const core::Error& error) {
            progress(error.what());
        }
    }
}

Json run(const Options& options) {
    Json evaluation = {{"commit", options.commit},   {"device", evaluate::newDevice().adapterInfo().name},
                       {"samples", options.samples}, {"analysis", Json::array()},
                       {"edits", Json::array()},     {"speed", Json::array()},
                       {"phone", Json::array()},     {"photos", Json::array()},
                       {"selection", Json::array()}};
    const fs::path output = options.output;
    evaluate::ContactSheet sheet(216, 216);
    evaluate::ContactSheet phoneSheet(240, 240);
    const std::vector<fs::path> folders = evaluate::findSceneFolders(options.root);
    for (const fs::path& path : folders) {
        if (!options.scene.empty() && path.filename() != options.scene) continue;
        evaluate::SceneFolder folder = evaluate::loadSceneFolder(path);
        folder.scene.render.samples = options.samples;
        if (options.has("speed")) {
            progress(folder.name + ": speed");
            for (Json& report : evaluate::speedReports(folder)) evaluation["speed"].push_back(std::move(report));
        }
        if (options.has("selection")) {
            progress(folder.name + ": selection");
            evaluation["selection"].push_back(evaluate::selectionReport(folder.scene, folder.name));
        }
        if (options.has("phone")) {
            progress(folder.name + ": phone");
            for (Json& report : evaluate::phoneReports(folder, options.edit, phoneSheet, output))
                evaluation["phone"].push_back(std::move(report));
        }
        core::AnalysisPipeline pipeline;
        if (options.has("analysis")) {
            progress(folder.name + ": analysis");
            evaluation["analysis"].push_back(evaluate::analysisReport(folder, pipeline));
            evaluate::saveSceneSheet(folder, *pipeline.run(folder.scene), output / (folder.name + ".png"));
        }
        if (!options.has("edits")) continue;
        for (const evaluate::Edit& edit : folder.edits) {
            if (!options.edit.empty() && edit.name != options.edit) continue;
            progress(folder.name + ": " + edit.name);
            const evaluate::EditPictures pictures = evaluate::renderEdit(folder, edit, pipeline);
            const Json report = evaluate::editReport(folder, edit, pictures);
            sheet.addRow(evaluate::editRow(folder, edit, pictures, report));
            evaluate::saveStrip(folder, edit, pictures, output / (folder.name + "_" + edit.name + ".png"));
            evaluation["edits"].push_back(report);
        }
    }
    if (!sheet.empty()) sheet.save((output / "contact_sheet.png").string());
    if (!phoneSheet.empty()) phoneSheet.save((output / "phone.png").string());
    if (options.has("photos")) evaluation["photos"] = evaluatePhotos(options);
    if (options.has("selection")) selectInPhotos(options, evaluation["selection"]);
    evaluation["targets"] = evaluate::judgeTargets(evaluation);
    return evaluation;
}

std::string markdown(const Json& evaluation) {
    std::ostringstream out;
    out << "Commit `" << evaluation.at("commit").get<std::string>() << "`, device "
        << evaluation.at("device").get<std::string>() << ", " << evaluation.at("samples").get<int>()
        << " paths per pixel.\n";
    evaluate::printTargets(out, evaluation.at("targets"));
    evaluate::printEdits(out, evaluation.at("edits"));
    evaluate::printPhone(out, evaluation.at("phone"));
    evaluate::printAnalysis(out, evaluation.at("analysis"));
    evaluate::printSpeed(out, evaluation.at("speed"));
    evaluate::printPhotos(out, evaluation.at("photos"));
    evaluate::printSelections(out, evaluation.at("selection"));
    return out.str();
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Compares Patina with path-traced ground truth.", "patina-evaluate");
    addOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    if (options.root.empty()) {
        const char* root = std::getenv("PATINA_REFERENCE_DATA");
        if (root == nullptr || *root == '\0') {
            progress("Skipped: PATINA_REFERENCE_DATA does not name a folder with reference scenes.");
            return 0;
        }
        options.root = root;
    }
    try {
        fs::create_directories(options.output);
        const Json evaluation = run(options);
        const std::string text = markdown(evaluation);
        std::ofstream(fs::path(options.output) / "evaluation.md") << text;
        std::ofstream(fs::path(options.output) / "evaluation.json") << evaluation.dump(1) << "\n";
        std::cout << text;
    } catch (const std::exception& error) {
        progress(error.what());
        return 1;
    }
    return 0;
}
