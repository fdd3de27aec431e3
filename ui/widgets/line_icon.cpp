// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/line_icon.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QStringList>
#include <algorithm>

namespace ui {

namespace {

constexpr double kIconGrid = 16;

QPainterPath iconPath(const char* icon) {
    QPainterPath path;
    const QStringList words = QString::fromLatin1(icon).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    qsizetype next = 0;
    const auto number = [&] { return next < words.size() ? words[next++].toDouble() : 0; };
    const auto point = [&] {
        const double x = number();
        return QPointF(x, number());
    };
    while (next < words.size()) {
        const QChar command = words[next++].front();
        if (command == QLatin1Char('M')) {
            path.moveTo(point());
        } else if (command == QLatin1Char('L')) {
            path.lineTo(point());
        } else if (command == QLatin1Char('Q')) {
            const QPointF control = point();
            path.quadTo(control, point());
        } else if (command == QLatin1Char('O')) {
            const QPointF center = point();
            const double radius = number();
            path.addEllipse(center, radius, radius);
        } else if (command == QLatin1Char('R')) {
            const QPointF corner = point();
            const QPointF size = point();
            path.addRect(QRectF(corner, QSizeF(size.x(), size.y())));
        } else if (command == QLatin1Char('Z')) {
            path.closeSubpath();
        }
    }
    return path;
}

}  // namespace

void paintLineIcon(QPainter& painter, const char* icon, const QRectF& place, const QColor& color) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = std::min(place.width(), place.height()) / kIconGrid;
    painter.translate(place.center());
    painter.scale(scale, scale);
    painter.translate(-kIconGrid / 2, -kIconGrid / 2);
    painter.setPen(QPen(color, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(iconPath(icon));
    painter.restore();
}

QIcon lineIcon(const char* icon) {
    QIcon result;
    const QPalette palette = QGuiApplication::palette();
    for (const int size : {16, 32, 48})
        for (const auto& [mode, group] :
             {std::pair{QIcon::Normal, QPalette::Active}, {QIcon::Disabled, QPalette::Disabled}}) {
            QPixmap pixmap(size, size);
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            paintLineIcon(painter, icon, QRectF(0, 0, size, size), palette.color(group, QPalette::ButtonText));
            painter.end();
            result.addPixmap(pixmap, mode);
        }
    return result;
}

}  // namespace ui
