// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

namespace core {

class AnalysisKernels;  // core/analysis/kernels.h
[[nodiscard]] AnalysisKernels& cpuAnalysisKernels();

/// Environment of a running step: its progress, through which it is cancelled, and the kernels for its expensive parts.
struct StepContext {
    Progress progress = {};
    AnalysisKernels& kernels = cpuAnalysisKernels();
    [[nodiscard]] StepContext part(float from, float to) const { return with(progress.part(from, to)); }
    /// The same kernels with another progress.
    [[nodiscard]] StepContext with(const Progress& other) const { return {other, kernels}; }
};

}  // namespace core
