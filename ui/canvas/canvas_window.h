// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QVulkanWindow>
#include <memory>

#include "ui/canvas/canvas.h"
#include "ui/canvas/view_transform.h"

namespace ui {

class CanvasRenderer;

/// What the canvas shows, independent of any device.
struct CanvasState {
    std::shared_ptr<const core::Photo> photo;
    std::shared_ptr<const CanvasPicture> original;
    std::shared_ptr<const CanvasPicture> layerPicture;
    ViewLayer layer = ViewLayer::Result;
    std::shared_ptr<const core::Scene> scene;  ///< nullptr until there is an analysis
    std::shared_ptr<const core::Analysis> analysis;
    std::uint64_t sceneNumber = 0;  ///< counts the scenes that were set
    bool suspended = false;         ///< no work for the renderer at all
    bool refining = true;           ///< beyond the first picture of a change
    std::uint16_t selected = 0;
    QRect selectedBounds;  ///< smallest rectangle around the selected segment [picture pixels]
    bool outlineShown = true;
    float exposureStops = 0;
    bool comparing = false;
    std::shared_ptr<const core::Mask> mask;  ///< shown in red
    float brushRadius = 0;                   ///< [picture pixels]; 0 = no brush
    QPointF brushCenter;                     ///< picture position under the pointer
    double rulerMillimetres = 0;             ///< what a picture pixel stands for; 0 = no ruler
    ViewTransform view;
    QPoint cursor;  ///< picture pixel under the pointer
    bool cursorInside = false;
};

/// The native window of the canvas: input in, frames out.
class CanvasWindow : public QVulkanWindow {
    Q_OBJECT
  public:
    CanvasWindow();

    QVulkanWindowRenderer* createRenderer() override;
    /// nullptr before the window is first shown.
    [[nodiscard]] CanvasRenderer* renderer() const { return renderer_; }
    [[nodiscard]] CanvasState& state() { return state_; }

    /// State changed: draw a frame soon. No frame is drawn while nothing changes and the renderer is finished.
    void redraw();
    /// View and picture sizes changed.
    void updateSizes();
    void setBrushRadius(float radius);

  signals:
    void deviceReady(const QString& name);
    void progressChanged();
    /// A frame was handed to the display; it shows the state of when it was begun.
    void framePresented();
    /// After `failed`: QVulkanWindow has given the device up and makes another one when it is next exposed.
    void deviceLost();
    void cursorMoved(const ui::CursorValue& value);
    void segmentClicked(quint16 label);
    void zoomChanged(double zoom);
    void strokeBegan(const QPointF& position, bool inverted);
    void strokeMoved(const QPointF& position);
    void strokeEnded();
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
    bool painting_ = false;  ///< a stroke is being drawn
};

}  // namespace ui
