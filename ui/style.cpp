// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

#include "ui/widgets/wheel_guard.h"

namespace ui {

void applyStyle(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const auto grey = [](int v) { return QColor(v, v, v); };
    QPalette palette;
    palette.setColor(QPalette::Window, grey(60));
    palette.setColor(QPalette::WindowText, grey(214));
    palette.setColor(QPalette::Base, grey(34));
    palette.setColor(QPalette::AlternateBase, grey(40));
    palette.setColor(QPalette::Text, grey(220));
    palette.setColor(QPalette::PlaceholderText, grey(140));
    palette.setColor(QPalette::Button, grey(72));
    palette.setColor(QPalette::ButtonText, grey(220));
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, grey(30));
    palette.setColor(QPalette::ToolTipText, grey(220));
    palette.setColor(QPalette::Light, grey(78));
    palette.setColor(QPalette::Midlight, grey(70));
    palette.setColor(QPalette::Mid, grey(44));
    palette.setColor(QPalette::Dark, grey(34));
    palette.setColor(QPalette::Shadow, grey(20));
    palette.setColor(QPalette::Highlight, QColor(150, 118, 78));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(222, 178, 118));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, grey(120));
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, grey(80));
    QApplication::setPalette(palette);
    application.setStyleSheet(
        QStringLiteral("QToolTip { color: #dcdcdc; background: #1e1e1e; border: 1px solid #555; }"
                       "QToolBar QToolButton:checked { color: white; background: #96764e; border: 1px solid #c8a26c;"
                       " border-radius: 3px; }"));
    application.installEventFilter(new WheelGuard(&application));
}

}  // namespace ui
