// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/material_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/analysis/light/surface_color.h"
#include "core/material/brdf_file.h"
#include "core/material/drive_parameters.h"
#include "core/material/material_ranges.h"
#include "core/material/metals.h"
#include "core/material/translucency.h"
#include "core/material/user_brdf.h"
#include "ui/background_task.h"
#include "ui/panels/drive_list.h"
#include "ui/recent_files.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/param_control.h"
#include "ui/widgets/param_slider.h"
#include "ui/widgets/vector_edit.h"
#include "ui/words.h"

namespace ui {

namespace {

/// Delay before a changed file is read again, because editors write a file in several steps.
constexpr int kReloadDelayMs = 150;

QWidget* makeRow(const QString& label, const std::vector<QWidget*>& widgets, QWidget* parent) {
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* title = new QLabel(label, row);
    title->setMinimumWidth(kLabelWidth);
    title->setBuddy(widgets.front());
    layout->addWidget(title);
    for (QWidget* widget : widgets) layout->addWidget(widget, 1);
    return row;
}

/// Fills in the coefficients of a measured substance; "" only forgets the name.
void choosePreset(core::Translucency& t, const std::string& key) {
    const core::TranslucencyPreset* preset = core::findTranslucencyPreset(key);
    t.preset = key;
    if (preset == nullptr) return;
    const core::Translucency values = core::toTranslucency(*preset);
    t.preset = values.preset;
    t.sigmaA = values.sigmaA;
    t.sigmaSPrime = values.sigmaSPrime;
    t.eta = values.eta;
}

/// Coefficients for the colour of a thick piece and a mean free path [mm].
void setLook(core::Translucency& t, const core::Vector3f& color, const core::Vector3f& freePath) {
    const core::Translucency wanted = core::translucencyFromDiffuse(color, freePath, t.eta, t.model);
    t.sigmaA = wanted.sigmaA;
    t.sigmaSPrime = wanted.sigmaSPrime;
    t.preset.clear();
}

/// Takes over what does not belong to one BRDF. Drives of `material` whose parameters `other` does not vary stay.
void takeCommonParts(core::Material& material, const core::Material& other) {
    material.albedo = other.albedo;
    material.specular = other.specular;
    material.blendNew = other.blendNew;
    material.blendOriginal = other.blendOriginal;
    material.translucency = other.translucency;
    std::vector<core::Drive> drives = core::knownDrives(other.drives, material);
    for (const core::Drive& drive : core::knownDrives(material.drives, material))
        if (std::ranges::find(drives, drive.parameter, &core::Drive::parameter) == drives.end())
            drives.push_back(drive);
    material.drives = std::move(drives);
}

}  // namespace

MaterialPanel::MaterialPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    title_ = new QLabel(this);
    title_->setObjectName(QStringLiteral("materialTitle"));
    hint_ = new QLabel(tr("This photograph has no depth, so a material would change nothing. To change materials, open "
                          "it again under File > New from photograph and choose its depth map as \"Depth\"."),
                       this);
    hint_->setObjectName(QStringLiteral("materialHint"));
    hint_->setWordWrap(true);
    hint_->setTextFormat(Qt::PlainText);
    hint_->setContentsMargins(0, 2, 0, 2);
    file_ = new QLabel(this);
    file_->setObjectName(QStringLiteral("materialFile"));
    file_->setWordWrap(true);
    file_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    watcher_ = new QFileSystemWatcher(this);
    remove_ = new QPushButton(tr("Remove edit"), this);
    remove_->setObjectName(QStringLiteral("removeEdit"));
    remove_->setToolTip(tr("Show the segment as it was photographed"));
    makeBrdfChoice();
    scroll_ = makeBody();
    // The panel is as wide without a material as with one.
    QSizePolicy kept = scroll_->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    scroll_->setSizePolicy(kept);

    auto* top = new QHBoxLayout;
    top->addWidget(title_, 1);
    top->addWidget(remove_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 4, 8);
    layout->addLayout(top);
    layout->addWidget(hint_);
    layout->addWidget(brdf_);
    layout->addWidget(file_);
    layout->addWidget(scroll_, 1);

