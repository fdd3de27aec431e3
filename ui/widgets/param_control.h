// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "core/scene/params.h"

class QCheckBox;
class QHBoxLayout;

namespace ui {

/// Text of a scene parameter or of a word of its enumeration in the user's language.
[[nodiscard]] QString sceneText(const char* text);

/// The control of one row of core/scene/params.h: a check box, a choice, a colour, a slider or a number. Automatic
/// parameters have a check box of their own before it. Its parts are named after the key: "back_side.offset" makes
/// `backSideOffset` (of a slider also `backSideOffsetSpin`), and `...Automatic` for the check box.
class ParamControl : public QWidget {
    Q_OBJECT
  public:
    explicit ParamControl(const core::ParamRow& row, QWidget* parent = nullptr);

    /// Translated label, for undo steps.
    [[nodiscard]] QString label() const;
    /// Name of the control, the same for every change of its value.
    [[nodiscard]] QString name() const;
    /// Shows a value; emits nothing. `estimate` is shown while the value is automatic; without one, what was shown
    /// stays.
    void setValue(const core::ParamValue& value, const core::ParamValue& estimate = {});

    /// Disables it and says why in its tool tip; "" enables it.
    void setUnavailable(const QString& reason);

  signals:
    /// The user changed the value. `continues`: more changes may follow until `editingFinished`, all of them one step.
    void edited(const core::ParamValue& value, bool continues);
    void editingFinished();

  private:
    void makeAutomatic();
    void makeSwitch();
    void makeChoice();
    void makeColor();
    void makeSlider();
    void makeNumber();
    /// A labelled line of the control.
    QHBoxLayout* makeLine(QWidget* control);

    const core::ParamRow& row_;
    QString unavailable_;  ///< reason; "" = available
    QCheckBox* automatic_ = nullptr;
    QWidget* body_ = nullptr;
    std::function<void(const core::ParamValue&)> show_;
    std::function<core::ParamValue()> shown_;
};

}  // namespace ui
