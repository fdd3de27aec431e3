// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/targets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "tests/evaluate/analysis_report.h"
#include "tests/evaluate/edit_report.h"
#include "tests/evaluate/markdown.h"
#include "tests/evaluate/speed_report.h"

namespace evaluate {

namespace {

/// The reference scenes' convex bodies.
constexpr std::array<std::string_view, 14> kConvex = {
    "chrome_ball", "orange_box", "teal_box",    "pink_cube",   "red_box", "blue_box", "green_box",
    "white_box",   "sphere",     "yellow_book", "purple_cube", "orange",  "lemon",    "ball"};

constexpr const char* kDefaultFill = "membrane";
constexpr const char* kFixedMethods[] = {"offset", "parallel_mirror", "pca_mirror", "spanned_mirror", "flat_faces"};

/// The largest of several values, and where it was found.
struct Worst {
    double value = -1;
    std::string where = "nothing to compare";
    int failed = 0;
    int count = 0;

    void add(double v, const std::string& place, double limit) {
        ++count;
        if (!(v <= limit)) ++failed;
        if (v > value || !std::isfinite(v)) value = v, where = place;
    }
    [[nodiscard]] bool met() const { return count > 0 && failed == 0; }
    [[nodiscard]] std::string tally() const {
        return std::to_string(count - failed) + " of " + std::to_string(count) + " within";
    }
};

void add(Json& targets, const std::string& target, const std::string& reached, bool met) {
    targets.push_back({{"target", target}, {"reached", reached}, {"met", met}});
}

std::string place(const Json& report, const std::string& name = "") {
    const std::string scene = report.at("scene");
    return name.empty() ? scene : scene + "/" + name;
}

void judgeNormals(Json& targets, const Json& reports) {
    constexpr struct {
        const char *depth, *title;
        double limit;
    } kLimits[] = {{"exact", "exact depth", 2}, {"noisy", "noisy depth", 5}};
    for (const auto& [depth, title, limit] : kLimits) {
        Worst worst;
        for (const Json& report : reports)
            worst.add(report.at("normals").at(kAllButTable).at(depth).at("filtered").at("median"), place(report),
                      limit);
        add(targets, std::string("Normals on ") + title + ": median ≤ " + fixed(limit, 0) + "° (all but the table)",
            "at most " + fixed(worst.value, 2) + "° (" + worst.where + ")", worst.met());
    }
    Worst worst;  // error of noisy normals with the filter relative to without; at most 1 if it helps
    for (const Json& report : reports) {
        const Json& noisy = report.at("normals").at(kAllButTable).at("noisy");
        const double before = noisy.at("unfiltered").at("median");
        worst.add(noisy.at("filtered").at("median").get<double>() / before, place(report), 1);
    }
    add(targets, "The filter helps on all scenes: median normal error after it below that before",
        "at most " + fixed(worst.value, 2) + " of it (" + worst.where + ")", worst.met());
}

void judgeAreas(Json& targets, const Json& reports) {
    Worst scenes, segments;
    for (const Json& report : reports) {
        for (const auto& [name, error] : report.at("areas").items()) {
            const bool total = name == kAll || name == kAllButTable;
            (total ? scenes : segments).add(std::abs(error.get<double>()), place(report, name), 0.02);
        }
    }
    add(targets, "Patch areas: total within 2 %",
        "at most " + percent(scenes.value, 2) + " (" + scenes.where + "); segments: " + segments.tally() +
            ", at most " + percent(segments.value, 2) + " (" + segments.where + ")",
        scenes.met());
}

void judgeBackSides(Json& targets, const Json& reports) {
    Worst convex, choice;
    for (const Json& report : reports) {
        for (const auto& [name, entry] : report.at("back_sides").items()) {
            if (name == kTable) continue;
            const double automatic = entry.at("automatic").at("median");
            if (std::ranges::find(kConvex, name) != kConvex.end()) convex.add(automatic, place(report, name), 0.1);
            double best = std::numeric_limits<double>::infinity();
            for (const char* method : kFixedMethods) best = std::min(best, entry.at(method).at("median").get<double>());
            choice.add(automatic / best, place(report, name), 1.1);
        }
    }
    add(targets, "Back sides of convex objects, automatic: median error ≤ 10 % of the thickness",
        convex.tally() + ", at most " + percent(convex.value) + " (" + convex.where + ")", convex.met());
    add(targets, "The automatic choice is never worse than the best fixed method by 10 % (all but the table)",
        choice.tally() + ", at most " + fixed(choice.value, 2) + " times the best (" + choice.where + ")",
        choice.met());
}

void judgeReflectances(Json& targets, const Json& reports) {
    Worst worst;
    for (const Json& report : reports)
        for (const auto& [name, entry] : report.at("reflectance").items())
            for (const Json& error : entry.at("error"))
                worst.add(std::abs(error.get<double>()), place(report, name), 0.1);
    add(targets, "Reflectance: within 10 % per channel",
        worst.tally() + ", at most " + percent(worst.value) + " (" + worst.where + ")", worst.met());
}

void judgeEnvironments(Json& targets, const Json& reports) {
    constexpr double kSharpAlpha = 0.1;
    Worst worst;
    for (const Json& report : reports) {
        bool sharp = !report.at("reflectance").empty();
        for (const auto& entry : report.at("reflectance")) sharp = sharp && entry.at("true_alpha") <= kSharpAlpha;
        if (!sharp) continue;
        worst.add(report.at("environment").at(kDefaultFill).at("observed").at("median_error"), place(report), 0.15);
    }
    add(targets, "Environment: median relative error of observed directions ≤ 15 % for alpha ≤ 0.1",
        "at most " + percent(worst.value) + " (" + worst.where + ")", worst.met());
}

void judgeEdits(Json& targets, const Json& edits) {
    const double loss = meanOverEdits(edits, "true_light_and_back", "psnr") - meanOverEdits(edits, "ours", "psnr");
    add(targets, "Ours loses at most 2 dB against true light and back side, mean over edits",
        fixed(loss, 2) + " dB over " + std::to_string(edits.size()) + " edits", loss <= 2);
}

void judgeSpeed(Json& targets, const Json& reports) {
    for (const Json& report : reports) {
        const bool limited = report.contains("limit_seconds");
        if (!limited) continue;
        const double seconds = report.at("seconds").at("total");
        const double limit = report.at("limit_seconds");
        std::string target = "Analysis of " + report.at("case").get<std::string>() + ": ≤ " + fixed(limit, 0) + " s";
        std::string reached = fixed(seconds, 2) + " s";
        bool met = seconds <= limit;
        if (report.contains("limit_bytes")) {
            target += " and ≤ " + gibibytes(report.at("limit_bytes"));
            reached += ", " + gibibytes(report.at("peak_bytes"));
            met = met && report.at("peak_bytes") <= report.at("limit_bytes");
        }
        add(targets, target, reached, met);
    }
}

void judgeSelections(Json& targets, const Json& reports) {
    constexpr int kTargetClicks = 8;
    double clicks = 0, distance = 0;
    int objects = 0, single = 0, tooMany = 0, found = 0;
    for (const Json& report : reports)
        for (const Json& object : report.at("objects")) {
            const int count = object.at("clicks");
            clicks += count;
            ++objects;
            single += count == 1 ? 1 : 0;
            tooMany += count > kTargetClicks ? 1 : 0;
            if (!object.at("outline_distance").is_number()) continue;
            distance += object.at("outline_distance").get<double>();
            ++found;
        }
    if (objects == 0) return;
    const std::string of = " of " + std::to_string(objects) + " objects";
    add(targets, "Selection: at most 3.25 clicks to 90 % overlap, mean over objects", fixed(clicks / objects, 2),
        clicks <= 3.25 * objects);
    add(targets, "Selection: at least 70 % of the objects with one click", std::to_string(single) + of,
        single >= 0.7 * objects);
    add(targets, "Selection: no object needs more than 8 clicks", std::to_string(tooMany) + of, tooMany == 0);
    add(targets, "Selection: outline within 1.5 px of the true one, mean", fixed(distance / found, 2) + " px",
        distance <= 1.5 * found);
}

}  // namespace

Json judgeTargets(const Json& evaluation) {
    Json targets = Json::array();
    if (const Json& reports = evaluation.at("analysis"); !reports.empty()) {
        judgeNormals(targets, reports);
        judgeAreas(targets, reports);
        judgeBackSides(targets, reports);
        judgeReflectances(targets, reports);
        judgeEnvironments(targets, reports);
    }
    if (const Json& edits = evaluation.at("edits"); !edits.empty()) judgeEdits(targets, edits);
    judgeSpeed(targets, evaluation.at("speed"));
    judgeSelections(targets, evaluation.at("selection"));
    return targets;
}

void printTargets(std::ostream& out, const Json& targets) {
    if (targets.empty()) return;
    out << "\n### Targets\n\n";
    Table table(out, {"target", "reached", "met"});
    for (const Json& target : targets)
        table.row({target.at("target"), target.at("reached"), target.at("met").get<bool>() ? "yes" : "**no**"});
}

}  // namespace evaluate
