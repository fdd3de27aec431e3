// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/param_slider.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

namespace ui {

namespace {
constexpr int kSteps = 1000;
constexpr int kSpinWidth = 96;
}  // namespace

ParamSlider::ParamSlider(const ParamSpec& spec, QWidget* parent) : QWidget(parent), spec_(spec) {
    if (spec_.minimum <= 0) spec_.logarithmic = false;
    setObjectName(spec_.key);
    label_ = new QLabel(spec_.label, this);
    if (!spec_.compact) label_->setMinimumWidth(kLabelWidth);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName(spec_.key + QStringLiteral("Slider"));
    slider_->setRange(0, kSteps);
    slider_->setPageStep(kSteps / 20);
    slider_->setMinimumWidth(spec_.compact ? 40 : 60);
    spin_ = new QDoubleSpinBox(this);
    spin_->setObjectName(spec_.key + QStringLiteral("Spin"));
    spin_->setRange(spec_.lowest.value_or(spec_.minimum), spec_.highest.value_or(spec_.maximum));
    spin_->setDecimals(spec_.decimals);
    spin_->setStepType(spec_.logarithmic ? QAbstractSpinBox::AdaptiveDecimalStepType
                                         : QAbstractSpinBox::DefaultStepType);
    if (!spec_.logarithmic) spin_->setSingleStep((spec_.maximum - spec_.minimum) / 100);
    spin_->setKeyboardTracking(false);
    if (!spec_.unit.isEmpty()) spin_->setSuffix(QStringLiteral(" ") + spec_.unit);
    if (!spec_.compact)
        spin_->setFixedWidth(kSpinWidth);
    else
        setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    label_->setBuddy(spin_);

    const QString help = spec_.toolTip.isEmpty() ? spec_.label : spec_.toolTip;
    const QString reset = tr("%1\nDouble-click the label to reset to %2.").arg(help).arg(spec_.initial);
    for (QWidget* widget :
         {static_cast<QWidget*>(label_), static_cast<QWidget*>(slider_), static_cast<QWidget*>(spin_)}) {
        widget->setToolTip(reset);
        widget->setAccessibleName(spec_.label);
        widget->installEventFilter(this);
    }
    slider_->setFocusPolicy(Qt::StrongFocus);
    spin_->setFocusPolicy(Qt::StrongFocus);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label_);
    layout->addWidget(slider_, 1);
    layout->addWidget(spin_);

    connect(slider_, &QSlider::valueChanged, this, [this](int position) { change(valueAt(position)); });
    connect(slider_, &QSlider::sliderReleased, this, &ParamSlider::editingFinished);
    connect(spin_, &QDoubleSpinBox::valueChanged, this, &ParamSlider::change);
    connect(spin_, &QDoubleSpinBox::editingFinished, this, &ParamSlider::editingFinished);
    setValue(spec_.initial);
}

void ParamSlider::setValue(double value) {
    value_ = std::clamp(value, spec_.lowest.value_or(spec_.minimum), spec_.highest.value_or(spec_.maximum));
    const QSignalBlocker blockSlider(slider_);
    const QSignalBlocker blockSpin(spin_);
    slider_->setValue(positionOf(value_));
    spin_->setValue(value_);
}

void ParamSlider::setMaximum(double maximum) {
    if (spec_.maximum == maximum) return;
    spec_.maximum = maximum;
    const QSignalBlocker blockSlider(slider_);
    const QSignalBlocker blockSpin(spin_);
    spin_->setMaximum(spec_.highest.value_or(maximum));
    slider_->setValue(positionOf(value_));
}

void ParamSlider::change(double value) {
    if (value == value_) return;
    setValue(value);
    emit valueChanged(value_);
}

double ParamSlider::valueAt(int position) const {
    const double t = static_cast<double>(position) / kSteps;
    if (spec_.logarithmic) return spec_.minimum * std::pow(spec_.maximum / spec_.minimum, t);
    return spec_.minimum + (spec_.maximum - spec_.minimum) * t;
}

int ParamSlider::positionOf(double value) const {
    const double inside = std::clamp(value, spec_.minimum, spec_.maximum);
    const double t = spec_.logarithmic ? std::log(inside / spec_.minimum) / std::log(spec_.maximum / spec_.minimum)
                                       : (inside - spec_.minimum) / (spec_.maximum - spec_.minimum);
    return static_cast<int>(std::lround(std::clamp(t, 0.0, 1.0) * kSteps));
}

bool ParamSlider::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonDblClick && watched != spin_) {
        change(spec_.initial);
        emit editingFinished();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ui
