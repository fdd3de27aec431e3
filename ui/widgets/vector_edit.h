// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "core/base/image.h"

class QDoubleSpinBox;

namespace ui {

/// Three numbers, one per colour channel, for quantities that are not colours to look at (coefficients, indices of
/// refraction). Setting a value from outside emits nothing.
class VectorEdit : public QWidget {
    Q_OBJECT
  public:
    /// `key` names the widget; its boxes are `<key>R`, `<key>G`, `<key>B`.
    VectorEdit(const QString& key, const QString& label, const QString& toolTip, double minimum, double maximum,
               int decimals, QWidget* parent = nullptr);

    [[nodiscard]] core::Vector3f value() const;
    void setValue(const core::Vector3f& value);
    /// Shows a unit after the numbers.
    void setUnit(const QString& unit);

  signals:
    void valueChanged(const core::Vector3f& value);
    void editingFinished();

  private:
    std::array<QDoubleSpinBox*, 3> boxes_{};
};

}  // namespace ui
