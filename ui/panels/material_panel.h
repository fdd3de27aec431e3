// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/panels/panel.h"

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui {

class ColorButton;
class ParamSlider;
class VectorEdit;

/// The material the selected segment is edited to. The BRDF's own controls come from its table (core/brdf.h), so that
/// a new BRDF needs nothing here.
class MaterialPanel : public Panel {
    Q_OBJECT
  public:
    explicit MaterialPanel(Workspace& workspace, QWidget* parent = nullptr);

  private:
    void makeSurfaceGroup();
    void makeBlendGroup();
    void makeTranslucencyGroup();
    /// Replaces the BRDF's sliders when another BRDF is shown.
    void rebuildParams(const std::string& brdf);
    void refresh();
    void chooseBrdf(const std::string& key);
    /// Edits the selected segment's material, if it has one.
    void editMaterial(const QString& label, const std::function<void(core::Material&)>& change,
                      const QString& mergeKey = {});
    void editTranslucency(const QString& label, const std::function<void(core::Translucency&)>& change,
                          const QString& mergeKey);
    ParamSlider* addMaterialSlider(const struct ParamSpec& spec, std::function<void(core::Material&, float)> set);

    QLabel* title_ = nullptr;
    QComboBox* brdf_ = nullptr;
    QPushButton* remove_ = nullptr;
    QWidget* body_ = nullptr;
    QWidget* albedoRow_ = nullptr;
    ColorButton* albedo_ = nullptr;
    QWidget* specularRow_ = nullptr;
    ColorButton* specular_ = nullptr;
    QCheckBox* specularEstimated_ = nullptr;
    QVBoxLayout* paramLayout_ = nullptr;
    std::string paramsOf_;  ///< BRDF whose sliders are in `params_`
    std::vector<ParamSlider*> params_;
    QWidget* fresnelRow_ = nullptr;
    QComboBox* fresnel_ = nullptr;
    QWidget* metalRow_ = nullptr;
    QComboBox* metal_ = nullptr;
    VectorEdit* eta_ = nullptr;
    VectorEdit* k_ = nullptr;
    ParamSlider* blendNew_ = nullptr;
    ParamSlider* blendOriginal_ = nullptr;
    QGroupBox* translucency_ = nullptr;
    QComboBox* preset_ = nullptr;
    VectorEdit* sigmaA_ = nullptr;
    VectorEdit* sigmaSPrime_ = nullptr;
    ParamSlider* translucencyEta_ = nullptr;
    ParamSlider* translucencyScale_ = nullptr;
    ParamSlider* translucencyWeight_ = nullptr;
};

}  // namespace ui
