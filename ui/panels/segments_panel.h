// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/panels/panel.h"

class QLabel;

namespace ui {

class SegmentActions;
class SegmentModel;
class SegmentView;

/// The list of segments with what can be done to them, and what to do next. The current row is the workspace's selected
/// segment; actions are about all selected rows.
class SegmentsPanel : public Panel {
    Q_OBJECT
  public:
    explicit SegmentsPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] SegmentActions& actions() { return *actions_; }

  private:
    void makeButtons(QBoxLayout& layout);
    void connectList();
    void connectActions();
    void refresh();
    void showSelection(quint16 label);
    /// The user has selected rows.
    void rowsChanged();
    /// Selects rows, the first one as current, without telling the workspace.
    void choose(const std::vector<std::uint16_t>& labels);
    void showMenu(const QPoint& place);
    void refreshHint();
    /// What to do next, in one sentence; "" = nothing.
    [[nodiscard]] QString hint();
    /// What the analysis has to say about glossy segments.
    [[nodiscard]] QString glossyHint();

    SegmentModel* model_ = nullptr;
    SegmentView* list_ = nullptr;
    SegmentActions* actions_ = nullptr;
    QLabel* hint_ = nullptr;
    bool refreshing_ = false;  ///< rows are selected that the user has not
    bool choosing_ = false;    ///< the list selects a segment in the workspace
    /// The last answer of glossyHint() and what it depends on.
    struct {
        std::weak_ptr<const core::Analysis> analysis;
        std::weak_ptr<const core::Photo> photo;
        std::vector<std::pair<std::string, bool>> glossy;  ///< names, and whether their reflectance is given
        QString hint;
    } known_;
};

}  // namespace ui
