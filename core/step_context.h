// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "core/error.h"

namespace core {

/// How long work talks to whoever started it: progress out, cancellation in. Every long loop calls `checkpoint` at
/// least every few milliseconds. Thread-safe.
class StepContext {
  public:
    /// Called with the running step's name and its progress in [0, 1]; from any thread.
    using Progress = std::function<void(std::string_view step, float fraction)>;

    StepContext() = default;
    explicit StepContext(Progress progress, const std::atomic<bool>* cancel = nullptr)
        : progress_(std::move(progress)), cancel_(cancel) {}

    [[nodiscard]] bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }
    /// Reports progress and throws Error(Cancelled) when the user asked to stop.
    void checkpoint(std::string_view step, float fraction) const {
        if (cancelled()) throw Error(ErrorKind::Cancelled, "The work was cancelled.");
        if (progress_) progress_(step, fraction);
    }

  private:
    Progress progress_;
    const std::atomic<bool>* cancel_ = nullptr;
};

}  // namespace core
