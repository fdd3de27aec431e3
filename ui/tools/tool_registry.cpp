// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_registry.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include "ui/tools/brush_tool.h"
#include "ui/tools/depth_tool.h"
#include "ui/tools/navigate_tool.h"
#include "ui/tools/shape_tools.h"
#include "ui/tools/smart_select_tool.h"

namespace ui {

namespace {

constexpr int kIconSize = 20;

template <class T>
Tool* makeTool(SelectionSession& session, BrushOptions& /*brush*/, QObject* parent) {
    return new T(session, parent);
}

template <BrushTool::Kind kind>
Tool* makeBrush(SelectionSession& session, BrushOptions& brush, QObject* parent) {
    return new BrushTool(session, kind, brush, parent);
}

void drawPointer(QPainter& painter) {
    painter.setBrush(painter.pen().color());
    painter.drawPolygon(QPolygonF({{5, 2}, {5, 16}, {8.5, 12.5}, {11, 18}, {13, 17}, {10.5, 11.8}, {15, 11.5}}));
}

void drawSmart(QPainter& painter) {
    QPen dashed = painter.pen();
    dashed.setDashPattern({2, 1.6});
    painter.setPen(dashed);
    painter.drawEllipse(QRectF(2.5, 5, 12, 12));
    dashed.setStyle(Qt::SolidLine);
    painter.setPen(dashed);
    painter.drawLine(QPointF(9, 11), QPointF(17, 3));
    painter.drawLine(QPointF(17, 7.5), QPointF(17, 8.5));
    painter.drawLine(QPointF(12, 2.5), QPointF(13, 2.5));
}

void drawBrush(QPainter& painter) {
    painter.drawLine(QPointF(17, 2.5), QPointF(9, 11));
    QPainterPath tip(QPointF(9, 10));
    tip.cubicTo(5, 9.5, 6, 15, 2, 16.5);
    tip.cubicTo(6, 18.5, 11, 17, 10.5, 12);
    tip.closeSubpath();
    painter.fillPath(tip, painter.pen().color());
}

void drawEraser(QPainter& painter) {
    painter.drawPolygon(QPolygonF({{11, 3}, {17, 9}, {9, 17}, {5.5, 17}, {2.5, 14}, {2.5, 11.5}}));
    painter.drawLine(QPointF(6.5, 7.5), QPointF(12.5, 13.5));
}

void drawLasso(QPainter& painter) {
    painter.drawEllipse(QRectF(2.5, 2.5, 15, 9.5));
    QPainterPath rope(QPointF(6, 11.5));
    rope.cubicTo(3.5, 14, 9, 14, 6, 18);
    painter.drawPath(rope);
}

void drawCorners(QPainter& painter) {
    const QPolygonF corners({{3, 6}, {11, 2.5}, {17, 9}, {13, 17}, {5, 15.5}});
    painter.drawPolygon(corners);
    painter.setBrush(painter.pen().color());
    for (const QPointF& corner : corners) painter.drawRect(QRectF(corner.x() - 1.2, corner.y() - 1.2, 2.4, 2.4));
}

void drawDepth(QPainter& painter) {
    for (int i = 0; i < 3; ++i) {
        const double y = 3.5 + 4.5 * i;
        painter.drawPolygon(QPolygonF({{2.5, y + 3}, {10, y}, {17.5, y + 3}, {10, y + 6}}));
    }
}

void drawRefine(QPainter& painter) {
    QPainterPath edge(QPointF(3, 17));
    edge.cubicTo(4, 9, 8, 12, 9, 7);
    edge.cubicTo(10, 3, 14, 4, 17, 3);
    painter.drawPath(edge);
    QPen dotted = painter.pen();
    dotted.setDashPattern({1, 1.8});
    painter.setPen(dotted);
    painter.drawPath(edge.translated(2.5, 2.5));
}

}  // namespace

QString ToolEntry::translatedTitle() const { return QCoreApplication::translate("ToolRegistry", title); }

QString ToolEntry::translatedHelp() const { return QCoreApplication::translate("ToolRegistry", help); }

QIcon ToolEntry::icon(const QColor& color) const {
    QIcon result;
    for (const int scale : {1, 2, 3}) {
        QPixmap pixmap(kIconSize * scale, kIconSize * scale);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(scale, scale);
        painter.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        draw(painter);
        painter.end();
        pixmap.setDevicePixelRatio(scale);
        result.addPixmap(pixmap);
    }
    return result;
}

const std::vector<ToolEntry>& toolRegistry() {
    static const std::vector<ToolEntry> kTools = {
        {"toolNavigate", QT_TRANSLATE_NOOP("ToolRegistry", "Pick and move"), "V",
         QT_TRANSLATE_NOOP("ToolRegistry", "Click a segment to edit it, drag to move the picture"), false, drawPointer,
         makeTool<NavigateTool>},
        {"toolSmartSelect", QT_TRANSLATE_NOOP("ToolRegistry", "Smart select"), "W",
         QT_TRANSLATE_NOOP("ToolRegistry",
                           "Select an object by clicking it; Alt-click takes away, a drag points at "
                           "several places"),
         false, drawSmart, makeTool<SmartSelectTool>},
        {"toolBrush", QT_TRANSLATE_NOOP("ToolRegistry", "Selection brush"), "B",
         QT_TRANSLATE_NOOP("ToolRegistry", "Paint what is selected"), false, drawBrush,
         makeBrush<BrushTool::Kind::Paint>},
        {"toolEraser", QT_TRANSLATE_NOOP("ToolRegistry", "Selection eraser"), "E",
         QT_TRANSLATE_NOOP("ToolRegistry", "Erase what is selected"), false, drawEraser,
         makeBrush<BrushTool::Kind::Erase>},
        {"toolLasso", QT_TRANSLATE_NOOP("ToolRegistry", "Lasso"), "L",
         QT_TRANSLATE_NOOP("ToolRegistry", "Select what is inside a line drawn freely"), false, drawLasso,
         makeTool<LassoTool>},
        {"toolPolygon", QT_TRANSLATE_NOOP("ToolRegistry", "Polygon"), "P",
         QT_TRANSLATE_NOOP("ToolRegistry", "Select what is inside an outline of straight lines"), false, drawCorners,
         makeTool<PolygonTool>},
        {"toolDepth", QT_TRANSLATE_NOOP("ToolRegistry", "Depth and plane"), "D",
         QT_TRANSLATE_NOOP("ToolRegistry", "Select what is equally far away, or a plane"), true, drawDepth,
         makeTool<DepthTool>},
        {"toolRefine", QT_TRANSLATE_NOOP("ToolRegistry", "Refine edge"), "R",
         QT_TRANSLATE_NOOP("ToolRegistry", "Paint over an outline to find it again in the photograph"), false,
         drawRefine, makeBrush<BrushTool::Kind::Refine>},
    };
    return kTools;
}

}  // namespace ui