    connect(remove_, &QPushButton::clicked, this, [this] { chooseBrdf({}); });
    connect(watcher_, &QFileSystemWatcher::fileChanged, this, &MaterialPanel::reloadSoon);
    connect(watcher_, &QFileSystemWatcher::directoryChanged, this, [this] {
        const QStringList known = watcher_->files();
        for (const QString& path : brdfFiles())
            if (!known.contains(path) && QFileInfo::exists(path)) reloadSoon(path);
    });
    connect(&workspace, &Workspace::documentReplaced, this, [this] { fileProblem_.clear(); });
    connect(&workspace, &Workspace::sceneChanged, this, &MaterialPanel::watchFiles);
    connect(&workspace, &Workspace::sceneChanged, this, &MaterialPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &MaterialPanel::refresh);
    connect(&workspace, &Workspace::analysisChanged, this, &MaterialPanel::refresh);
    refresh();
}

void MaterialPanel::makeBrdfChoice() {
    brdf_ = new QComboBox(this);
    brdf_->setObjectName(QStringLiteral("materialBrdf"));
    brdf_->setAccessibleName(tr("Material"));
    brdf_->setToolTip(tr("How the new surface reflects light"));
    brdf_->addItem(tr("As photographed"), QString());
    for (const core::BrdfInfo& info : core::brdfs())
        brdf_->addItem(QCoreApplication::translate("brdfs", info.label), QString::fromUtf8(info.key));
    brdf_->addItem(tr("From a file…"), QString::fromLatin1(core::kFileBrdf));
    connect(brdf_, &QComboBox::activated, this, [this](int index) {
        const std::string key = brdf_->itemData(index).toString().toStdString();
        if (key != core::kFileBrdf) {
            chooseBrdf(key);
            return;
        }
        const QString path = QFileDialog::getOpenFileName(
            this, tr("Material from a file"), RecentFiles::folder(workspace().document()),
            tr("BRDFs: GLSL, or measured in MERL's format (*.brdf.glsl *.binary);;All files (*)"));
        if (!path.isEmpty()) loadBrdf(path);
        refresh();
    });
}

