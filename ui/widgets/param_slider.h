// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ui {

inline constexpr int kLabelWidth = 104;  ///< [px] at least, so that the controls of a panel line up

/// What a scalar control shows: the same table the BRDFs declare (shaders/brdf), in Qt's terms.
struct ParamSpec {
    QString key;    ///< object name of the control; its parts are `<key>Slider` and `<key>Spin`
    QString label;  ///< translated, shown and used as accessible name
    QString unit;   ///< suffix, "" = none
    QString toolTip;
    double minimum = 0;
    double maximum = 1;
    double initial = 0;        ///< double-click on the label or slider returns to it
    bool logarithmic = false;  ///< slider positions are spaced by factors; needs minimum > 0
    int decimals = 3;
};

/// One number: label, slider and spin box that agree. Setting a value from outside emits nothing.
class ParamSlider : public QWidget {
    Q_OBJECT
  public:
    explicit ParamSlider(const ParamSpec& spec, QWidget* parent = nullptr);

    [[nodiscard]] double value() const { return value_; }
    void setValue(double value);
    [[nodiscard]] const ParamSpec& spec() const { return spec_; }

  signals:
    /// The user changed the value; many times while the slider moves.
    void valueChanged(double value);
    /// The user let go: the change is one step.
    void editingFinished();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    [[nodiscard]] double valueAt(int position) const;
    [[nodiscard]] int positionOf(double value) const;
    void change(double value);

    ParamSpec spec_;
    double value_ = 0;
    QLabel* label_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* spin_ = nullptr;
};

}  // namespace ui
