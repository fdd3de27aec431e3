// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/panels/panel.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class BackgroundTask;
class ColorButton;
class MapView;
class ParamSlider;

/// The light: the scene's environment and, for the selected glossy segment, L_S, L_G, the reflectance ρ and the
/// lobe width; a map from a file in place of the recovered one, or to complete it.
class EnvironmentPanel : public Panel {
    Q_OBJECT
  public:
    explicit EnvironmentPanel(Workspace& workspace, QWidget* parent = nullptr);
    ~EnvironmentPanel() override;

  public slots:
    /// Loads a latitude-longitude map in the background and edits the scene when it is there.
    void loadEnvironment(const QString& path);

  private:
    void refresh();
    void refreshMap();
    void refreshReflectance();

    QComboBox* which_ = nullptr;
    MapView* map_ = nullptr;
    QLabel* hover_ = nullptr;
    QCheckBox* coverage_ = nullptr;
    ParamSlider* exposure_ = nullptr;
    QLabel* source_ = nullptr;
    QPushButton* load_ = nullptr;
    QPushButton* recover_ = nullptr;
    ParamSlider* rotation_ = nullptr;
    ParamSlider* scale_ = nullptr;
    QComboBox* use_ = nullptr;
    QComboBox* fill_ = nullptr;
    QLabel* rho_ = nullptr;
    QCheckBox* rhoByHand_ = nullptr;
    ColorButton* rhoColor_ = nullptr;
    QCheckBox* lobeByHand_ = nullptr;
    ParamSlider* lobe_ = nullptr;
    std::unique_ptr<BackgroundTask> loading_;
};

}  // namespace ui