QWidget* MaterialPanel::makeBody() {
    body_ = new QWidget(this);
    auto* bodyLayout = new QVBoxLayout(body_);
    bodyLayout->setContentsMargins(0, 0, 4, 0);
    makeSurfaceGroup();
    makeBlendGroup();
    makeTranslucencyGroup();
    auto* drives = new DriveList(workspace(), body_);
    bodyLayout->addWidget(drives);
    connect(drives, &DriveList::message, this, &MaterialPanel::message);
    connect(drives, &DriveList::error, this, &MaterialPanel::error);
    bodyLayout->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(body_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(body_->minimumSizeHint().width() + 20);
    // Its place is known after the layout.
    connect(drives, &DriveList::rowAdded, this, [scroll](QWidget* row) {
        QTimer::singleShot(0, row, [scroll, row] { scroll->ensureWidgetVisible(row, 0, row->height() / 4); });
    });
    return scroll;
}

MaterialPanel::~MaterialPanel() = default;

ParamSlider* MaterialPanel::addMaterialSlider(const ParamSpec& spec, std::function<void(core::Material&, float)> set) {
    return addSegmentSlider(spec, [set = std::move(set)](core::Segment& segment, float value) {
        if (segment.edit) set(*segment.edit, value);
    });
}

void MaterialPanel::makeSurfaceGroup() {
    auto* group = new QGroupBox(tr("Surface"), body_);
    auto* params = new QWidget(group);
    paramLayout_ = new QVBoxLayout(params);
    paramLayout_->setContentsMargins(0, 0, 0, 0);
    auto* layout = new QVBoxLayout(group);
    makeColors(layout);
    layout->addWidget(params);
    makeFresnel(layout);
    body_->layout()->addWidget(group);
}

void MaterialPanel::makeColors(QVBoxLayout* layout) {
    QWidget* group = layout->parentWidget();
    albedo_ = new ColorButton(QStringLiteral("materialAlbedo"), tr("Diffuse colour"), group);
    specular_ = new ColorButton(QStringLiteral("materialSpecular"), tr("Specular colour"), group);
    specularEstimated_ = new QCheckBox(tr("Estimated"), group);
    specularEstimated_->setObjectName(QStringLiteral("materialSpecularEstimated"));
    specularEstimated_->setToolTip(tr("Use the reflectance estimated from the photograph (glossy segments)"));
    QToolButton* pickAlbedo = makePicker(QStringLiteral("materialAlbedoPick"), tr("Pick diffuse colour"),
                                         [](core::Material& m, const core::Vector3f& color) { m.albedo = color; });
    QToolButton* pickSpecular = makePicker(QStringLiteral("materialSpecularPick"), tr("Pick specular colour"),
                                           [](core::Material& m, const core::Vector3f& color) { m.specular = color; });
    albedoRow_ = makeRow(tr("Diffuse"), {albedo_, pickAlbedo}, group);
    specularRow_ = makeRow(tr("Specular"), {specular_, pickSpecular, specularEstimated_}, group);
    layout->addWidget(albedoRow_);
    layout->addWidget(specularRow_);
    connect(albedo_, &ColorButton::colorChanged, this, [this](const core::Vector3f& color) {
        editMaterial(
            tr("Change diffuse colour"), [&](core::Material& m) { m.albedo = color; }, "albedo");
    });
    connect(specular_, &ColorButton::colorChanged, this, [this](const core::Vector3f& color) {
        editMaterial(
            tr("Change specular colour"), [&](core::Material& m) { m.specular = color; }, "specular");
    });
    connect(specularEstimated_, &QCheckBox::clicked, this, [this](bool on) {
        const core::Vector3f shown = specular_->color();
        editMaterial(on ? tr("Estimate specular colour") : tr("Choose specular colour"), [&](core::Material& m) {
            m.specular.reset();
            if (!on) m.specular = shown;
        });
    });
    for (ColorButton* button : {albedo_, specular_})
        connect(button, &ColorButton::editingFinished, &workspace(), &Workspace::endMerge);
}

QToolButton* MaterialPanel::makePicker(const QString& key, const QString& edit,
                                       std::function<void(core::Material&, const core::Vector3f&)> set) {
    auto* button = new QToolButton(body_);
    button->setObjectName(key);
    button->setText(tr("Pick"));
    button->setAccessibleName(edit);
    button->setToolTip(
        tr("Take the colour of a surface, without its shading, by a click in the picture (Esc: cancel)"));
    button->setCheckable(true);
    connect(button, &QToolButton::clicked, this, [this, button, edit, set = std::move(set)](bool on) {
        if (!on) {
            workspace().pickPixel(nullptr);
            return;
        }
        workspace().pickPixel([this, edit, set](int x, int y) {
            const core::Vector3f color = core::albedoAt(*workspace().scene().photo, workspace().analysis().get(), x, y);
            editMaterial(edit, [&](core::Material& m) { set(m, color); });
        });
        button->setChecked(true);
    });
    connect(&workspace(), &Workspace::pickingChanged, button, [button] { button->setChecked(false); });
    return button;
}

void MaterialPanel::makeFresnel(QVBoxLayout* layout) {
    QWidget* group = layout->parentWidget();
    fresnel_ = new QComboBox(group);
    fresnel_->setObjectName(QStringLiteral("materialFresnel"));
    fresnel_->setAccessibleName(tr("Fresnel"));
    fresnel_->setToolTip(tr("How reflection increases towards grazing angles"));
    fresnel_->addItem(tr("Same at every angle"), static_cast<int>(core::Fresnel::None));
    fresnel_->addItem(tr("Schlick"), static_cast<int>(core::Fresnel::Schlick));
    fresnel_->addItem(tr("Dielectric"), static_cast<int>(core::Fresnel::Dielectric));
    fresnel_->addItem(tr("Conductor"), static_cast<int>(core::Fresnel::Conductor));
    fresnelRow_ = makeRow(tr("Fresnel"), {fresnel_}, group);
    metal_ = new QComboBox(group);
    metal_->setObjectName(QStringLiteral("materialMetal"));
    metal_->setAccessibleName(tr("Metal"));
    metal_->setToolTip(tr("Measured n and k of pure metals"));
    metal_->addItem(tr("Custom"), QString());
    for (const core::Metal& metal : core::metals())
        metal_->addItem(QCoreApplication::translate("metals", metal.label), QString::fromUtf8(metal.key));
    metalRow_ = makeRow(tr("Metal"), {metal_}, group);
    layout->addWidget(fresnelRow_);
    layout->addWidget(metalRow_);
    eta_ = addVector({.key = "materialEta",
                      .label = tr("Index n"),
                      .toolTip = tr("Index of refraction"),
                      .minimum = static_cast<double>(core::kMinIndex),
                      .maximum = static_cast<double>(core::kMaxIndex),
                      .decimals = 3,
                      .edit = tr("Change index of refraction"),
                      .set = [](core::Material& m, const core::Vector3f& value) { m.eta = value; }},
                     layout);
    k_ = addVector({.key = "materialK",
                    .label = tr("Extinction k"),
                    .toolTip = tr("Extinction coefficient of a metal"),
                    .minimum = 0,
                    .maximum = static_cast<double>(core::kMaxIndex),
                    .decimals = 3,
                    .edit = tr("Change extinction"),
                    .set = [](core::Material& m, const core::Vector3f& value) { m.k = value; }},
                   layout);
    connect(fresnel_, &QComboBox::activated, this, [this](int index) {
        const auto mode = static_cast<core::Fresnel>(fresnel_->itemData(index).toInt());
        editMaterial(tr("Change Fresnel"), [&](core::Material& m) { m.fresnel = mode; });
    });
    connect(metal_, &QComboBox::activated, this, [this](int index) {
        const core::Metal* metal = core::findMetal(metal_->itemData(index).toString().toStdString());
        if (metal != nullptr)
            editMaterial(tr("Choose metal"), [&](core::Material& m) { core::setMetal(m, *metal); });
        else
            refresh();
    });
}

VectorEdit* MaterialPanel::addVector(const VectorRow& row, QVBoxLayout* layout) {
    auto* edit =
        new VectorEdit(row.key, row.label, row.toolTip, row.minimum, row.maximum, row.decimals, layout->parentWidget());
    if (!row.unit.isEmpty()) edit->setUnit(row.unit);
    layout->addWidget(edit);
    connect(edit, &VectorEdit::valueChanged, this, [this, row](const core::Vector3f& value) {
        editMaterial(
            row.edit, [&](core::Material& material) { row.set(material, value); }, row.key);
    });
    connect(edit, &VectorEdit::editingFinished, &workspace(), &Workspace::endMerge);
    return edit;
}

void MaterialPanel::makeBlendGroup() {
    auto* group = new QGroupBox(tr("Blend"), body_);
    auto* layout = new QVBoxLayout(group);
    for (const core::MaterialParam& param : core::blendParams()) {
        auto* control = new ParamControl(param, group);
        layout->addWidget(control);
        blend_.push_back(control);
        connectControl(control, [&param](core::Material& m, const core::ParamValue& value) { param.set(m, value); });
    }
    body_->layout()->addWidget(group);
}

void MaterialPanel::connectControl(ParamControl* control,
                                   std::function<void(core::Material&, const core::ParamValue&)> set) {
    connect(control, &ParamControl::edited, this,
            [this, control, set = std::move(set)](const core::ParamValue& value, bool continues) {
                editMaterial(
                    tr("Change %1").arg(control->label()), [&](core::Material& m) { set(m, value); },
                    continues ? control->name() : QString());
            });
    connect(control, &ParamControl::editingFinished, &workspace(), &Workspace::endMerge);
}

void MaterialPanel::makeTranslucencyGroup() {
    translucency_ = new QGroupBox(tr("Translucency"), body_);
    translucency_->setObjectName(QStringLiteral("translucency"));
    translucency_->setAccessibleName(tr("Translucency"));
    translucency_->setCheckable(true);
    translucency_->setToolTip(tr("Light that enters the object, scatters and leaves elsewhere: wax, marble, skin"));
    auto* layout = new QVBoxLayout(translucency_);
    makeSubstance(layout);
    makeCoefficients(layout);
    for (const core::TranslucencyParam& param : core::translucencyParams()) {
        auto* control = new ParamControl(param, translucency_);
        layout->addWidget(control);
        translucencyControls_.push_back(control);
        connectControl(control, [&param](core::Material& m, const core::ParamValue& value) {
            if (m.translucency) param.set(*m.translucency, value);
        });
    }
    body_->layout()->addWidget(translucency_);
    connect(translucency_, &QGroupBox::clicked, this, [this](bool on) {
        editMaterial(on ? tr("Make translucent") : tr("Make opaque"), [&](core::Material& m) {
            m.translucency.reset();
            if (on) m.translucency = core::toTranslucency(core::translucencyPresets().front());
        });
    });
}

void MaterialPanel::makeSubstance(QVBoxLayout* layout) {
    preset_ = new QComboBox(translucency_);
    preset_->setObjectName(QStringLiteral("translucencyPreset"));
    preset_->setAccessibleName(tr("Substance"));
    preset_->setToolTip(tr("Measured substances"));
    preset_->addItem(tr("Custom"), QString());
    for (const core::TranslucencyPreset& preset : core::translucencyPresets())
        preset_->addItem(QCoreApplication::translate("presets", preset.label), QString::fromUtf8(preset.key));
    diffusionColor_ = new ColorButton(QStringLiteral("translucencyColor"), tr("Colour"), translucency_);
    diffusionColor_->setToolTip(tr("Colour of a thick piece; changes absorption and scattering"));
    layout->addWidget(makeRow(tr("Substance"), {preset_}, translucency_));
    layout->addWidget(makeRow(tr("Colour"), {diffusionColor_}, translucency_));
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        const std::string key = preset_->itemData(index).toString().toStdString();
        editMaterial(tr("Choose substance"), [&](core::Material& m) {
            if (m.translucency) choosePreset(*m.translucency, key);
        });
    });
    connect(diffusionColor_, &ColorButton::colorChanged, this, [this](const core::Vector3f& value) {
        editMaterial(
            tr("Change diffusion colour"),
            [&](core::Material& m) {
                if (m.translucency) setLook(*m.translucency, value, core::diffuseMeanFreePath(*m.translucency));
            },
            "translucencyColor");
    });
    connect(diffusionColor_, &ColorButton::editingFinished, &workspace(), &Workspace::endMerge);
}

