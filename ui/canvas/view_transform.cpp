// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/view_transform.h"

#include <algorithm>
#include <cmath>

namespace ui {

void ViewTransform::setSizes(const QSize& view, const QSize& picture) {
    const bool other = picture != picture_;
    view_ = view;
    picture_ = picture;
    if (fitted_ || other) fit();
}

void ViewTransform::fit() {
    fitted_ = true;
    center_ = QPointF(picture_.width() * 0.5, picture_.height() * 0.5);
    zoom_ = 1;
    if (view_.isEmpty() || picture_.isEmpty()) return;
    constexpr double kMargin = 0.98;
    zoom_ = std::min({1.0, kMargin * view_.width() / picture_.width(), kMargin * view_.height() / picture_.height()});
    zoom_ = std::max(zoom_, kMinZoom);
}

void ViewTransform::zoomAt(const QPointF& viewPosition, double zoom) {
    const QPointF fixed = toPicture(viewPosition);
    zoom_ = std::clamp(zoom, kMinZoom, kMaxZoom);
    fitted_ = false;
    center_ += fixed - toPicture(viewPosition);
    clampCenter();
}

void ViewTransform::zoomCentered(double zoom) { zoomAt(QPointF(view_.width() * 0.5, view_.height() * 0.5), zoom); }

void ViewTransform::pan(const QPointF& deviceDelta) {
    fitted_ = false;
    center_ -= deviceDelta / zoom_;
    clampCenter();
}

void ViewTransform::clampCenter() {
    center_.setX(std::clamp(center_.x(), 0.0, static_cast<double>(picture_.width())));
    center_.setY(std::clamp(center_.y(), 0.0, static_cast<double>(picture_.height())));
}

QPointF ViewTransform::origin() const {
    const QPointF corner = center_ - QPointF(view_.width() * 0.5, view_.height() * 0.5) / zoom_;
    if (zoom_ < 1) return corner;
    return QPointF(std::round(corner.x() * zoom_), std::round(corner.y() * zoom_)) / zoom_;
}

QPointF ViewTransform::toPicture(const QPointF& viewPosition) const { return origin() + viewPosition / zoom_; }

QPointF ViewTransform::toView(const QPointF& picturePosition) const { return (picturePosition - origin()) * zoom_; }

}  // namespace ui
