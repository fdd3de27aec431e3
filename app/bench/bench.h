// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/analysis/kernels.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "gpu/device.h"

namespace render {

/// One measured number, for example {"march", "rays_per_second.pyramid", 5.1e6, "1/s"}.
struct BenchResult {
    std::string name;
    std::string metric;
    double value = 0;
    std::string unit;
};

/// Names of all benchmarks in the order they run: march, reshade, quality, translucency, analyse,
/// select.
[[nodiscard]] const std::vector<std::string>& benchmarkNames();

/// Runs the named benchmarks (all of them when `names` is empty) on the device and returns their metrics
/// (docs/command-line.md). Metrics of algorithms that are not in this build are absent. `analyse` measures both twins:
/// seconds.* with `kernels`, cpu_seconds.* on the CPU and gpu_seconds.* on the device. Throws
/// core::Error(Usage) for an unknown name, Error(Input) when the scene has nothing to measure (no segment, no valid
/// depth), Error(Cancelled) when stopped.
[[nodiscard]] std::vector<BenchResult> runBenchmarks(const std::vector<std::string>& names, gpu::Device device,
                                                     const core::Scene& scene,
                                                     const std::shared_ptr<const core::Analysis>& analysis,
                                                     core::AnalysisKernels& kernels = core::cpuAnalysisKernels(),
                                                     const core::Progress& progress = {});

}  // namespace render
