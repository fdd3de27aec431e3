// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segment_thumbnails.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/canvas/display.h"

namespace ui {

namespace {

constexpr double kMargin = 0.15;        ///< around a segment, as a share of its size
constexpr float kSurroundings = 0.38f;  ///< brightness of what is beside it
constexpr int kSamplesAcross = 3;       ///< of one pixel of a thumbnail

/// The part of the photograph that a thumbnail shows: the segment with a margin, in the thumbnail's proportions, inside
/// the photograph as far as possible.
QRectF shownPart(const core::LabelImage& labels, const core::SegmentExtent& extent, const QSize& size) {
    const double w = extent.x1 - extent.x0 + 1, h = extent.y1 - extent.y0 + 1;
    const double aspect = static_cast<double>(size.width()) / size.height();
    const double margin = std::max(1.0, kMargin * std::max(w, h));
    const double width = std::max(w + 2 * margin, (h + 2 * margin) * aspect);
    const double height = width / aspect;
    const auto place = [](double center, double length, double all) {
        const double start = center - length / 2;
        return length >= all ? (all - length) / 2 : std::clamp(start, 0.0, all - length);
    };
    return {place(extent.x0 + w / 2, width, labels.width()), place(extent.y0 + h / 2, height, labels.height()), width,
            height};
}

}  // namespace

QImage segmentThumbnail(const core::Photo& photo, std::uint16_t label, const core::SegmentExtent& extent,
                        const QSize& size) {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    if (extent.pixels == 0 || !photo.color.sameSize(photo.labels)) return image;
    const QRectF part = shownPart(photo.labels, extent, size);
    const core::ImageRgb& color = photo.color;
    const double step = part.width() / size.width();
    const int across = step > 1 ? kSamplesAcross : 1;
    for (int v = 0; v < size.height(); ++v) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(v));
        for (int u = 0; u < size.width(); ++u) {
            core::Vector3f sum(0, 0, 0);
            int count = 0, inside = 0;
            for (int j = 0; j < across; ++j)
                for (int i = 0; i < across; ++i) {
                    const auto x = static_cast<int>(std::floor(part.x() + (u + (i + 0.5) / across) * step));
                    const auto y = static_cast<int>(std::floor(part.y() + (v + (j + 0.5) / across) * step));
                    if (!color.contains(x, y)) continue;
                    sum += color(x, y).cwiseMin(1.0f);
                    ++count;
                    inside += photo.labels(x, y) == label ? 1 : 0;
                }
            if (2 * count < across * across) continue;
            const float share = static_cast<float>(inside) / static_cast<float>(count);
            const float brightness = kSurroundings + (1 - kSurroundings) * share;
            const QColor shown = displayColor(sum / static_cast<float>(count));
            const int grey = qGray(shown.rgb());
            const auto channel = [&](int value) {
                const float mixed =
                    share * static_cast<float>(value) + (1 - share) * static_cast<float>(value + grey) / 2;
                return static_cast<int>(mixed * brightness);
            };
            row[u] = qRgb(channel(shown.red()), channel(shown.green()), channel(shown.blue()));
        }
    }
    return image;
}

QIcon SegmentThumbnails::find(const core::Photo& photo, std::uint16_t label, const core::SegmentExtent& extent,
                              double devicePixelRatio) {
    if (!color_.shares(photo.color)) entries_.clear();
    color_ = photo.color;
    const Entry* known = entries_.object(label);
    if (known != nullptr && known->hash == extent.hash && known->ratio == devicePixelRatio) return known->icon;
    const auto scaled = [&](int length) { return static_cast<int>(std::lround(length * devicePixelRatio)); };
    const QImage picture = segmentThumbnail(photo, label, extent, {scaled(kWidth), scaled(kHeight)});
    QPixmap pixmap(scaled(kSwatchWidth + kWidth), scaled(kHeight));
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const core::Vector3f swatch = segmentColor(label);
    painter.fillRect(0, 0, scaled(kSwatchWidth - 1), pixmap.height(),
                     QColor::fromRgbF(swatch.x(), swatch.y(), swatch.z()));
    painter.drawImage(scaled(kSwatchWidth), 0, picture);
    painter.end();
    pixmap.setDevicePixelRatio(devicePixelRatio);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    entries_.insert(label, new Entry{extent.hash, devicePixelRatio, icon});
    return icon;
}

}  // namespace ui
