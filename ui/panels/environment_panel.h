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
class MapView;
class ParamSlider;

/// The light: the scene's environment, recovered or from a file, and for the selected glossy segment L_S, L_G, the
/// reflectance ρ and the lobe width.
class EnvironmentPanel : public Panel {
    Q_OBJECT
  public:
    explicit EnvironmentPanel(Workspace& workspace, QWidget* parent = nullptr);
    ~EnvironmentPanel() override;

  public slots:
    /// Loads a latitude-longitude map in the background, then edits the scene.
    void loadEnvironment(const QString& path);

  private:
    [[nodiscard]] QWidget* makeView();
    [[nodiscard]] QWidget* makeSourceGroup();
    [[nodiscard]] QWidget* makeReflectanceGroup();
    void chooseEnvironment();
    void refresh();
    void refreshMap();
    void refreshReflectance();
    /// The estimate of the selected glossy segment in words.
    [[nodiscard]] static QString estimateText(const core::Segment& segment, const core::Reflectance& found);

    QComboBox* which_ = nullptr;
    MapView* map_ = nullptr;
    QLabel* hover_ = nullptr;
    QCheckBox* coverage_ = nullptr;
    ParamSlider* exposure_ = nullptr;
    QLabel* source_ = nullptr;
    QPushButton* load_ = nullptr;
    QPushButton* recover_ = nullptr;
    QLabel* rho_ = nullptr;
    std::unique_ptr<BackgroundTask> loading_;
};

}  // namespace ui
