// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/render_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/widgets/param_slider.h"

namespace ui {

RenderPanel::RenderPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    samples_ = addNumber("renderSamples", tr("Samples"), tr("Light paths per pixel at which the picture is finished"),
                         1, 65536, [](core::Scene& s, int v) { s.render.samples = v; });
    timeLimit_ = addNumber("renderTimeLimit", tr("Time limit"),
                           tr("Seconds after which the view is not refined any more; pictures that are exported have "
                              "all samples"),
                           0, 3600, [](core::Scene& s, int v) { s.render.timeLimit = v; });
    timeLimit_->setSpecialValueText(tr("None"));
    timeLimit_->setSuffix(tr(" s"));
    bounces_ = addNumber("renderBounces", tr("Bounces"),
                         tr("Surfaces a light path may visit; 1 lets folds mirror an object's old colour"), 1, 64,
                         [](core::Scene& s, int v) { s.render.bounces = v; });
    seed_ = addNumber("renderSeed", tr("Seed"), tr("The same seed gives the same picture"), 0,
                      std::numeric_limits<int>::max(),
                      [](core::Scene& s, int v) { s.render.seed = static_cast<std::uint32_t>(v); });
    surfaceSamples_ = addNumber("renderSurfaceSamples", tr("Surface samples"),
                                tr("Translucency: points on front and back of a segment"), 16, 1'000'000,
                                [](core::Scene& s, int v) { s.render.surfaceSamples = v; });
    irradianceSamples_ =
        addNumber("renderIrradianceSamples", tr("Irradiance rays"), tr("Translucency: light paths per surface point"),
                  1, 4096, [](core::Scene& s, int v) { s.render.irradianceSamples = v; });
    diffusionQuality_ = new QComboBox(this);
    diffusionQuality_->setObjectName(QStringLiteral("renderTranslucencyQuality"));
    diffusionQuality_->setAccessibleName(tr("Quality"));
    diffusionQuality_->setToolTip(tr("How exactly the light of all surface samples is summed"));
    for (const QString& title : {tr("Draft"), tr("Standard"), tr("Fine")}) diffusionQuality_->addItem(title);
    connect(diffusionQuality_, &QComboBox::activated, this, [this](int index) {
        this->workspace().editScene(tr("Change translucency quality"), [index](core::Scene& scene) {
            scene.render.diffusionQuality = static_cast<core::DiffusionQuality>(index);
        });
    });
    filter_ = new QCheckBox(tr("Smooth noise, keep edges"), this);
    filter_->setObjectName(QStringLiteral("renderFilter"));
    filter_->setToolTip(tr("Edge-aware filter of the new picture, inside each segment"));
    connect(filter_, &QCheckBox::clicked, this, [this](bool on) {
        this->workspace().editScene(tr("Change filter"), [on](core::Scene& scene) { scene.render.filter = on; });
    });

