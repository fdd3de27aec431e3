// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/devices.h"

#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/session.h"
#include "core/analysis/pipeline.h"
#include "gpu/instance.h"
#include "render/analysis/gpu_analysis_kernels.h"

namespace cli {

namespace {

const char* typeName(gpu::AdapterType type) {
    switch (type) {
        case gpu::AdapterType::DiscreteGPU:
            return "discrete";
        case gpu::AdapterType::IntegratedGPU:
            return "integrated";
        case gpu::AdapterType::VirtualGPU:
            return "virtual";
        case gpu::AdapterType::CPU:
            return "software";
        case gpu::AdapterType::Unknown:
            return "unknown";
    }
    return "unknown";
}

void listDevices(bool json) {
    const gpu::Instance instance = gpu::Instance::create();
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const gpu::Adapter& adapter : instance.adapters()) {
        const gpu::AdapterInfo& info = adapter.info();
        const std::string version = std::to_string(info.apiVersionMajor) + "." + std::to_string(info.apiVersionMinor);
        if (!json)
            std::printf("%zu  %s (%s, Vulkan %s, %s)\n", list.size(), info.name.c_str(), typeName(info.type),
                        version.c_str(), info.driver.c_str());
        list.push_back({{"index", list.size()},
                        {"name", info.name},
                        {"type", typeName(info.type)},
                        {"vendor", info.vendor},
                        {"driver", info.driver},
                        {"vulkan", version}});
    }
    if (json) std::cout << nlohmann::ordered_json{{"devices", list}}.dump(2) << '\n';
    if (list.empty()) throw gpu::Error(gpu::ErrorKind::NoAdapter, "There is no graphics device with Vulkan 1.1.");
}

}  // namespace

gpu::Device openDevice(const Session& session) {
    const gpu::Adapter adapter = gpu::Instance::create().requestAdapter({.device = session.device});
    std::fprintf(stderr, "patina-cli: Rendering on %s.\n", adapter.info().name.c_str());
    return adapter.requestDevice({.label = "patina-cli"});
}

std::unique_ptr<core::AnalysisKernels> openAnalysisKernels(const Session& session) {
    return render::createAnalysisKernels(session.analysis.empty()
                                             ? render::analysisTwinFromEnvironment()
                                             : render::parseAnalysisTwin(session.analysis, "--analysis"),
                                         session.device);
}

std::shared_ptr<const core::Analysis> analyse(const core::Scene& scene, const Session& session) {
    const std::unique_ptr<core::AnalysisKernels> kernels = openAnalysisKernels(session);
    auto analysis =
        core::AnalysisPipeline().run(scene, printedProgress(), kernels ? *kernels : core::cpuAnalysisKernels());
    finishProgress();
    if (kernels) printNotes(kernels->takeNotes());
    return analysis;
}

void addDevices(CLI::App& app, Session& session) {
    const auto json = std::make_shared<bool>(false);
    CLI::App* command = app.add_subcommand("devices", "List the usable graphics devices");
    command->footer("--device takes the number or a part of the name.");
    command->add_flag("--json", *json, "Print one JSON document");
    command->callback([&session, json] { session.run = [json] { listDevices(*json); }; });
}

}  // namespace cli