void MaterialPanel::makeCoefficients(QVBoxLayout* layout) {
    const auto coefficient = [](core::Vector3f core::Translucency::*member) {
        return [member](core::Material& m, const core::Vector3f& value) {
            if (!m.translucency) return;
            (*m.translucency).*member = value;
            m.translucency->preset.clear();
        };
    };
    freePath_ = addVector({.key = "translucencyFreePath",
                           .label = tr("Free path"),
                           .toolTip = tr("Depth that light reaches [mm]; changes absorption and scattering"),
                           .unit = tr("mm"),
                           .minimum = 0.001,
                           .maximum = static_cast<double>(core::kMaxMeanFreePath),
                           .decimals = 3,
                           .edit = tr("Change free path"),
                           .set =
                               [](core::Material& m, const core::Vector3f& value) {
                                   if (!m.translucency) return;
                                   setLook(*m.translucency, core::diffuseReflectance(*m.translucency), value);
                               }},
                          layout);
    sigmaA_ = addVector({.key = "translucencySigmaA",
                         .label = tr("Absorption"),
                         .toolTip = tr("Absorption coefficient [1/mm]"),
                         .unit = tr("1/mm"),
                         .minimum = 0,
                         .maximum = 100,
                         .decimals = 4,
                         .edit = tr("Change absorption"),
                         .set = coefficient(&core::Translucency::sigmaA)},
                        layout);
    sigmaSPrime_ = addVector({.key = "translucencySigmaSPrime",
                              .label = tr("Scattering"),
                              .toolTip = tr("Reduced scattering coefficient [1/mm]"),
                              .unit = tr("1/mm"),
                              .minimum = 0.0001,
                              .maximum = 1000,
                              .decimals = 3,
                              .edit = tr("Change scattering"),
                              .set = coefficient(&core::Translucency::sigmaSPrime)},
                             layout);
}

