// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVulkanWindow>

#include "ui/canvas/canvas_state.h"

namespace ui {

class CanvasRenderer;

/// The native window of the canvas: input in, frames out.
class CanvasWindow : public QVulkanWindow {
    Q_OBJECT
  public:
    CanvasWindow();

    QVulkanWindowRenderer* createRenderer() override;
    /// nullptr before the window is first shown.
    [[nodiscard]] CanvasRenderer* renderer() const { return renderer_; }
    [[nodiscard]] CanvasState& state() { return state_; }

    /// Draws a frame soon, because the state changed. No frame is drawn while nothing changes and the renderer is
    /// finished.
    void redraw();
    /// View and picture sizes changed.
    void updateSizes();
    void setPointer(const Pointer& pointer);
    void setPicking(bool picking);
    void setHand(bool held);

  signals:
    void deviceReady(const QString& name);
    void progressChanged();
    /// A frame was handed to the display; it shows the state at its start.
    void framePresented();
    /// After `failed`: QVulkanWindow has given the device up and makes another one when it is next exposed.
    void deviceLost();
    void cursorMoved(const ui::CursorValue& value);
    void segmentClicked(quint16 label);
    void pixelPicked(int x, int y);
    void zoomChanged(double zoom);
    void strokeBegan(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void strokeMoved(const QPointF& position);
    void strokeEnded();
    void hovered(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void hoverEnded();
    void doubleClicked(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void failed(const QString& sentence);
    /// The user pressed on the picture: the widget around should take the keyboard focus.
    void pressed();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

  private:
    [[nodiscard]] QPointF deviceAt(const QPointF& logical) const { return devicePosition(logical, devicePixelRatio()); }
    void moveCursor(const QPointF& logical);
    void updateCursorShape();
    void setCursorOutside();

    CanvasState state_;
    CanvasRenderer* renderer_ = nullptr;  ///< owned by QVulkanWindow
    QPointF pressPosition_;
    QPointF lastPosition_;
    bool dragging_ = false;
    Pointer pointer_;
    bool painting_ = false;  ///< a stroke is being drawn
    bool picking_ = false;   ///< a click gives its pixel
    bool hand_ = false;      ///< the left button moves the picture, whatever else it would do
};

}  // namespace ui
