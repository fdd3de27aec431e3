// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/ruler.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace ui {
namespace {

/// Length limit [logical pixels].
constexpr double kMaxLength = 200;

}  // namespace

Ruler roundRuler(double millimetresPerPixel, double devicePixelRatio) {
    const double longest = kMaxLength * devicePixelRatio * millimetresPerPixel;
    if (!std::isnormal(longest) || longest <= 0) return {};
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    double length = power;
    // The factor accepts lengths that exceed the limit by rounding only.
    for (const double step : {2.0, 5.0, 10.0})
        if (step * power <= 1.000001 * longest) length = step * power;
    return {.millimetres = length, .pixels = length / millimetresPerPixel};
}

QString rulerText(double millimetres) {
    const auto number = [](double value) { return QLocale().toString(value, 'g', 6); };
    if (millimetres >= 999.5) return QStringLiteral("%1 m").arg(number(millimetres / 1000));
    if (millimetres >= 9.95) return QStringLiteral("%1 cm").arg(number(millimetres / 10));
    if (millimetres >= 0.0995) return QStringLiteral("%1 mm").arg(number(millimetres));
    return QStringLiteral("%1 µm").arg(number(millimetres * 1000));
}

QImage rulerImage(const Ruler& ruler, double devicePixelRatio) {
    if (!(ruler.pixels > 0)) return {};
    const double unit = devicePixelRatio;
    QFont font = QGuiApplication::font();
    font.setPixelSize(static_cast<int>(std::lround(13 * unit)));
    font.setWeight(QFont::DemiBold);
    const QString text = rulerText(ruler.millimetres);
    const QFontMetricsF metrics(font);
    const double rim = 1.5 * unit;
    const double tick = 5 * unit;
    const double width = std::max(ruler.pixels, metrics.horizontalAdvance(text)) + 4 * rim;
    const double line = metrics.height() + tick + rim;
    QImage image(static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(line + 3 * rim)),
                 QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    const double left = 2 * rim;
    QPainterPath bar;
    bar.moveTo(left, line - tick);
    bar.lineTo(left, line);
    bar.lineTo(left + ruler.pixels, line);
    bar.lineTo(left + ruler.pixels, line - tick);
    QPainterPath letters;
    letters.addText(left + std::max(0.5 * (ruler.pixels - metrics.horizontalAdvance(text)), 0.0), metrics.ascent(),
                    font, text);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor dark(0, 0, 0, 190);
    const auto pen = [](const QColor& color, double w) {
        return QPen(color, w, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin);
    };
    painter.strokePath(bar, pen(dark, 1.5 * unit + 2 * rim));
    painter.strokePath(letters, QPen(dark, 2 * rim, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(bar, pen(Qt::white, 1.5 * unit));
    painter.fillPath(letters, Qt::white);
    return image;
}

}  // namespace ui
