// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <climits>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/bench/bench.h"
#include "app/cli/devices.h"
#include "app/cli/session.h"
#include "core/analysis/pipeline.h"
#include "gpu/adapter.h"

namespace cli {

namespace {

namespace fs = std::filesystem;

/// The bundled sample, beside an installed program or in the source tree of this build.
std::string bundledSample() {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    const fs::path sample = fs::path("samples") / "studio" / "studio.patina";
    for (const fs::path& folder :
         {program.parent_path().parent_path() / "share" / "patina", fs::path(PATINA_RESOURCES)})
        if (fs::exists(folder / sample, code)) return (folder / sample).string();
    throw core::Error(core::ErrorKind::Input, "The bundled sample \"" + sample.string() +
                                                  "\" is not installed; give a project with --project.");
}

/// One line per metric; times of CPU and device for the same work stand side by side.
void printTable(const std::vector<render::BenchResult>& results) {
    const std::string cpu = "cpu_seconds.";
    const std::string gpu = "gpu_seconds.";
    for (const render::BenchResult& result : results) {
        if (result.metric.starts_with(gpu)) continue;
        std::printf("%-14s %-28s %12.5g %s", result.name.c_str(), result.metric.c_str(), result.value,
                    result.unit.c_str());
        if (result.metric.starts_with(cpu)) {
            const auto twin =
                std::ranges::find(results, gpu + result.metric.substr(cpu.size()), &render::BenchResult::metric);
            if (twin != results.end()) std::printf("   %-24s %12.5g s", twin->metric.c_str(), twin->value);
        }
        std::printf("\n");
    }
}

void bench(const std::vector<std::string>& names, const std::string& project, bool json, const Session& session) {
    for (const std::string& name : names)
        if (std::ranges::find(render::benchmarkNames(), name) == render::benchmarkNames().end()) {
            std::string known;
            for (const std::string& other : render::benchmarkNames())
                known.append(known.empty() ? "" : ", ").append(other);
            throw core::Error(core::ErrorKind::Usage,
                              "There is no benchmark \"" + name + "\", expected " + known + ".");
        }
    const core::Scene scene = loadScene(project.empty() ? bundledSample() : project);
    const gpu::Device device = openDevice(session);
    const std::unique_ptr<core::AnalysisKernels> kernels = openAnalysisKernels(session);
    const core::Progress progress = printedProgress();
    const std::shared_ptr<const core::Analysis> analysis =
        core::AnalysisPipeline().run(scene, progress, kernels ? *kernels : core::cpuAnalysisKernels());
    const std::vector<render::BenchResult> results =
        render::runBenchmarks(names, device, scene, analysis, kernels ? *kernels : core::cpuAnalysisKernels(),
                              progress.of(core::Task::Benchmark));
    finishProgress();
    if (kernels) printNotes(kernels->takeNotes());
    if (json) {
        nlohmann::ordered_json document;
        document["device"] = device.adapterInfo().name;
        document["threads"] = std::thread::hardware_concurrency();
        document["results"] = nlohmann::ordered_json::array();
        for (const render::BenchResult& result : results)
            document["results"].push_back(
                {{"name", result.name}, {"metric", result.metric}, {"value", result.value}, {"unit", result.unit}});
        std::cout << document.dump(2) << '\n';
    } else {
        printTable(results);
    }
}

}  // namespace

void addBench(CLI::App& app, Session& session) {
    struct Arguments {
        std::vector<std::string> names;
        std::string project;
        bool json = false;
    };
    const auto args = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("bench", "Measure the speed of the method on this machine");
    command->footer("Benchmarks: march, reshade, quality, translucency, analyse, select [default: all].");
    command->add_option("names", args->names, "Benchmarks to run")->type_name("NAME");
    command->add_option("--project", args->project, "Measure on this project [default: the bundled sample]")
        ->type_name("P.patina");
    command->add_flag("--json", args->json, "Print one JSON document");
    command->callback([&session, args] {
        session.run = [&session, args] { bench(args->names, args->project, args->json, session); };
    });
}

}  // namespace cli
