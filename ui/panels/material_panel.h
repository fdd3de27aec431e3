// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "ui/panels/panel.h"

class QCheckBox;
class QComboBox;
class QFileSystemWatcher;
class QGroupBox;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace core {
struct BrdfFile;
}

namespace ui {

class BackgroundTask;
class ColorButton;
class ParamControl;
class ParamSlider;
class VectorEdit;

/// The material the selected segment is edited to. The BRDF's own controls come from its table (core/material/brdf.h),
/// so that a new BRDF needs nothing here.
class MaterialPanel : public Panel {
    Q_OBJECT
  public:
    explicit MaterialPanel(Workspace& workspace, QWidget* parent = nullptr);
    ~MaterialPanel() override;

    /// Gives the selected segment the BRDF of a file, which is read in the background.
    void loadBrdf(const QString& path);

  private:
    /// Three numbers of a material that are not a colour, and the undo step that sets them.
    struct VectorRow {
        QString key;
        QString label;
        QString toolTip;
        QString unit = {};
        double minimum = 0;
        double maximum = 0;
        int decimals = 3;
        QString edit;
        std::function<void(core::Material&, const core::Vector3f&)> set;
    };

    void makeBrdfChoice();
    QWidget* makeBody();
    void makeSurfaceGroup();
    void makeColors(QVBoxLayout* layout);
    /// Button that takes a colour of the material from the picture.
    QToolButton* makePicker(const QString& key, const QString& edit,
                            std::function<void(core::Material&, const core::Vector3f&)> set);
    void makeFresnel(QVBoxLayout* layout);
    void makeBlendGroup();
    void makeTranslucencyGroup();
    void makeSubstance(QVBoxLayout* layout);
    void makeCoefficients(QVBoxLayout* layout);
    VectorEdit* addVector(const VectorRow& row, QVBoxLayout* layout);
    void connectControl(ParamControl* control, std::function<void(core::Material&, const core::ParamValue&)> set);
    /// Replaces the BRDF's sliders when another BRDF is shown.
    void rebuildParams(const core::Material& material);
    void refresh();
    void refreshColors(const core::Segment& segment);
    void refreshFresnel(const core::Material& material);
    void refreshTranslucency(const core::Material& material);
    /// The files of the scene's BRDFs.
    [[nodiscard]] QStringList brdfFiles() const;
    /// Watches these files, missing ones included.
    void watchFiles();
    void reloadSoon(const QString& path);
    /// Reads files again that changed on disk; the last valid version of a file stays in use.
    void reloadChanged();
    using Loaded = std::function<void(const std::shared_ptr<const core::BrdfFile>&)>;
    void readFile(const std::string& path, const Loaded& then, const std::function<void(const QString&)>& otherwise);
    void showFile(const core::Material& material);
    void setBrdf(const QString& label, const core::Material& fresh);
    void chooseBrdf(const std::string& key);
    /// Edits the selected segment's material, if it has one.
    void editMaterial(const QString& label, const std::function<void(core::Material&)>& change,
                      const QString& mergeKey = {});
    ParamSlider* addMaterialSlider(const struct ParamSpec& spec, std::function<void(core::Material&, float)> set);

    QLabel* title_ = nullptr;
    QLabel* hint_ = nullptr;  ///< why a material changes nothing
    QComboBox* brdf_ = nullptr;
    QPushButton* remove_ = nullptr;
    QLabel* file_ = nullptr;
    QFileSystemWatcher* watcher_ = nullptr;
    std::set<std::string> changed_;  ///< files to read again
    QString fileProblem_;            ///< why a file's latest state is not in use
    std::unique_ptr<BackgroundTask> loading_;
    QWidget* scroll_ = nullptr;  ///< around `body_`
    QWidget* body_ = nullptr;
    QWidget* albedoRow_ = nullptr;
    ColorButton* albedo_ = nullptr;
    QWidget* specularRow_ = nullptr;
    ColorButton* specular_ = nullptr;
    QCheckBox* specularEstimated_ = nullptr;
    QVBoxLayout* paramLayout_ = nullptr;
    std::string paramsOf_;                              ///< BRDF whose sliders are in `params_`
    std::shared_ptr<const core::BrdfFile> paramsFile_;  ///< and its file
    std::vector<ParamSlider*> params_;
    QWidget* fresnelRow_ = nullptr;
    QComboBox* fresnel_ = nullptr;
    QWidget* metalRow_ = nullptr;
    QComboBox* metal_ = nullptr;
    VectorEdit* eta_ = nullptr;
    VectorEdit* k_ = nullptr;
    std::vector<ParamControl*> blend_;  ///< in the order of core::blendParams
    QGroupBox* translucency_ = nullptr;
    QComboBox* preset_ = nullptr;
    ColorButton* diffusionColor_ = nullptr;
    VectorEdit* freePath_ = nullptr;
    VectorEdit* sigmaA_ = nullptr;
    VectorEdit* sigmaSPrime_ = nullptr;
    std::vector<ParamControl*> translucencyControls_;  ///< in the order of core::translucencyParams
};

}  // namespace ui
