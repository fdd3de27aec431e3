// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/background_task.h"

#include <chrono>
#include <memory>
#include <utility>

#include "ui/words.h"

namespace ui {

core::Progress::Report throttledProgress(std::function<void(const QString&, double)> report) {
    using Clock = std::chrono::steady_clock;
    constexpr std::int64_t kIntervalMs = 30;
    auto last = std::make_shared<std::atomic<std::int64_t>>(0);
    return [last, report = std::move(report)](core::Task task, float fraction) {
        const std::int64_t now =
            std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now().time_since_epoch()).count();
        std::int64_t before = last->load();
        if (now - before < kIntervalMs || !last->compare_exchange_strong(before, now)) return;
        report(taskName(task), static_cast<double>(fraction));
    };
}

BackgroundTask::BackgroundTask(Work work, QObject* parent) : QObject(parent), work_(std::move(work)) {}

BackgroundTask::~BackgroundTask() {
    cancel();
    if (thread_.joinable()) thread_.join();
}

void BackgroundTask::start() {
    running_ = true;
    thread_ = std::thread([this] {
        enum class End { Succeeded, Failed, Cancelled } end = End::Succeeded;
        QString sentence;
        try {
            work_(core::Progress(
                throttledProgress([this](const QString& step, double fraction) { emit progress(step, fraction); }),
                &cancel_));
        } catch (const core::Error& error) {
            end = error.kind() == core::ErrorKind::Cancelled ? End::Cancelled : End::Failed;
            sentence = translated(error);
        } catch (const std::exception& error) {
            end = End::Failed;
            sentence = translated(error);
        }
        QMetaObject::invokeMethod(
            this,
            [this, end, sentence] {
                running_ = false;
                if (end == End::Succeeded) emit succeeded();
                if (end == End::Failed) emit failed(sentence);
                if (end == End::Cancelled) emit cancelled();
            },
            Qt::QueuedConnection);
    });
}

}  // namespace ui
