// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/analysis_worker.h"

#include <utility>

#include "ui/background_task.h"
#include "ui/words.h"

namespace ui {

AnalysisWorker::AnalysisWorker(QObject* parent) : QObject(parent) {
    qRegisterMetaType<std::shared_ptr<const AnalysisResult>>("std::shared_ptr<const ui::AnalysisResult>");
    thread_ = std::thread([this] { loop(); });
}

AnalysisWorker::~AnalysisWorker() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
        waiting_.reset();
        cancel_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void AnalysisWorker::request(std::uint64_t generation, const core::Scene& scene) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = Request{generation, scene};
        if (current_ != nullptr && current_ != scene.photo) cancel_ = true;
    }
    wake_.notify_one();
}

void AnalysisWorker::cancel() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    cancel_ = true;
}

void AnalysisWorker::loop() {
    for (;;) {
        Request request;
        {
            std::unique_lock lock(mutex_);
            current_.reset();
            wake_.wait(lock, [this] { return quit_ || waiting_.has_value(); });
            if (quit_) return;
            request = std::move(*waiting_);
            waiting_.reset();
            current_ = request.scene.photo;
            cancel_ = false;
        }
        analyse(request);
    }
}

void AnalysisWorker::analyse(const Request& request) {
    const auto report =
        throttledProgress([this](const QString& step, double fraction) { emit progress(step, fraction); });
    try {
        if (makeKernels_) {
            kernels_ = makeKernels_();
            makeKernels_ = {};
        }
        auto result = std::make_shared<AnalysisResult>();
        result->generation = request.generation;
        result->scene = request.scene;
        result->analysis = pipeline_.run(request.scene, core::Progress(report, &cancel_),
                                         kernels_ ? *kernels_ : core::cpuAnalysisKernels());
        if (kernels_) result->notes = kernels_->takeNotes();
        emit finished(std::move(result));
    } catch (const core::Error& error) {
        if (error.kind() != core::ErrorKind::Cancelled) emit failed(request.generation, translated(error));
    } catch (const std::exception& error) {
        emit failed(request.generation, translated(error));
    }
}

}  // namespace ui
