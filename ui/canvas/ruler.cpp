// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/ruler.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/canvas/canvas.h"

namespace ui {
namespace {

constexpr double kLongest = 200;  // logical pixels

/// Median depth of a segment's front [m]; 0 when nothing of it has a depth.
double medianDepth(const core::LabelImage& labels, const core::ImageF& depth, std::uint16_t label) {
    std::vector<float> values;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == label && depth[i] > 0) values.push_back(depth[i]);
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

}  // namespace

Ruler roundRuler(double millimetresPerPixel, double devicePixelRatio) {
    const double longest = kLongest * devicePixelRatio * millimetresPerPixel;
    if (!std::isnormal(longest) || longest <= 0) return {};
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    double length = power;
    // 1.000001: a length that is one of these but for rounding.
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

SubstanceRuler::SubstanceRuler(const Workspace& workspace, Canvas& canvas, QObject* parent)
    : QObject(parent), workspace_(workspace), canvas_(canvas) {
    connect(&workspace_, &Workspace::selectionChanged, this, &SubstanceRuler::update);
    connect(&workspace_, &Workspace::sceneChanged, this, &SubstanceRuler::update);
    connect(&workspace_, &Workspace::analysisChanged, this, &SubstanceRuler::update);
    connect(&workspace_, &Workspace::documentReplaced, this, &SubstanceRuler::update);
}

void SubstanceRuler::setShown(bool shown) {
    shown_ = shown;
    update();
}

double SubstanceRuler::millimetresPerPixel() {
    const core::Segment* segment = workspace_.selectedSegment();
    const std::shared_ptr<const core::Analysis>& analysis = workspace_.analysis();
    if (segment == nullptr || !segment->edit || !segment->edit->translucency || analysis == nullptr) return 0;
    const core::Photo& photo = *workspace_.scene().photo;
    if (analysis != depthFrom_ || segment->label != depthOf_) {
        if (!analysis->front->depth.sameSize(photo.labels)) return 0;
        depth_ = medianDepth(photo.labels, analysis->front->depth, segment->label);
        depthFrom_ = analysis;
        depthOf_ = segment->label;
    }
    const double focal = 0.5 * static_cast<double>(photo.camera.fx + photo.camera.fy);
    return 1000 * depth_ / focal * static_cast<double>(segment->edit->translucency->scale);
}

void SubstanceRuler::update() { canvas_.setRuler(shown_ ? millimetresPerPixel() : 0); }

}  // namespace ui
