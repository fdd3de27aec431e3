// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

namespace core {

class AnalysisKernels;  // core/analysis/kernels.h
[[nodiscard]] AnalysisKernels& cpuAnalysisKernels();

/// What a step works with: how it reports and is cancelled, and who computes its data-parallel parts.
struct StepContext {
    Progress progress = {};
    AnalysisKernels& kernels = cpuAnalysisKernels();
    [[nodiscard]] StepContext part(float from, float to) const { return {progress.part(from, to), kernels}; }
};

}  // namespace core
