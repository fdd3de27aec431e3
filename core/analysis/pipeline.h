// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include "core/analysis/analysis.h"
#include "core/analysis/kernels.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace core {

/// Runs the analysis steps (listed in pipeline.cpp). Keeps their results by the hash of each step's inputs and
/// parameters, so that a second run recomputes only what changed. One thread at a time.
class AnalysisPipeline {
  public:
    AnalysisPipeline();
    ~AnalysisPipeline();
    AnalysisPipeline(const AnalysisPipeline&) = delete;
    AnalysisPipeline& operator=(const AnalysisPipeline&) = delete;

    /// Throws Error(Cancelled) when the progress asks to stop (the cache stays valid) and Error(Input) when the scene
    /// cannot be analysed (no valid depth at all).
    [[nodiscard]] std::shared_ptr<const Analysis> run(const Scene& scene, const Progress& progress = {},
                                                      AnalysisKernels& kernels = cpuAnalysisKernels());

    /// Number of times each step has run: shows what a change recomputed.
    using RunCounts = std::map<Task, int>;
    [[nodiscard]] const RunCounts& runCounts() const;

  private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

}  // namespace core
