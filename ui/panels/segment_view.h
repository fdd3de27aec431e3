// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPersistentModelIndex>
#include <QTreeView>
#include <cstdint>
#include <vector>

namespace ui {

class SegmentModel;

/// The list of segments: a click on a switch (glossy, visible, locked) changes it and nothing else, a drop on a row
/// goes to that row.
class SegmentView : public QTreeView {
    Q_OBJECT
  public:
    explicit SegmentView(SegmentModel& model, QWidget* parent = nullptr);

    /// Selected segments, from top to bottom.
    [[nodiscard]] std::vector<std::uint16_t> chosen() const;
    [[nodiscard]] bool isChosen(std::uint16_t label) const;
    /// Selects exactly these; the first becomes the current row.
    void choose(const std::vector<std::uint16_t>& labels);

  signals:
    /// Space was pressed.
    void glossyWanted();

  protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void sizeColumns();
    [[nodiscard]] QModelIndex switchAt(const QMouseEvent& event) const;

    SegmentModel& model_;
    QPersistentModelIndex pressed_;  ///< switch on which the button went down
};

}  // namespace ui
