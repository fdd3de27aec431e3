// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/color_button.h"

#include <QColorDialog>
#include <QPainter>

#include "ui/canvas/display.h"

namespace ui {

ColorButton::ColorButton(const QString& key, const QString& title, QWidget* parent)
    : QToolButton(parent), title_(title) {
    setObjectName(key);
    setAccessibleName(title);
    setMinimumSize(64, 22);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QToolButton::clicked, this, &ColorButton::choose);
    setColor(color_);
}

void ColorButton::setColor(const core::Vector3f& linear) {
    color_ = linear;
    setToolTip(tr("%1: linear %2, %3, %4. Click to change.")
                   .arg(title_)
                   .arg(static_cast<double>(linear.x()), 0, 'f', 3)
                   .arg(static_cast<double>(linear.y()), 0, 'f', 3)
                   .arg(static_cast<double>(linear.z()), 0, 'f', 3));
    update();
}

void ColorButton::choose() {
    auto* dialog = new QColorDialog(displayColor(color_), this);
    dialog->setObjectName(objectName() + QStringLiteral("Dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(title_);
    const core::Vector3f before = color_;
    const auto apply = [this](const core::Vector3f& linear) {
        setColor(linear);
        emit colorChanged(linear);
    };
    connect(dialog, &QColorDialog::currentColorChanged, this,
            [apply](const QColor& color) { apply(linearColor(color)); });
    connect(dialog, &QColorDialog::rejected, this, [apply, before] { apply(before); });
    connect(dialog, &QColorDialog::finished, this, &ColorButton::editingFinished);
    dialog->open();
}

void ColorButton::paintEvent(QPaintEvent* event) {
    Q_UNUSED(event);
    QPainter painter(this);
    QColor fill = displayColor(color_);
    if (!isEnabled()) fill.setAlphaF(0.25f);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? palette().highlight().color() : palette().mid().color());
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 2.5, -0.5, -2.5), 3, 3);
}

}  // namespace ui
