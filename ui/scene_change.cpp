// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_change.h"

#include <QProgressDialog>
#include <utility>

#include "ui/background_task.h"
#include "ui/words.h"
#include "ui/workspace.h"

namespace ui {

namespace {

/// Work that takes less shows no dialog [ms].
constexpr int kDialogDelay = 500;

}  // namespace

struct SceneChange::Request {
    QString step;
    Operation operation;
    Done done;
};

struct SceneChange::Result {
    core::Scene scene;
    core::Notes notes;
};

SceneChange::SceneChange(Workspace& workspace, QWidget* owner) : QObject(owner), workspace_(workspace), owner_(owner) {
    connect(&workspace, &Workspace::documentReplaced, this, &SceneChange::drop);
}

SceneChange::~SceneChange() = default;

bool SceneChange::running() const { return task_ != nullptr; }

void SceneChange::run(const QString& step, Operation operation, Done done) {
    if (!workspace_.hasPhoto()) return;
    if (running()) {
        emit message(tr("Please wait until the last change of the segments is made."));
        return;
    }
    const Request request{step, std::move(operation), std::move(done)};
    if (workspace_.scene().photo->labels.size() > kAtOnce) {
        start(std::make_shared<const Request>(request));
        return;
    }
    core::Notes notes;
    core::Scene changed;
    try {
        changed = request.operation(workspace_.scene(), &notes, {});
    } catch (const std::exception& problem) {
        emit failed(translated(problem));
        return;
    }
    finish(request, std::move(changed), notes);
}

void SceneChange::start(const std::shared_ptr<const Request>& request) {
    const auto result = std::make_shared<Result>();
    task_ =
        std::make_unique<BackgroundTask>([result, request, scene = workspace_.scene()](const core::Progress& progress) {
            result->scene = request->operation(scene, &result->notes, progress);
            // Operations that do not look whether they are cancelled are not made all the same.
            progress.checkpoint(1);
        });
    dialog_ = new QProgressDialog(request->step, tr("Cancel"), 0, 0, owner_->window());
    dialog_->setObjectName(QStringLiteral("changeProgress"));
    dialog_->setWindowTitle(tr("Patina"));
    dialog_->setWindowModality(Qt::WindowModal);
    dialog_->setMinimumDuration(kDialogDelay);
    dialog_->setAutoClose(false);
    dialog_->setAutoReset(false);
    dialog_->setValue(0);
    connect(dialog_, &QProgressDialog::canceled, task_.get(), &BackgroundTask::cancel);
    connect(task_.get(), &BackgroundTask::progress, dialog_, [this](const QString&, double fraction) {
        constexpr int kWhole = 1000;
        if (dialog_->wasCanceled()) return;
        dialog_->setMaximum(kWhole);
        dialog_->setValue(static_cast<int>(fraction * kWhole));
    });
    connect(task_.get(), &BackgroundTask::succeeded, this,
            [this, request, result, revision = workspace_.document().revision()] {
                end();
                // What was changed meanwhile stays: the step is made again, from there.
                if (revision != workspace_.document().revision())
                    start(request);
                else
                    finish(*request, std::move(result->scene), result->notes);
            });
    connect(task_.get(), &BackgroundTask::failed, this, [this](const QString& sentence) {
        const QString text = sentence;
        end();
        emit failed(text);
    });
    connect(task_.get(), &BackgroundTask::cancelled, this, [this] {
        end();
        emit message(tr("Cancelled."));
    });
    task_->start();
    emit stateChanged();
}

void SceneChange::finish(const Request& request, core::Scene changed, const core::Notes& notes) {
    const core::Scene before = workspace_.scene();
    workspace_.editScene(request.step, [&](core::Scene& scene) { scene = std::move(changed); });
    request.done(before, notes);
}

void SceneChange::end() {
    if (dialog_ != nullptr) dialog_->deleteLater();
    dialog_ = nullptr;
    // Its own signal is being handled.
    task_.release()->deleteLater();
    emit stateChanged();
}

void SceneChange::drop() {
    if (!running()) return;
    task_->disconnect(this);
    if (dialog_ != nullptr) delete dialog_;
    task_.reset();
    emit stateChanged();
}

}  // namespace ui
