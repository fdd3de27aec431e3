// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

#include "core/base/pixel.h"
#include "ui/canvas/canvas_state.h"
#include "ui/tools/selection_session.h"

class QWidget;

namespace ui {

/// Where the pointer is, in continuous picture coordinates, which may lie outside the picture, and what is held.
struct ToolEvent {
    QPointF position;
    Qt::KeyboardModifiers modifiers;
};

/// What the left button does on the picture. Each tool is a file here and a row in tool_registry.cpp.
class Tool : public QObject {
    Q_OBJECT
  public:
    explicit Tool(SelectionSession& session, QObject* parent = nullptr) : QObject(parent), session_(session) {}

    [[nodiscard]] virtual Pointer pointer() const { return {.strokes = true, .shape = Qt::CrossCursor}; }
    /// Whether it combines shapes with the selection as SelectionSession::use says.
    [[nodiscard]] virtual bool drawsShapes() const { return false; }
    /// One sentence: what to do now.
    [[nodiscard]] virtual QString hint() const = 0;
    /// Controls for the bar above the picture; nullptr = none. Called once.
    [[nodiscard]] virtual QWidget* makeOptions(QWidget* /*parent*/) { return nullptr; }

    virtual void press(const ToolEvent& /*event*/) {}
    virtual void drag(const QPointF& /*position*/) {}
    virtual void release() {}
    virtual void hover(const ToolEvent& /*event*/) {}
    virtual void leave() {}
    /// In place of the second press of a double click.
    virtual void doublePress(const ToolEvent& event) { press(event); }
    /// Enter and Escape: end or drop what is in progress. False: nothing is.
    virtual bool finish() { return false; }
    virtual bool cancel() { return false; }
    /// Backspace: takes the last part of what is in progress back. False: nothing is.
    virtual bool takeBack() { return false; }

    /// Makes the brush larger or smaller. False: there is none.
    virtual bool resize(float /*factor*/) { return false; }

  signals:
    void pointerChanged();
    void hintChanged();

  protected:
    [[nodiscard]] SelectionSession& session() const { return session_; }
    /// The pixel at a position; not necessarily in the picture.
    [[nodiscard]] static core::Pixel pixelAt(const QPointF& position);
    [[nodiscard]] bool inPicture(const core::Pixel& pixel) const;

  private:
    SelectionSession& session_;
};

}  // namespace ui
