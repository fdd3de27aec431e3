// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>

#include "ui/tools/tool.h"

namespace ui {

/// The pixels whose centres lie inside a polygon (odd-even rule), in a mask of `size`; empty for fewer than 3 points.
[[nodiscard]] core::BinaryMask fillPolygon(const QPolygonF& polygon, QSize size);

/// Shapes that are drawn point by point: previews them and combines them with the selection.
class OutlineTool : public Tool {
    Q_OBJECT
  public:
    using Tool::Tool;
    [[nodiscard]] bool drawsShapes() const override { return true; }
    bool cancel() override;

  protected:
    void begin(const ToolEvent& event);
    [[nodiscard]] bool drawing() const { return !points_.isEmpty(); }
    /// Combines the shape with the selection; one without area does nothing.
    void close(const QString& step);
    /// Shows what the shape would select.
    void show(const QPolygonF& shape);

    QPolygonF points_;

  private:
    Qt::KeyboardModifiers modifiers_;  ///< at the first point
};

/// Free outline drawn in one stroke.
class LassoTool : public OutlineTool {
    Q_OBJECT
  public:
    using OutlineTool::OutlineTool;
    [[nodiscard]] QString hint() const override;
    void press(const ToolEvent& event) override;
    void drag(const QPointF& position) override;
    void release() override;
};

/// Outline of straight lines, a click for each corner. A double click, Enter or a click on the first corner closes it.
class PolygonTool : public OutlineTool {
    Q_OBJECT
  public:
    using OutlineTool::OutlineTool;
    [[nodiscard]] QString hint() const override;
    void press(const ToolEvent& event) override;
    void hover(const ToolEvent& event) override;
    void doublePress(const ToolEvent& event) override;
    bool finish() override;
    bool takeBack() override;
};

}  // namespace ui