void MaterialPanel::rebuildParams(const core::Material& material) {
    if (material.brdf == paramsOf_ && material.brdfFile == paramsFile_) return;
    paramsOf_ = material.brdf;
    paramsFile_ = material.brdfFile;
    for (ParamSlider* slider : params_) slider->deleteLater();
    params_.clear();
    const core::BrdfInfo* info = core::findBrdf(material);
    if (info == nullptr || !core::usable(material)) return;
    for (std::size_t i = 0; i < info->params.size(); ++i) {
        const core::ParamInfo& param = info->params[i];
        const QString label = QCoreApplication::translate("params", param.label);
        ParamSlider* slider = addMaterialSlider({.key = QString::fromUtf8(param.key),
                                                 .label = label,
                                                 .unit = QString::fromUtf8(param.unit),
                                                 .toolTip = {},
                                                 .minimum = static_cast<double>(param.min),
                                                 .maximum = static_cast<double>(param.max),
                                                 .initial = static_cast<double>(param.initial),
                                                 .logarithmic = param.logScale,
                                                 .decimals = param.max >= 100 ? 1 : 4},
                                                [i](core::Material& m, float v) { m.values.at(i) = v; });
        paramLayout_->addWidget(slider);
        params_.push_back(slider);
    }
}

void MaterialPanel::chooseBrdf(const std::string& key) {
    const core::BrdfInfo* info = core::findBrdf(key);
    const core::Segment* segment = workspace().selectedSegment();
    if (segment == nullptr) return;
    if (info == nullptr) {
        if (!segment->edit) {
            refresh();
            return;
        }
        workspace().keepMaterial(segment->label, *segment->edit);
        workspace().editSelected(tr("Remove edit"), [](core::Segment& s) { s.edit.reset(); });
        return;
    }
    setBrdf(tr("Change material to %1").arg(QCoreApplication::translate("brdfs", info->label)),
            core::defaultMaterial(*info));
}

