// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "core/base/error.h"

namespace core {

class AnalysisKernels;  // core/analysis/kernels.h
[[nodiscard]] AnalysisKernels& cpuAnalysisKernels();

/// How long work talks to whoever started it: progress out, cancellation in, and who computes the pieces a device may
/// take over. Every long loop calls `checkpoint` at least every few milliseconds. Thread-safe but for the kernels.
class StepContext {
  public:
    /// Called with the running step's name and its progress in [0, 1]; from any thread.
    using Progress = std::function<void(std::string_view step, float fraction)>;

    StepContext() = default;
    /// `kernels` have to outlive the work; nullptr = the CPU's.
    explicit StepContext(Progress progress, const std::atomic<bool>* cancel = nullptr,
                         AnalysisKernels* kernels = nullptr)
        : progress_(std::move(progress)), cancel_(cancel), kernels_(kernels) {}

    [[nodiscard]] bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }
    /// Reports progress and throws Error(Cancelled) when the user asked to stop.
    void checkpoint(std::string_view step, float fraction) const {
        if (cancelled()) throw Error(ErrorKind::Cancelled, "The work was cancelled.");
        if (progress_) progress_(step, fraction);
    }
    [[nodiscard]] AnalysisKernels& kernels() const { return kernels_ != nullptr ? *kernels_ : cpuAnalysisKernels(); }

  private:
    Progress progress_;
    const std::atomic<bool>* cancel_ = nullptr;
    AnalysisKernels* kernels_ = nullptr;
};

/// One piece of a step's work: its progress runs from `from` to `to` of the step.
struct StepPart {
    const StepContext& context;
    const char* step = "";
    float from = 0;
    float to = 1;
    void checkpoint(float fraction) const { context.checkpoint(step, from + fraction * (to - from)); }
};

}  // namespace core
