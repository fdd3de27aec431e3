// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/map_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "ui/canvas/display.h"

namespace ui {

MapView::MapView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setMinimumHeight(72);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void MapView::setMap(const core::DirectionalMap& map) {
    map_ = map;
    rebuild();
}

void MapView::setEmpty(const QString& reason) {
    map_ = {};
    reason_ = reason;
    rebuild();
}

void MapView::setExposure(float stops) {
    if (stops == exposureStops_) return;
    exposureStops_ = stops;
    rebuild();
}

void MapView::setCoverageShown(bool shown) {
    if (shown == coverageShown_) return;
    coverageShown_ = shown;
    rebuild();
}

void MapView::rebuild() {
    image_ = map_.empty() ? QImage() : displayImage(map_.radiance, exposureStops_);
    if (coverageShown_ && !image_.isNull() && map_.coverage.sameSize(map_.radiance)) {
        constexpr int kHatch = 6;
        for (int y = 0; y < image_.height(); ++y) {
            auto* row = reinterpret_cast<QRgb*>(image_.scanLine(y));
            for (int x = 0; x < image_.width(); ++x) {
                if (map_.clipped.contains(x, y) && map_.clipped(x, y) != 0 && (x + y) % kHatch == 0)
                    row[x] = qRgb(220, 60, 160);
                if (map_.coverage(x, y) > 0) continue;
                const bool line = (x + y) % kHatch == 0;
                row[x] = line ? qRgb(235, 120, 60)
                              : qRgb(qRed(row[x]) * 2 / 5, qGreen(row[x]) * 2 / 5, qBlue(row[x]) * 2 / 5);
            }
        }
    }
    update();
}

QRectF MapView::target() const {
    if (image_.isNull()) return {};
    const double scale =
        std::min(static_cast<double>(width()) / image_.width(), static_cast<double>(height()) / image_.height());
    const QSizeF size(image_.width() * scale, image_.height() * scale);
    return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

void MapView::paintEvent(QPaintEvent* event) {
    Q_UNUSED(event);
    QPainter painter(this);
    if (image_.isNull()) {
        painter.fillRect(rect(), palette().base());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, reason_);
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(target(), image_);
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    const QRectF area = target();
    if (!area.contains(event->position())) {
        emit hovered({});
        return;
    }
    const double u = (event->position().x() - area.left()) / area.width();
    const double v = (event->position().y() - area.top()) / area.height();
    const int x = std::min(static_cast<int>(u * map_.radiance.width()), map_.radiance.width() - 1);
    const int y = std::min(static_cast<int>(v * map_.radiance.height()), map_.radiance.height() - 1);
    const core::Vector3f& value = map_.radiance(x, y);
    const double seen = map_.coverage.contains(x, y) ? static_cast<double>(map_.coverage(x, y)) : 0.0;
    const bool clipped = map_.clipped.contains(x, y) && map_.clipped(x, y) != 0;
    emit hovered(tr("azimuth %1°, elevation %2°: %3, %4, %5; %6")
                     .arg((u - 0.5) * 360, 0, 'f', 0)
                     .arg((0.5 - v) * 180, 0, 'f', 0)
                     .arg(static_cast<double>(value.x()), 0, 'g', 3)
                     .arg(static_cast<double>(value.y()), 0, 'g', 3)
                     .arg(static_cast<double>(value.z()), 0, 'g', 3)
                     .arg(clipped    ? tr("clipped by the camera, estimated")
                          : seen > 0 ? tr("observed")
                                     : tr("interpolated")));
}

void MapView::leaveEvent(QEvent* event) {
    Q_UNUSED(event);
    emit hovered({});
}

}  // namespace ui