void MaterialPanel::setBrdf(const QString& label, const core::Material& fresh) {
    const core::Segment* segment = workspace().selectedSegment();
    if (segment == nullptr) return;
    if (segment->edit) workspace().keepMaterial(segment->label, *segment->edit);
    const core::Material* kept = workspace().keptMaterial(segment->label, fresh);
    core::Material next = kept != nullptr ? *kept : fresh;
    if (kept == nullptr && !segment->edit)
        next.albedo = core::segmentAlbedo(*workspace().scene().photo, workspace().analysis().get(), segment->label);
    if (kept != nullptr && fresh.brdfFile != nullptr) next = core::withReloadedFile(next, fresh.brdfFile);
    if (segment->edit) takeCommonParts(next, *segment->edit);
    workspace().editSelected(label, [&](core::Segment& s) { s.edit = next; });
    refresh();
}

void MaterialPanel::readFile(const std::string& path, const Loaded& then,
                             const std::function<void(const QString&)>& otherwise) {
    const auto file = std::make_shared<std::shared_ptr<const core::BrdfFile>>();
    loading_ =
        std::make_unique<BackgroundTask>([path, file](const core::Progress&) { *file = core::loadBrdfFile(path); });
    const auto ended = [this] {
        emit message({});
        if (!changed_.empty()) QTimer::singleShot(0, this, &MaterialPanel::reloadChanged);
    };
    connect(loading_.get(), &BackgroundTask::failed, this, [ended, otherwise](const QString& sentence) {
        ended();
        otherwise(sentence);
    });
    connect(loading_.get(), &BackgroundTask::succeeded, this, [ended, then, file] {
        ended();
        then(*file);
    });
    emit message(tr("Loading %1").arg(QFileInfo(QString::fromStdString(path)).fileName()));
    loading_->start();
}

