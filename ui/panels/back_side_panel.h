// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/panel.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class ParamSlider;
class ProfileView;

/// The shape of the selected segment: how smooth its front is and how its unseen back is invented, with a cut through
/// both.
class BackSidePanel : public Panel {
    Q_OBJECT
  public:
    explicit BackSidePanel(Workspace& workspace, QWidget* parent = nullptr);

  private:
    /// Translated name of a method.
    [[nodiscard]] static QString methodName(core::BackSideMethod method);
    /// What the analysis took for the selected segment, and why.
    [[nodiscard]] QString outcomeText() const;
    void refresh();
    void refreshSmoothing();
    void refreshPreview();
    void chooseBackDepth();

    QLabel* title_ = nullptr;
    QCheckBox* smoothAutomatically_ = nullptr;
    ParamSlider* smoothing_ = nullptr;
    QComboBox* method_ = nullptr;
    QLabel* outcome_ = nullptr;
    ParamSlider* offset_ = nullptr;
    ParamSlider* planeShift_ = nullptr;
    ParamSlider* scale_ = nullptr;
    ParamSlider* thickness_ = nullptr;
    ProfileView* profile_ = nullptr;
    QLabel* backDepth_ = nullptr;
    QPushButton* loadBackDepth_ = nullptr;
    QPushButton* clearBackDepth_ = nullptr;
};

}  // namespace ui