    depthFilter_ = new QCheckBox(tr("Filter the depth map"), this);
    depthFilter_->setObjectName(QStringLiteral("depthFilter"));
    depthFilter_->setToolTip(tr("Joint bilateral filter: smooth surfaces, sharp outlines"));
    connect(depthFilter_, &QCheckBox::clicked, this, [this](bool on) {
        this->workspace().editScene(tr("Change depth filter"),
                                    [on](core::Scene& scene) { scene.depthFilter.enabled = on; });
    });
    automatic_ = new QCheckBox(tr("Automatic"), this);
    automatic_->setObjectName(QStringLiteral("depthAutomatic"));
    automatic_->setToolTip(tr("The filter follows the noise that is measured in the depth map"));
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        this->workspace().editScene(tr("Change depth filter"),
                                    [on](core::Scene& scene) { scene.depthFilter.automatic = on; });
    });
    spatialSigma_ = addSceneSlider({.key = "depthSpatialSigma",
                                    .label = tr("Radius"),
                                    .unit = tr("px"),
                                    .toolTip = tr("Size of the depth filter"),
                                    .minimum = 0.3,
                                    .maximum = 20,
                                    .initial = 2,
                                    .logarithmic = true,
                                    .decimals = 2},
                                   [](core::Scene& s, float v) { s.depthFilter.spatialSigma = v; });
    colorSigma_ = addSceneSlider({.key = "depthColorSigma",
                                  .label = tr("Colour range"),
                                  .unit = {},
                                  .toolTip = tr("Colours further apart than this do not mix"),
                                  .minimum = 0.005,
                                  .maximum = 1,
                                  .initial = 0.1,
                                  .logarithmic = true,
                                  .decimals = 3},
                                 [](core::Scene& s, float v) { s.depthFilter.colorSigma = v; });
    depthSigma_ = addSceneSlider({.key = "depthRangeSigma",
                                  .label = tr("Depth range"),
                                  .unit = {},
                                  .toolTip = tr("Depths that differ by a larger fraction do not mix"),
                                  .minimum = 0.0005,
                                  .maximum = 0.2,
                                  .initial = 0.01,
                                  .logarithmic = true,
                                  .decimals = 4},
                                 [](core::Scene& s, float v) { s.depthFilter.depthSigma = v; });

    auto* picture = new QGroupBox(tr("Picture"), this);
    auto* pictureForm = new QFormLayout(picture);
    pictureForm->addRow(tr("Samples"), samples_);
    pictureForm->addRow(tr("Time limit"), timeLimit_);
    pictureForm->addRow(tr("Bounces"), bounces_);
    pictureForm->addRow(tr("Seed"), seed_);
    pictureForm->addRow(filter_);
    auto* translucency = new QGroupBox(tr("Translucency"), this);
    auto* translucencyForm = new QFormLayout(translucency);
    translucencyForm->addRow(tr("Surface samples"), surfaceSamples_);
    translucencyForm->addRow(tr("Irradiance rays"), irradianceSamples_);
    translucencyForm->addRow(tr("Quality"), diffusionQuality_);
    auto* depth = new QGroupBox(tr("Depth"), this);
    auto* depthForm = new QFormLayout(depth);
    depthForm->addRow(depthFilter_);
    depthForm->addRow(automatic_);
    depthForm->addRow(spatialSigma_);
    depthForm->addRow(colorSigma_);
    depthForm->addRow(depthSigma_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(picture);
    layout->addWidget(translucency);
    layout->addWidget(depth);
    layout->addStretch(1);
    connect(&workspace, &Workspace::sceneChanged, this, &RenderPanel::refresh);
    refresh();
}

QSpinBox* RenderPanel::addNumber(const QString& key, const QString& label, const QString& toolTip, int minimum,
                                 int maximum, std::function<void(core::Scene&, int)> set) {
    auto* box = new QSpinBox(this);
    box->setObjectName(key);
    box->setAccessibleName(label);
    box->setToolTip(toolTip);
    box->setRange(minimum, maximum);
    box->setKeyboardTracking(false);
    connect(box, &QSpinBox::valueChanged, this, [this, key, label, set = std::move(set)](int value) {
        workspace().editScene(
            tr("Change %1").arg(label), [&](core::Scene& scene) { set(scene, value); }, key);
    });
    connect(box, &QSpinBox::editingFinished, &workspace(), &Workspace::endMerge);
    return box;
}

void RenderPanel::refresh() {
    setEnabled(workspace().hasPhoto());
    const core::RenderParams& render = workspace().scene().render;
    const core::DepthFilterParams& depth = workspace().scene().depthFilter;
    const auto show = [](QSpinBox* box, int value) {
        const QSignalBlocker block(box);
        box->setValue(value);
    };
    show(samples_, render.samples);
    show(timeLimit_, static_cast<int>(std::lround(render.timeLimit)));
    show(bounces_, render.bounces);
    show(seed_, static_cast<int>(std::min(render.seed, std::uint32_t{std::numeric_limits<int>::max()})));
    show(surfaceSamples_, render.surfaceSamples);
    show(irradianceSamples_, render.irradianceSamples);
    diffusionQuality_->setCurrentIndex(static_cast<int>(render.diffusionQuality));
    filter_->setChecked(render.filter);
    depthFilter_->setChecked(depth.enabled);
    spatialSigma_->setValue(static_cast<double>(depth.spatialSigma));
    colorSigma_->setValue(static_cast<double>(depth.colorSigma));
    depthSigma_->setValue(static_cast<double>(depth.depthSigma));
    automatic_->setChecked(depth.automatic);
    automatic_->setEnabled(depth.enabled);
    for (ParamSlider* slider : {spatialSigma_, colorSigma_, depthSigma_})
        slider->setEnabled(depth.enabled && !depth.automatic);
}

}  // namespace ui