void MaterialPanel::loadBrdf(const QString& path) {
    const std::uint16_t label = workspace().selectedLabel();
    readFile(
        path.toStdString(),
        [this, label](const std::shared_ptr<const core::BrdfFile>& file) {
            if (workspace().selectedLabel() != label) return;
            fileProblem_.clear();
            setBrdf(tr("Change material to %1").arg(QString::fromStdString(file->name)), core::fileMaterial(file));
        },
        [this](const QString& sentence) { emit error(sentence); });
}

QStringList MaterialPanel::brdfFiles() const {
    QStringList files;
    for (const core::Segment& segment : workspace().scene().segments) {
        if (!segment.edit || !segment.edit->brdfFile) continue;
        const QString path = QString::fromStdString(segment.edit->brdfFile->path);
        if (!files.contains(path)) files << path;
    }
    return files;
}

void MaterialPanel::watchFiles() {
    QStringList wanted;
    for (const QString& path : brdfFiles()) {
        // A missing file is watched through its folder.
        const QString watched = QFileInfo::exists(path) ? path : QFileInfo(path).absolutePath();
        if (!wanted.contains(watched)) wanted << watched;
    }
    const QStringList watched = watcher_->files() + watcher_->directories();
    for (const QString& path : watched)
        if (!wanted.contains(path)) watcher_->removePath(path);
    for (const QString& path : wanted)
        if (!watched.contains(path)) watcher_->addPath(path);
}

void MaterialPanel::reloadSoon(const QString& path) {
    changed_.insert(path.toStdString());
    QTimer::singleShot(kReloadDelayMs, this, &MaterialPanel::reloadChanged);
}

void MaterialPanel::reloadChanged() {
    if (changed_.empty() || (loading_ != nullptr && loading_->running())) return;
    const std::string path = *changed_.begin();
    changed_.erase(changed_.begin());
    readFile(
        path,
        [this, path](const std::shared_ptr<const core::BrdfFile>& file) {
            fileProblem_.clear();
            workspace().editScene(tr("Reload %1").arg(QString::fromStdString(file->name)), [&](core::Scene& scene) {
                for (core::Segment& segment : scene.segments)
                    if (segment.edit && segment.edit->brdfFile && segment.edit->brdfFile->path == path)
                        segment.edit = core::withReloadedFile(*segment.edit, file);
            });
            watchFiles();
            refresh();
        },
        [this](const QString& sentence) {
            fileProblem_ = sentence;
            watchFiles();
            refresh();
        });
}

void MaterialPanel::showFile(const core::Material& material) {
    file_->setVisible(material.brdfFile != nullptr);
    if (!material.brdfFile) return;
    const core::BrdfFile& file = *material.brdfFile;
    QString text = QString::fromStdString(file.name);
    if (!file.problem.empty())
        text = tr("Shown as photographed: %1").arg(translated(file.problem));
    else if (!fileProblem_.isEmpty())
        text = tr("Showing the last valid version: %1").arg(fileProblem_);
    file_->setText(text);
    file_->setToolTip(QString::fromStdString(file.path));
}

void MaterialPanel::editMaterial(const QString& label, const std::function<void(core::Material&)>& change,
                                 const QString& mergeKey) {
    const core::Segment* segment = workspace().selectedSegment();
    if (segment == nullptr || !segment->edit) return;
    workspace().editSelected(
        label, [&](core::Segment& s) { change(*s.edit); }, mergeKey);
}

