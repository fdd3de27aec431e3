// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/panel.h"

class QLabel;
class QPushButton;

namespace ui {

class ProfileView;

/// The shape of the selected segment: how smooth its front is and how its unseen back is invented, with a cut through
/// both.
class BackSidePanel : public Panel {
    Q_OBJECT
  public:
    explicit BackSidePanel(Workspace& workspace, QWidget* parent = nullptr);

  private:
    [[nodiscard]] QWidget* makeFileGroup();
    /// How the analysis made the selected segment's back side; nullptr before it did.
    [[nodiscard]] const core::BackSideInfo* outcome() const;
    /// The method that was used for the selected segment, and why.
    [[nodiscard]] QString outcomeText() const;
    void refresh();
    void enableControls();
    void refreshPreview();
    void chooseBackDepth();

    QLabel* title_ = nullptr;
    QLabel* outcome_ = nullptr;
    ProfileView* profile_ = nullptr;
    QLabel* backDepth_ = nullptr;
    QPushButton* loadBackDepth_ = nullptr;
    QPushButton* clearBackDepth_ = nullptr;
};

}  // namespace ui
