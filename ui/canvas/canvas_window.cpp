// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_window.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <cmath>

#include "ui/canvas/canvas_renderer.h"

namespace ui {

CanvasWindow::CanvasWindow() {
    // The keyboard stays with the widgets, so that shortcuts work wherever the user clicked last.
    setFlag(Qt::WindowDoesNotAcceptFocus);
}

QVulkanWindowRenderer* CanvasWindow::createRenderer() {
    renderer_ = new CanvasRenderer(*this, state_);
    connect(renderer_, &CanvasRenderer::deviceReady, this, &CanvasWindow::deviceReady);
    connect(renderer_, &CanvasRenderer::progressChanged, this, &CanvasWindow::progressChanged);
    connect(renderer_, &CanvasRenderer::framePresented, this, &CanvasWindow::framePresented);
    connect(renderer_, &CanvasRenderer::deviceLost, this, &CanvasWindow::deviceLost);
    connect(renderer_, &CanvasRenderer::cursorMoved, this, &CanvasWindow::cursorMoved);
    connect(renderer_, &CanvasRenderer::failed, this, &CanvasWindow::failed);
    return renderer_;
}

void CanvasWindow::redraw() {
    if (renderer_ != nullptr) renderer_->paint();
}

void CanvasWindow::updateSizes() {
    const QSize view = QSizeF(QSizeF(size()) * devicePixelRatio()).toSize();
    const QSize picture =
        state_.photo != nullptr ? QSize(state_.photo->color.width(), state_.photo->color.height()) : QSize();
    state_.view.setSizes(view, picture);
    emit zoomChanged(state_.view.zoom());
    redraw();
}

void CanvasWindow::setPointer(const Pointer& pointer) {
    if (pointer == pointer_) return;
    pointer_ = pointer;
    state_.brushRadius = pointer.brushRadius;
    if (!dragging_) updateCursorShape();
    if (!pointer.strokes && painting_) {
        painting_ = false;
        emit strokeEnded();
    }
    redraw();
}

void CanvasWindow::setHand(bool held) {
    if (held == hand_) return;
    hand_ = held;
    if (!dragging_) updateCursorShape();
}

void CanvasWindow::setPicking(bool picking) {
    picking_ = picking;
    if (!dragging_) updateCursorShape();
}

void CanvasWindow::updateCursorShape() {
    setCursor(hand_ ? Qt::OpenHandCursor : picking_ ? Qt::CrossCursor : pointer_.shape);
}

void CanvasWindow::resizeEvent(QResizeEvent* event) {
    QVulkanWindow::resizeEvent(event);
    updateSizes();
}

void CanvasWindow::moveCursor(const QPointF& logical) {
    if (state_.photo == nullptr) return;
    const QPointF p = state_.view.toPicture(deviceAt(logical));
    state_.brushCenter = p;
    state_.brushShown = true;
    if (state_.brushRadius > 0) redraw();
    const QPoint pixel(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
    state_.cursorInside = state_.photo->color.contains(pixel.x(), pixel.y());
    state_.cursor = pixel;
    emit cursorMoved(
        {.x = pixel.x(), .y = pixel.y(), .inside = state_.cursorInside, .hasResult = false, .result = {0, 0, 0}});
    if (state_.cursorInside && renderer_ != nullptr) renderer_->probeCursor();
}

void CanvasWindow::setCursorOutside() {
    state_.cursorInside = false;
    emit cursorMoved({});
}

void CanvasWindow::mousePressEvent(QMouseEvent* event) {
    emit pressed();
    pressPosition_ = event->position();
    lastPosition_ = event->position();
    dragging_ = false;
    const bool draws = pointer_.strokes && !picking_ && !hand_ && state_.photo != nullptr;
    if (event->button() == Qt::LeftButton && draws) {
        painting_ = true;
        moveCursor(event->position());
        emit strokeBegan(state_.brushCenter, event->modifiers());
        return;
    }
    if (event->button() == Qt::RightButton) {
        state_.comparing = true;
        redraw();
    }
}

void CanvasWindow::mouseMoveEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    if (painting_) {
        moveCursor(position);
        emit strokeMoved(state_.brushCenter);
        return;
    }
    if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) != 0) {
        const double threshold = QGuiApplication::styleHints()->startDragDistance();
        if (!dragging_ && QLineF(position, pressPosition_).length() >= threshold) {
            dragging_ = true;
            setCursor(Qt::ClosedHandCursor);
        }
        if (dragging_) {
            state_.view.pan(deviceAt(position) - deviceAt(lastPosition_));
            lastPosition_ = position;
            redraw();
        }
    }
    moveCursor(position);
    if (event->buttons() == Qt::NoButton && state_.photo != nullptr)
        emit hovered(state_.brushCenter, event->modifiers());
}

void CanvasWindow::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) {
        state_.comparing = false;
        redraw();
        return;
    }
    if (painting_ && event->button() == Qt::LeftButton) {
        painting_ = false;
        emit strokeEnded();
        return;
    }
    if (dragging_) {
        dragging_ = false;
        updateCursorShape();
        return;
    }
    if (event->button() != Qt::LeftButton || state_.photo == nullptr || hand_) return;
    moveCursor(event->position());
    if (picking_) {
        if (state_.cursorInside) emit pixelPicked(state_.cursor.x(), state_.cursor.y());
        return;
    }
    const core::LabelImage& labels = state_.photo->labels;
    const bool known = labels.contains(state_.cursor.x(), state_.cursor.y());
    emit segmentClicked(known ? labels(state_.cursor.x(), state_.cursor.y()) : quint16{0});
}

void CanvasWindow::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (pointer_.strokes && !hand_) {
        painting_ = true;
        moveCursor(event->position());
        emit doubleClicked(state_.brushCenter, event->modifiers());
        return;
    }
    if (state_.view.fitted()) {
        state_.view.zoomAt(deviceAt(event->position()), 1);
    } else {
        state_.view.fit();
    }
    emit zoomChanged(state_.view.zoom());
    redraw();
}

void CanvasWindow::wheelEvent(QWheelEvent* event) {
    constexpr double kStepsPerDoubling = 3;
    constexpr double kUnitsPerStep = 120;
    const double steps = event->angleDelta().y() / kUnitsPerStep;
    if (steps == 0) return;
    state_.view.zoomAt(deviceAt(event->position()), state_.view.zoom() * std::exp2(steps / kStepsPerDoubling));
    emit zoomChanged(state_.view.zoom());
    moveCursor(event->position());
    redraw();
}

bool CanvasWindow::event(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        setCursorOutside();
        state_.brushShown = false;
        if (state_.brushRadius > 0) redraw();
        emit hoverEnded();
    }
    return QVulkanWindow::event(event);
}

}  // namespace ui
