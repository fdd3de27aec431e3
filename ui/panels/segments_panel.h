// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/panel.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace ui {

/// The list of segments: colour, name (editable), glossy flag, edited mark. Its current row is the selection.
class SegmentsPanel : public Panel {
    Q_OBJECT
  public:
    explicit SegmentsPanel(Workspace& workspace, QWidget* parent = nullptr);

  private:
    void refresh();
    void showSelection(quint16 label);
    void applyChange(QTreeWidgetItem* item, int column);
    [[nodiscard]] QTreeWidgetItem* itemOf(std::uint16_t label) const;

    QTreeWidget* list_ = nullptr;
    QLabel* hint_ = nullptr;
    bool refreshing_ = false;
};

}  // namespace ui
