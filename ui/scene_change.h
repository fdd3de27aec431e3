// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

class QProgressDialog;
class QWidget;

namespace ui {

class BackgroundTask;
class Workspace;

/// Changes of the label map, one at a time, each one undo step. Those of small photographs are made at once, others on
/// a thread of their own, with a dialog for progress and cancellation when they take long.
class SceneChange : public QObject {
    Q_OBJECT
  public:
    /// Largest photograph whose labels are changed at once [px].
    static constexpr std::size_t kAtOnce = std::size_t{1} << 20U;

    /// Makes the changed scene; may be called from any thread, and again when something else changed the scene first.
    using Operation =
        std::function<core::Scene(const core::Scene& scene, core::Notes* notes, const core::Progress& progress)>;
    /// Called when the step has been made, with the scene before it.
    using Done = std::function<void(const core::Scene& before, const core::Notes& notes)>;

    /// `owner` is the widget over whose window the dialog appears.
    SceneChange(Workspace& workspace, QWidget* owner);
    ~SceneChange() override;

    /// Makes a step called `step`; refuses with a message while another one is being made.
    void run(const QString& step, Operation operation, Done done);
    [[nodiscard]] bool running() const;

  signals:
    void message(const QString& text);
    /// Why a step was not possible.
    void failed(const QString& sentence);
    /// `running` has another value.
    void stateChanged();

  private:
    struct Request;
    struct Result;
    void start(const std::shared_ptr<const Request>& request);
    void finish(const Request& request, core::Scene changed, const core::Notes& notes);
    void end();
    void drop();

    Workspace& workspace_;
    QWidget* owner_;
    std::unique_ptr<BackgroundTask> task_;
    QPointer<QProgressDialog> dialog_;
};

}  // namespace ui
