// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene/params.h"
#include "ui/workspace.h"

class QBoxLayout;

namespace ui {

class ParamControl;
class ParamSlider;
struct ParamSpec;

/// A dock's content: shows a part of the workspace, sends edits to its document.
class Panel : public QWidget {
    Q_OBJECT
  public:
    explicit Panel(Workspace& workspace, QWidget* parent = nullptr) : QWidget(parent), workspace_(workspace) {}

  signals:
    /// A sentence for the status bar ("" clears it) and one for an error dialog.
    void message(const QString& text);
    void error(const QString& sentence);
    /// What the panel's last change has to say, for the list of notices; empty takes the former ones back.
    void notices(const QStringList& sentences);

  protected:
    [[nodiscard]] Workspace& workspace() const { return workspace_; }

    /// Appends the controls of a group of parameters (core/scene/params.h), in the order of the table. Each edits the
    /// selected segment or the scene; successive changes of one control are one undo step.
    void addControls(core::ParamGroup group, QBoxLayout* layout);
    /// Shows the scene in them. Enables those of segments while one is selected, the others while a photograph is open.
    void refreshControls();
    /// The control of a parameter that was added.
    [[nodiscard]] ParamControl* control(std::string_view key) const;

    /// Slider that edits the selected segment: dragging it makes one undo step named after its label.
    ParamSlider* addSegmentSlider(const ParamSpec& spec, std::function<void(core::Segment&, float)> set);

  private:
    template <class Owner>
    using Controls = std::vector<std::pair<const core::Param<Owner>*, ParamControl*>>;
    /// Appends a control without its connections.
    ParamControl* addControl(const core::ParamRow& row, QBoxLayout* layout);

    Workspace& workspace_;
    Controls<core::Segment> segmentControls_;
    Controls<core::Scene> sceneControls_;
};

}  // namespace ui