void MaterialPanel::refresh() {
    const core::Segment* segment = workspace().selectedSegment();
    const bool edited = segment != nullptr && segment->edit.has_value();
    title_->setText(segment != nullptr       ? QString::fromStdString(segment->name)
                    : workspace().hasPhoto() ? tr("Click a segment in the picture or in the list")
                                             : tr("No project open"));
    const bool depth = workspace().hasDepth();
    hint_->setVisible(workspace().hasPhoto() && !depth);
    brdf_->setEnabled(segment != nullptr && depth);
    body_->setEnabled(depth);
    remove_->setEnabled(edited);
    scroll_->setVisible(edited);
    showFile(edited ? *segment->edit : core::Material());
    const QSignalBlocker blockBrdf(brdf_);
    brdf_->setCurrentIndex(edited ? brdf_->findData(QString::fromStdString(segment->edit->brdf)) : 0);
    if (!edited) return;

    const core::Material& material = *segment->edit;
    rebuildParams(material);
    for (std::size_t i = 0; i < params_.size(); ++i) params_[i]->setValue(static_cast<double>(material.values.at(i)));
    refreshColors(*segment);
    refreshFresnel(material);
    for (std::size_t i = 0; i < blend_.size(); ++i) blend_[i]->setValue(core::blendParams()[i].get(material));
    refreshTranslucency(material);
}

void MaterialPanel::refreshColors(const core::Segment& segment) {
    const core::Material& material = *segment.edit;
    const core::BrdfInfo* info = core::usable(material) ? core::findBrdf(material) : nullptr;
    albedoRow_->setVisible(info != nullptr && info->usesAlbedo);
    albedo_->setColor(material.albedo);
    specularRow_->setVisible(info != nullptr && info->usesSpecular);
    specularEstimated_->setChecked(!material.specular.has_value());
    specular_->setEnabled(material.specular.has_value());
    const auto& analysis = workspace().analysis();
    const core::Reflectance* found = analysis != nullptr ? analysis->findReflectance(segment.label) : nullptr;
    const core::Vector3f estimate = found != nullptr ? found->rho : core::Vector3f(1, 1, 1);
    specular_->setColor(material.specular.value_or(segment.reflectance.value_or(estimate)));
}

void MaterialPanel::refreshFresnel(const core::Material& material) {
    const core::BrdfInfo* info = core::usable(material) ? core::findBrdf(material) : nullptr;
    const bool specular = info != nullptr && info->usesSpecular;
    const auto* user = specular && material.brdfFile ? material.brdfFile->user.get() : nullptr;
    const bool fresnel = specular && (user == nullptr || user->usesFresnel);
    const bool conductor = fresnel && material.fresnel == core::Fresnel::Conductor;
    const bool dielectric = fresnel && material.fresnel == core::Fresnel::Dielectric;
    fresnelRow_->setVisible(fresnel);
    const QSignalBlocker blockFresnel(fresnel_);
    fresnel_->setCurrentIndex(fresnel_->findData(static_cast<int>(material.fresnel)));
    eta_->setVisible(dielectric || conductor);
    k_->setVisible(conductor);
    metalRow_->setVisible(conductor);
    const core::Metal* metal = core::metalOf(material);
    const QSignalBlocker blockMetal(metal_);
    metal_->setCurrentIndex(metal == nullptr ? 0 : metal_->findData(QString::fromUtf8(metal->key)));
    eta_->setValue(material.eta);
    k_->setValue(material.k);
}

void MaterialPanel::refreshTranslucency(const core::Material& material) {
    translucency_->setChecked(material.translucency.has_value());
    const core::Translucency shown = material.translucency.value_or(core::Translucency());
    const QSignalBlocker blockPreset(preset_);
    preset_->setCurrentIndex(std::max(0, preset_->findData(QString::fromStdString(shown.preset))));
    diffusionColor_->setColor(core::diffuseReflectance(shown));
    freePath_->setValue(core::diffuseMeanFreePath(shown));
    sigmaA_->setValue(shown.sigmaA);
    sigmaSPrime_->setValue(shown.sigmaSPrime);
    for (std::size_t i = 0; i < translucencyControls_.size(); ++i)
        translucencyControls_[i]->setValue(core::translucencyParams()[i].get(shown));
}

}  // namespace ui
