// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/panel.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace ui {

class ParamSlider;

/// Quality of the picture and of the geometry it is computed from: samples, bounces, filters.
class RenderPanel : public Panel {
    Q_OBJECT
  public:
    explicit RenderPanel(Workspace& workspace, QWidget* parent = nullptr);

  private:
    void refresh();
    QSpinBox* addNumber(const QString& key, const QString& label, const QString& toolTip, int minimum, int maximum,
                        std::function<void(core::Scene&, int)> set);

    QSpinBox* samples_ = nullptr;
    QSpinBox* timeLimit_ = nullptr;
    QSpinBox* bounces_ = nullptr;
    QSpinBox* seed_ = nullptr;
    QSpinBox* surfaceSamples_ = nullptr;
    QSpinBox* irradianceSamples_ = nullptr;
    QComboBox* diffusionQuality_ = nullptr;
    QCheckBox* filter_ = nullptr;
    QCheckBox* depthFilter_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    ParamSlider* spatialSigma_ = nullptr;
    ParamSlider* colorSigma_ = nullptr;
    ParamSlider* depthSigma_ = nullptr;
};

}  // namespace ui
