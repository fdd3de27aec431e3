// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/error.h"

namespace core {

/// Kind of long work. An identity, not a text: ui/words.h and app/cli/words.h hold its names for people.
enum class Task {
    Working,
    LoadPhoto,
    FindRegions,
    RecoverDepth,
    ComputeNormals,
    InventBackSides,
    BuildDepthLayers,
    EstimateReflectance,
    RecoverEnvironment,
    SeparateTexture,
    Render,
    FilterPicture,
    SumDiffusion,
    Benchmark,
};

/// Connects long work with its caller: progress out, cancellation in. Cheap to copy; each part of the work gets a part
/// of the progress. Every long loop calls `checkpoint` at least every few milliseconds. Thread-safe.
class Progress {
  public:
    /// Receives the current task and its progress in [0, 1]; called from any thread.
    using Report = std::function<void(Task, float)>;

    /// Reports nothing and cannot be cancelled.
    Progress() = default;
    /// `cancel` must outlive the work; nullptr = cannot be cancelled.
    explicit Progress(Report report, const std::atomic<bool>* cancel = nullptr)
        : report_(report ? std::make_shared<const Report>(std::move(report)) : nullptr), cancel_(cancel) {}

    /// Progress of one task by itself, from 0 to 1.
    [[nodiscard]] Progress of(Task task) const {
        Progress result = *this;
        result.task_ = task;
        result.from_ = 0;
        result.to_ = 1;
        return result;
    }
    /// The part [from, to] of this progress, itself running from 0 to 1.
    [[nodiscard]] Progress part(float from, float to) const {
        Progress result = *this;
        result.from_ = from_ + from * (to_ - from_);
        result.to_ = from_ + to * (to_ - from_);
        return result;
    }

    [[nodiscard]] bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }
    /// Reports `fraction` in [0, 1] and throws Error(Cancelled) when the user asked to stop.
    void checkpoint(float fraction) const {
        if (cancelled()) throw Error(ErrorKind::Cancelled, Message("messages", "The work was cancelled."));
        if (report_) (*report_)(task_, from_ + fraction * (to_ - from_));
    }

  private:
    std::shared_ptr<const Report> report_;
    const std::atomic<bool>* cancel_ = nullptr;
    Task task_ = Task::Working;
    float from_ = 0;
    float to_ = 1;
};

}  // namespace core
