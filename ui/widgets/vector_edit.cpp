// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/vector_edit.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/widgets/param_slider.h"

namespace ui {

VectorEdit::VectorEdit(const QString& key, const QString& label, const QString& toolTip, double minimum, double maximum,
                       int decimals, QWidget* parent)
    : QWidget(parent) {
    setObjectName(key);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    auto* title = new QLabel(label, this);
    title->setMinimumWidth(kLabelWidth);
    title->setToolTip(toolTip);
    layout->addWidget(title);
    const std::array<QString, 3> letters = {QStringLiteral("R"), QStringLiteral("G"), QStringLiteral("B")};
    const std::array<QString, 3> names = {tr("red"), tr("green"), tr("blue")};
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        auto* box = new QDoubleSpinBox(this);
        box->setObjectName(key + letters[i]);
        box->setAccessibleName(label + QStringLiteral(", ") + names[i]);
        box->setToolTip(toolTip + QStringLiteral(" (") + names[i] + QStringLiteral(")"));
        box->setRange(minimum, maximum);
        box->setDecimals(decimals);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setKeyboardTracking(false);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(50);
        layout->addWidget(box, 1);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] { emit valueChanged(value()); });
        connect(box, &QDoubleSpinBox::editingFinished, this, &VectorEdit::editingFinished);
        boxes_[i] = box;
    }
    title->setBuddy(boxes_[0]);
}

core::Vector3f VectorEdit::value() const {
    return {static_cast<float>(boxes_[0]->value()), static_cast<float>(boxes_[1]->value()),
            static_cast<float>(boxes_[2]->value())};
}

void VectorEdit::setValue(const core::Vector3f& value) {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const QSignalBlocker block(boxes_[i]);
        boxes_[i]->setValue(static_cast<double>(value[static_cast<Eigen::Index>(i)]));
    }
}

void VectorEdit::setUnit(const QString& unit) {
    auto* label = new QLabel(unit, this);
    label->setObjectName(objectName() + QStringLiteral("Unit"));
    layout()->addWidget(label);
    for (QDoubleSpinBox* box : boxes_) box->setAccessibleDescription(unit);
}

}  // namespace ui
