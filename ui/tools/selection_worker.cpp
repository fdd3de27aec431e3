// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/selection_worker.h"

#include <utility>

#include "ui/background_task.h"
#include "ui/words.h"

namespace ui {

SelectionWorker::SelectionWorker(QObject* parent) : QObject(parent) {
    thread_ = std::thread([this] { loop(); });
}

SelectionWorker::~SelectionWorker() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
        cancelPreparation_ = true;
        cancelChange_ = true;
        cancelPreview_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void SelectionWorker::setPhoto(const std::shared_ptr<const core::Photo>& photo) {
    const bool same = photo != nullptr && photo_ != nullptr && photo->color.shares(photo_->color) &&
                      photo->depth.shares(photo_->depth);
    photo_ = photo;
    if (same) return;
    {
        const std::lock_guard lock(mutex_);
        ++photoNumber_;
        ++previewNumber_;
        wanted_ = photo;
        changes_.clear();
        preview_.reset();
        cancelPreparation_ = true;
        cancelChange_ = true;
        cancelPreview_ = true;
    }
    prepared_ = false;
    unfinished_ = photo != nullptr ? 1 : 0;
    emit stateChanged();
    wake_.notify_one();
}

void SelectionWorker::change(Work work, Done done) {
    dropPreview();
    {
        const std::lock_guard lock(mutex_);
        changes_.push_back({std::move(work), std::move(done), photoNumber_});
    }
    ++unfinished_;
    emit stateChanged();
    wake_.notify_one();
}

void SelectionWorker::preview(Work work, Done done) {
    {
        const std::lock_guard lock(mutex_);
        const std::uint64_t number = ++previewNumber_;
        const auto shown = [this, number, done = std::move(done)] {
            if (number == previewNumber_) done();
        };
        preview_ = Job{std::move(work), shown, photoNumber_};
        cancelPreview_ = true;
    }
    wake_.notify_one();
}

void SelectionWorker::dropPreview() {
    const std::lock_guard lock(mutex_);
    ++previewNumber_;
    preview_.reset();
    cancelPreview_ = true;
}

void SelectionWorker::cancel() {
    const std::lock_guard lock(mutex_);
    unfinished_ -= static_cast<int>(changes_.size());
    changes_.clear();
    cancelChange_ = true;
}

bool SelectionWorker::changing() const { return unfinished_ > (prepared_ ? 0 : 1); }

void SelectionWorker::loop() {
    for (;;) {
        std::shared_ptr<const core::Photo> photo;
        std::optional<Job> job;
        bool isPreview = false;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock,
                       [this] { return quit_ || wanted_ != nullptr || !changes_.empty() || preview_.has_value(); });
            if (quit_) return;
            number = photoNumber_;
            if (wanted_ != nullptr) {
                photo = std::exchange(wanted_, nullptr);
                cancelPreparation_ = false;
            } else if (!changes_.empty()) {
                job = std::move(changes_.front());
                changes_.pop_front();
                cancelChange_ = false;
            } else {
                job = std::exchange(preview_, std::nullopt);
                isPreview = true;
                cancelPreview_ = false;
            }
        }
        if (photo != nullptr)
            prepare(photo, number);
        else
            run(std::move(*job), isPreview);
    }
}

core::Progress SelectionWorker::progressOf(std::atomic<bool>& cancel) {
    return core::Progress(
               throttledProgress([this](const QString& step, double fraction) { emit progress(step, fraction); }),
               &cancel)
        .of(core::Task::FindRegions);
}

void SelectionWorker::prepare(const std::shared_ptr<const core::Photo>& photo, std::uint64_t number) {
    selector_.reset();
    QString problem;
    try {
        selector_.emplace(core::SelectionInput{photo->color, photo->depth, photo->camera, photo->depthSampleSpacing},
                          progressOf(cancelPreparation_));
    } catch (const core::Error& error) {
        if (error.kind() == core::ErrorKind::Cancelled) return;
        problem = translated(error);
    } catch (const std::exception& error) {
        problem = translated(error);
    }
    finish([this, number, problem] {
        if (number != photoNumber_) return;
        --unfinished_;
        prepared_ = problem.isEmpty();
        emit stateChanged();
        if (!problem.isEmpty()) emit failed(problem);
    });
}

void SelectionWorker::run(Job job, bool isPreview) {
    QString problem;
    bool ended = false;
    try {
        if (selector_) {
            job.work(*selector_, isPreview ? core::Progress(nullptr, &cancelPreview_) : progressOf(cancelChange_));
            ended = true;
        }
    } catch (const core::Error& error) {
        if (error.kind() != core::ErrorKind::Cancelled) problem = translated(error);
    } catch (const std::exception& error) {
        problem = translated(error);
    }
    finish([this, job = std::move(job), isPreview, ended, problem] {
        if (job.photoNumber != photoNumber_) return;
        if (!isPreview) --unfinished_;
        if (ended) job.done();
        if (!isPreview && !problem.isEmpty()) emit failed(problem);
        if (!isPreview) emit stateChanged();
    });
}

void SelectionWorker::finish(const std::function<void()>& then) {
    QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
}

}  // namespace ui
