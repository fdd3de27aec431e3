// SPDX-License-Identifier: GPL-3.0-or-later
// `patina-cli brdf`: checks of BRDFs, built-in ones and those of files.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/devices.h"
#include "app/cli/session.h"
#include "core/material/brdf_file.h"
#include "render/kernels/brdf_check.h"

namespace cli {

namespace {

struct Checked {
    std::string name;
    std::vector<render::BrdfFinding> findings;
};

Checked check(const std::string& name, const gpu::Device& device) {
    if (const core::BrdfInfo* info = core::findBrdf(name)) return {name, render::checkBrdf(device, *info)};
    if (name.find_first_of("./") == std::string::npos) {
        std::string known;
        for (const core::BrdfInfo& info : core::brdfs()) known += std::string(info.key) + ", ";
        throw core::Error(core::ErrorKind::Usage,
                          "There is no BRDF \"" + name + "\"; known are: " + known + "and the names of files.");
    }
    const std::shared_ptr<const core::BrdfFile> file = core::loadBrdfFile(name);
    return {name, render::checkBrdf(device, file->info, file)};
}

void print(const Checked& checked) {
    std::printf("%s\n", checked.name.c_str());
    std::printf("  %-36s %6s %8s %8s %8s %8s %10s\n", "parameters", "angle", "chi² σ", "∫ pdf", "albedo", "sampled",
                "asymmetry");
    for (const render::BrdfFinding& f : checked.findings)
        std::printf("  %-36s %5.0f° %7.1f %7.4f %8.4f %8.4f %10.1e%s\n",
                    f.parameters.empty() ? "initial values" : f.parameters.c_str(), f.angle, f.deviation, f.density,
                    static_cast<double>(f.albedo.maxCoeff()), static_cast<double>(f.sampled.maxCoeff()), f.asymmetry,
                    f.problem.empty() ? "" : "  FAILS");
}

nlohmann::ordered_json toJson(const Checked& checked) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const render::BrdfFinding& f : checked.findings)
        list.push_back({{"parameters", f.parameters},
                        {"angle", f.angle},
                        {"chi_square_deviation", f.deviation},
                        {"density", f.density},
                        {"albedo", f.albedo.maxCoeff()},
                        {"sampled_albedo", f.sampled.maxCoeff()},
                        {"asymmetry", f.asymmetry},
                        {"problem", f.problem}});
    return {{"brdf", checked.name}, {"cases", list}};
}

void checkAll(std::vector<std::string> names, bool json, const Session& session) {
    if (names.empty())
        for (const core::BrdfInfo& info : core::brdfs()) names.emplace_back(info.key);
    const gpu::Device device = openDevice(session);
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    std::string problem;
    for (const std::string& name : names) {
        const Checked checked = check(name, device);
        if (json)
            document.push_back(toJson(checked));
        else
            print(checked);
        for (const render::BrdfFinding& f : checked.findings) {
            if (f.problem.empty() || !problem.empty()) continue;
            problem = name + ":" + std::to_string(f.line) + ": " + f.problem;
        }
    }
    if (json) std::cout << nlohmann::ordered_json{{"brdfs", document}}.dump(2) << '\n';
    if (!problem.empty()) throw core::Error(core::ErrorKind::Input, problem);
}

}  // namespace

void addBrdf(CLI::App& app, Session& session) {
    CLI::App* command = app.add_subcommand("brdf", "Check BRDFs, in particular those of .brdf.glsl files");
    command->require_subcommand(1);
    CLI::App* checkCommand = command->add_subcommand("check", "Check a BRDF over its parameters and angles");
    checkCommand->footer(
        "One row per set of parameters and view direction, with white colours:\n"
        "  chi² σ     samples against the density, in standard deviations: at most 6\n"
        "  ∫ pdf      integral of the density: at most 1, the rest is absorbed\n"
        "  albedo     reflected fraction of uniform white light: at most 1 (1 = white furnace)\n"
        "  sampled    the same fraction by sampling: has to agree with the albedo\n"
        "  asymmetry  |f(wo, wi) - f(wi, wo)| relative to the albedo: 0 for a reciprocal BRDF; informative only\n"
        "A BRDF that fails is an error (exit code 3) with the reason and, for a file, the line.");
    const auto names = std::make_shared<std::vector<std::string>>();
    const auto json = std::make_shared<bool>(false);
    checkCommand->add_option("brdf", *names, "Names or files [default: all built-in BRDFs]")->type_name("NAME|FILE");
    checkCommand->add_flag("--json", *json, "Print one JSON document");
    checkCommand->callback(
        [&session, names, json] { session.run = [&session, names, json] { checkAll(*names, *json, session); }; });
}

}  // namespace cli
