// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/workspace.h"

namespace ui {

class ParamSlider;
struct ParamSpec;

/// A dock's content: shows a part of the workspace, sends edits to its document.
class Panel : public QWidget {
    Q_OBJECT
  public:
    explicit Panel(Workspace& workspace, QWidget* parent = nullptr) : QWidget(parent), workspace_(workspace) {}

  signals:
    /// A sentence for the status bar ("" takes it back) and one for an error dialog.
    void message(const QString& text);
    void error(const QString& sentence);

  protected:
    [[nodiscard]] Workspace& workspace() const { return workspace_; }

    /// Slider that edits the selected segment: dragging it makes one undo step named after its label.
    ParamSlider* addSegmentSlider(const ParamSpec& spec, std::function<void(core::Segment&, float)> set);
    /// Slider that edits the scene.
    ParamSlider* addSceneSlider(const ParamSpec& spec, std::function<void(core::Scene&, float)> set);

  private:
    Workspace& workspace_;
};

}  // namespace ui
