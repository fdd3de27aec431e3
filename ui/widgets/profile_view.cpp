// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/profile_view.h"

#include <QPainter>
#include <algorithm>

#include "ui/canvas/display.h"

namespace ui {

ProfileView::ProfileView(QWidget* parent) : QWidget(parent) {
    setMinimumHeight(120);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ProfileView::clear(const QString& reason) {
    reason_ = reason;
    thickness_ = {};
    frontLine_.clear();
    backLine_.clear();
    maxThickness_ = 0;
    update();
}

void ProfileView::show(const core::LabelImage& labels, std::uint16_t label, const core::Surface& front,
                       const core::Surface& back) {
    clear(tr("This segment has no valid depth."));
    QRect box;
    int thickestColumn = 0;
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            if (labels(x, y) != label || !(front.depth(x, y) > 0) || !(back.depth(x, y) > 0)) continue;
            box |= QRect(x, y, 1, 1);
            const float thickness = back.depth(x, y) - front.depth(x, y);
            if (thickness > maxThickness_) {
                maxThickness_ = thickness;
                thickestColumn = x;
            }
        }
    }
    if (box.isEmpty()) return;
    thickness_ = QImage(box.size(), QImage::Format_RGB32);
    thickness_.fill(qRgb(24, 24, 24));
    for (int y = box.top(); y <= box.bottom(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(thickness_.scanLine(y - box.top()));
        for (int x = box.left(); x <= box.right(); ++x) {
            if (labels(x, y) != label || !(front.depth(x, y) > 0) || !(back.depth(x, y) > 0)) continue;
            const float t = (back.depth(x, y) - front.depth(x, y)) / std::max(maxThickness_, 1e-6f);
            const core::Vector3f c = rampColor(t);
            row[x - box.left()] = QColor::fromRgbF(c.x(), c.y(), c.z()).rgb();
        }
    }
    for (int y = box.top(); y <= box.bottom(); ++y) {
        if (labels(thickestColumn, y) != label || !(front.depth(thickestColumn, y) > 0)) continue;
        const auto f = front.position(thickestColumn, y);
        frontLine_.emplace_back(f.z(), f.y());
        const float scale = back.depth(thickestColumn, y) / std::max(front.depth(thickestColumn, y), 1e-6f);
        backLine_.emplace_back(f.z() * scale, f.y() * scale);
    }
    update();
}

void ProfileView::paintEvent(QPaintEvent* event) {
    Q_UNUSED(event);
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    const int caption = fontMetrics().height() + 4;
    if (thickness_.isNull()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, reason_);
        return;
    }
    const QRectF left(6, 6, width() / 2.0 - 9, height() - 10.0 - caption);
    const QRectF right(width() / 2.0 + 3, 6, width() / 2.0 - 9, height() - 10.0 - caption);
    const double imageScale = std::min(left.width() / thickness_.width(), left.height() / thickness_.height());
    const QSizeF size(thickness_.width() * imageScale, thickness_.height() * imageScale);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(left.center() - QPointF(size.width() / 2, size.height() / 2), size), thickness_);

    QRectF bounds;
    for (const auto* line : {&frontLine_, &backLine_}) {
        for (const QPointF& p : *line) bounds |= QRectF(p, QSizeF(1e-6, 1e-6));
    }
    const double scale = 0.9 * std::min(right.width() / std::max(bounds.width(), 1e-6),
                                        right.height() / std::max(bounds.height(), 1e-6));
    const auto map = [&](const QPointF& p) { return right.center() + (p - bounds.center()) * scale; };
    painter.setRenderHint(QPainter::Antialiasing);
    const auto draw = [&](const std::vector<QPointF>& line, const QColor& color) {
        QPolygonF polygon;
        for (const QPointF& p : line) polygon << map(p);
        painter.setPen(QPen(color, 1.8));
        painter.drawPolyline(polygon);
    };
    draw(frontLine_, QColor(230, 230, 230));
    draw(backLine_, QColor(240, 150, 70));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QRectF captions(0, height() - caption - 2.0, width(), caption);
    painter.drawText(captions.adjusted(6, 0, -width() / 2.0, 0), Qt::AlignCenter,
                     tr("thickness, up to %1 mm").arg(static_cast<double>(maxThickness_) * 1000, 0, 'f', 1));
    painter.drawText(captions.adjusted(width() / 2.0, 0, -6, 0), Qt::AlignCenter, tr("cut: front | back"));
}

}  // namespace ui
