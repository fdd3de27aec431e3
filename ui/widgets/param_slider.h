// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ui {

/// Minimum width of labels [px], so that the controls of a panel line up.
inline constexpr int kLabelWidth = 104;

/// A scalar control in Qt's terms, made from a row of a BRDF's table (shaders/brdf) or of core/scene/params.h.
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
    std::optional<double> lowest = {};   ///< what can be typed; by default the slider's minimum
    std::optional<double> highest = {};  ///< by default the slider's maximum
    bool compact = false;                ///< in a bar: as narrow as its texts allow
};

/// One number: label, slider and spin box that agree. Setting a value from outside emits nothing.
class ParamSlider : public QWidget {
    Q_OBJECT
  public:
    explicit ParamSlider(const ParamSpec& spec, QWidget* parent = nullptr);

    [[nodiscard]] double value() const { return value_; }
    void setValue(double value);
    /// Another upper end; a value above it stays what it is until it is set again.
    void setMaximum(double maximum);
    [[nodiscard]] const ParamSpec& spec() const { return spec_; }

  signals:
    /// The user changed the value; emitted continuously while the slider moves.
    void valueChanged(double value);
    /// The user released the slider or left the box: the change is complete.
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
