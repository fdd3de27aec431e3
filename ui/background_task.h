// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <thread>

#include "core/base/progress.h"

namespace ui {

/// One piece of long work on a thread of its own: loading, saving, exporting. Signals arrive on the thread that made
/// the task. Destroying the task cancels the work and waits for it.
class BackgroundTask : public QObject {
    Q_OBJECT
  public:
    using Work = std::function<void(const core::Progress&)>;

    explicit BackgroundTask(Work work, QObject* parent = nullptr);
    ~BackgroundTask() override;

    void start();
    void cancel() { cancel_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool running() const { return running_; }

  signals:
    /// `fraction` in [0, 1]; at most some thirty times a second.
    void progress(const QString& step, double fraction);
    /// Exactly one of these three ends the task.
    void succeeded();
    void failed(const QString& sentence);
    void cancelled();

  private:
    Work work_;
    std::atomic<bool> cancel_ = false;
    bool running_ = false;
    std::thread thread_;
};

/// Progress function for core::Progress that lets at most one call in 30 ms through to `report`; any thread.
[[nodiscard]] core::Progress::Report throttledProgress(std::function<void(const QString&, double)> report);

}  // namespace ui
