// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <optional>

#include "core/scene/brush.h"
#include "ui/canvas/canvas.h"
#include "ui/workspace.h"

namespace ui {

/// Turns strokes on the canvas into edits of the mask that the workspace says is painted: one undo step a stroke. The
/// red overlay follows the pointer; the picture follows when it has shown every pixel of what it was given last, so
/// that painting never keeps it from refining.
class MaskPainter : public QObject {
    Q_OBJECT
  public:
    MaskPainter(Workspace& workspace, Canvas& canvas, QObject* parent = nullptr);

  private:
    void begin(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void move(const QPointF& position);
    void end();
    /// Hands the mask of the stroke to the document.
    void publish();
    void publishWhenShown();
    void refresh();

    Workspace& workspace_;
    Canvas& canvas_;
    std::shared_ptr<const core::Photo> photo_;  ///< whose labels the stroke refers to
    std::optional<core::BrushStroke> stroke_;
    bool unpublished_ = false;
    int strokes_ = 0;
    QElapsedTimer published_;
};

}  // namespace ui
