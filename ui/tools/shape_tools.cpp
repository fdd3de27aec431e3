// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_tools.h"

#include <QImage>
#include <QLineF>
#include <QPainter>
#include <cmath>

namespace ui {

namespace {

/// A click this near to the first corner closes a polygon [logical pixels].
constexpr double kClosing = 8;
/// Least distance between points of a lasso [picture pixels].
constexpr double kLassoStep = 1;

}  // namespace

core::BinaryMask fillPolygon(const QPolygonF& polygon, QSize size) {
    core::BinaryMask mask(size.width(), size.height());
    if (polygon.size() < 3) return mask;
    const QRect box = polygon.boundingRect().toAlignedRect().adjusted(-1, -1, 1, 1) & QRect(QPoint(0, 0), size);
    if (box.isEmpty()) return mask;
    QImage image(box.size(), QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.translate(-box.topLeft());
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPolygon(polygon, Qt::OddEvenFill);
    painter.end();
    for (int y = 0; y < image.height(); ++y) {
        const uchar* row = image.constScanLine(y);
        for (int x = 0; x < image.width(); ++x)
            if (row[x] != 0) mask(box.x() + x, box.y() + y) = 1;
    }
    return mask;
}

void OutlineTool::begin(const ToolEvent& event) {
    points_ = {event.position};
    modifiers_ = event.modifiers;
}

void OutlineTool::show(const QPolygonF& shape) {
    if (session().photo() == nullptr) return;
    const auto& color = session().photo()->color;
    const core::BinaryMask result = core::combineMasks(
        session().selected(), fillPolygon(shape, {color.width(), color.height()}), session().useWith(modifiers_));
    session().preview(&result);
}

void OutlineTool::close(const QString& step) {
    const QPolygonF shape = std::exchange(points_, {});
    emit hintChanged();
    if (session().photo() == nullptr) return;
    const auto& color = session().photo()->color;
    if (shape.size() < 3) {
        session().preview(nullptr);
        return;
    }
    session().apply(step, fillPolygon(shape, {color.width(), color.height()}), session().useWith(modifiers_));
}

bool OutlineTool::cancel() {
    if (!drawing()) return false;
    points_.clear();
    session().preview(nullptr);
    emit hintChanged();
    return true;
}

QString LassoTool::hint() const { return tr("Draw around the object in one stroke."); }

void LassoTool::press(const ToolEvent& event) { begin(event); }

void LassoTool::drag(const QPointF& position) {
    if (!drawing() || QLineF(points_.back(), position).length() < kLassoStep) return;
    points_ << position;
    show(points_);
}

void LassoTool::release() {
    if (drawing()) close(tr("Lasso"));
}

QString PolygonTool::hint() const {
    return drawing() ? tr("Click the next corner. A double click or Enter closes the outline, Backspace takes a corner "
                          "back, Escape drops it.")
                     : tr("Click the corners of the object, one after the other.");
}

void PolygonTool::press(const ToolEvent& event) {
    if (!drawing()) {
        begin(event);
        emit hintChanged();
        return;
    }
    if (QLineF(points_.front(), event.position).length() * session().canvas().zoom() <= kClosing) {
        finish();
        return;
    }
    if (points_.back() != event.position) points_ << event.position;
    show(points_);
}

void PolygonTool::hover(const ToolEvent& event) {
    if (!drawing()) return;
    QPolygonF shape = points_;
    show(shape << event.position);
}

void PolygonTool::doublePress(const ToolEvent& event) {
    // The first press of the double click has set this corner.
    if (!drawing())
        press(event);
    else
        finish();
}

bool PolygonTool::finish() {
    if (!drawing()) return false;
    close(tr("Polygon"));
    return true;
}

bool PolygonTool::takeBack() {
    if (!drawing()) return false;
    points_.removeLast();
    if (!drawing()) {
        session().preview(nullptr);
        emit hintChanged();
    } else {
        show(points_);
    }
    return true;
}

}  // namespace ui
