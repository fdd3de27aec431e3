// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/param_control.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <variant>

#include "ui/widgets/color_button.h"
#include "ui/widgets/param_slider.h"

namespace ui {

QString sceneText(const char* text) { return QCoreApplication::translate("scene", text); }

ParamControl::ParamControl(const core::ParamRow& row, QWidget* parent) : QWidget(parent), row_(row) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (row.automatic) makeAutomatic();
    if (std::holds_alternative<bool>(row.initial))
        makeSwitch();
    else if (!row.words.empty())
        makeChoice();
    else if (std::holds_alternative<core::Vector3f>(row.initial))
        makeColor();
    else if (row.slider.min < row.slider.max)
        makeSlider();
    else
        makeNumber();
}

QString ParamControl::label() const { return sceneText(row_.label); }

QString ParamControl::name() const {
    QString name;
    bool capital = false;
    for (const char* c = row_.key; *c != '\0'; ++c) {
        const bool separator = *c == '.' || *c == '_';
        if (!separator) name += capital ? QChar::fromLatin1(*c).toUpper() : QChar::fromLatin1(*c);
        capital = separator;
    }
    return name;
}

void ParamControl::setValue(const core::ParamValue& value, const core::ParamValue& estimate) {
    const bool automatic = std::holds_alternative<std::monostate>(value);
    const core::ParamValue& visible = automatic ? estimate : value;
    if (automatic_ != nullptr) {
        automatic_->setChecked(automatic);
        body_->setEnabled(!automatic);
    }
    if (!std::holds_alternative<std::monostate>(visible)) show_(visible);
}

void ParamControl::setUnavailable(const QString& reason) {
    setEnabled(reason.isEmpty());
    if (reason == unavailable_) return;
    unavailable_ = reason;
    for (QWidget* part : findChildren<QWidget*>()) {
        const char* const kHelp = "help";
        if (!part->property(kHelp).isValid()) part->setProperty(kHelp, part->toolTip());
        part->setToolTip(reason.isEmpty() ? part->property(kHelp).toString() : reason);
    }
}

void ParamControl::makeAutomatic() {
    automatic_ = new QCheckBox(tr("%1: automatic").arg(label()), this);
    automatic_->setObjectName(name() + QStringLiteral("Automatic"));
    automatic_->setToolTip(tr("Use the estimate from the photograph"));
    layout()->addWidget(automatic_);
    connect(automatic_, &QCheckBox::clicked, this,
            [this](bool on) { emit edited(on ? core::ParamValue() : shown_(), false); });
}

QHBoxLayout* ParamControl::makeLine(QWidget* control) {
    auto* line = new QWidget(this);
    auto* lineLayout = new QHBoxLayout(line);
    lineLayout->setContentsMargins(0, 0, 0, 0);
    auto* title = new QLabel(label(), line);
    title->setMinimumWidth(kLabelWidth);
    title->setBuddy(control);
    title->setToolTip(sceneText(row_.help));
    control->setObjectName(name());
    control->setAccessibleName(label());
    control->setToolTip(sceneText(row_.help));
    lineLayout->addWidget(title);
    lineLayout->addWidget(control, 1);
    layout()->addWidget(line);
    body_ = line;
    return lineLayout;
}

void ParamControl::makeSwitch() {
    auto* box = new QCheckBox(label(), this);
    box->setObjectName(name());
    box->setToolTip(sceneText(row_.help));
    layout()->addWidget(box);
    body_ = box;
    show_ = [box](const core::ParamValue& value) { box->setChecked(std::get<bool>(value)); };
    connect(box, &QCheckBox::clicked, this, [this](bool on) { emit edited(on, false); });
}

void ParamControl::makeChoice() {
    auto* box = new QComboBox(this);
    for (const core::Word<std::int64_t>& word : row_.words)
        box->addItem(sceneText(word.label), QVariant::fromValue<qlonglong>(word.value));
    // Long names may be cut rather than widen the panel.
    box->setMinimumContentsLength(8);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    makeLine(box);
    show_ = [box](const core::ParamValue& value) {
        box->setCurrentIndex(box->findData(QVariant::fromValue<qlonglong>(std::get<std::int64_t>(value))));
    };
    connect(box, &QComboBox::activated, this,
            [this, box](int index) { emit edited(std::int64_t{box->itemData(index).toLongLong()}, false); });
}

void ParamControl::makeColor() {
    auto* button = new ColorButton(name(), label(), this);
    makeLine(button);
    show_ = [button](const core::ParamValue& value) { button->setColor(std::get<core::Vector3f>(value)); };
    shown_ = [button] { return core::ParamValue(button->color()); };
    connect(button, &ColorButton::colorChanged, this,
            [this](const core::Vector3f& color) { emit edited(color, true); });
    connect(button, &ColorButton::editingFinished, this, &ParamControl::editingFinished);
}

void ParamControl::makeSlider() {
    const double factor = row_.unit.factor;
    auto* slider = new ParamSlider({.key = name(),
                                    .label = label(),
                                    .unit = sceneText(row_.unit.label),
                                    .toolTip = sceneText(row_.help),
                                    .minimum = row_.slider.min * factor,
                                    .maximum = row_.slider.max * factor,
                                    .initial = core::toNumber(row_.initial) * factor,
                                    .logarithmic = row_.logScale,
                                    .decimals = row_.decimals,
                                    .lowest = row_.legal.min * factor,
                                    .highest = row_.legal.max * factor},
                                   this);
    layout()->addWidget(slider);
    body_ = slider;
    show_ = [slider, factor](const core::ParamValue& value) { slider->setValue(core::toNumber(value) * factor); };
    shown_ = [this, slider, factor] { return core::fromNumber(row_, slider->value() / factor); };
    connect(slider, &ParamSlider::valueChanged, this, [this] { emit edited(shown_(), true); });
    connect(slider, &ParamSlider::editingFinished, this, &ParamControl::editingFinished);
}

void ParamControl::makeNumber() {
    const double factor = row_.unit.factor;
    auto* box = new QDoubleSpinBox(this);
    box->setDecimals(row_.decimals);
    box->setRange(row_.legal.min * factor, row_.legal.max * factor);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    if (*row_.unit.label != '\0') box->setSuffix(QStringLiteral(" ") + sceneText(row_.unit.label));
    if (*row_.zero != '\0') box->setSpecialValueText(sceneText(row_.zero));
    makeLine(box);
    show_ = [box, factor](const core::ParamValue& value) {
        const QSignalBlocker block(box);
        box->setValue(core::toNumber(value) * factor);
    };
    shown_ = [this, box, factor] { return core::fromNumber(row_, box->value() / factor); };
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] { emit edited(shown_(), true); });
    connect(box, &QDoubleSpinBox::editingFinished, this, &ParamControl::editingFinished);
}

}  // namespace ui
