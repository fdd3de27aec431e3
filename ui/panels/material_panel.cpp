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
#include <QVBoxLayout>
#include <utility>

#include "core/material/brdf_file.h"
#include "core/material/drive_parameters.h"
#include "core/material/metals.h"
#include "core/material/translucency.h"
#include "ui/background_task.h"
#include "ui/panels/drive_list.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/param_slider.h"
#include "ui/widgets/vector_edit.h"
#include "ui/words.h"

namespace ui {

namespace {

/// Editors write a file in several steps.
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

}  // namespace

MaterialPanel::MaterialPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    title_ = new QLabel(this);
    title_->setObjectName(QStringLiteral("materialTitle"));
    brdf_ = new QComboBox(this);
    brdf_->setObjectName(QStringLiteral("materialBrdf"));
    brdf_->setAccessibleName(tr("Material"));
    brdf_->setToolTip(tr("How the new surface reflects light"));
    brdf_->addItem(tr("As photographed"), QString());
    for (const core::BrdfInfo& info : core::brdfs()) {
        brdf_->addItem(QCoreApplication::translate("brdfs", info.label), QString::fromUtf8(info.key));
    }
    brdf_->addItem(tr("From a file…"), QString::fromLatin1(core::kFileBrdf));
    file_ = new QLabel(this);
    file_->setObjectName(QStringLiteral("materialFile"));
    file_->setWordWrap(true);
    file_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    watcher_ = new QFileSystemWatcher(this);
    remove_ = new QPushButton(tr("Remove edit"), this);
    remove_->setObjectName(QStringLiteral("removeEdit"));
    remove_->setToolTip(tr("Show the segment as it was photographed"));

    auto* inner = new QWidget(this);
    body_ = inner;
    auto* bodyLayout = new QVBoxLayout(inner);
    bodyLayout->setContentsMargins(0, 0, 4, 0);
    makeSurfaceGroup();
    makeBlendGroup();
    makeTranslucencyGroup();
    auto* drives = new DriveList(workspace, inner);
    bodyLayout->addWidget(drives);
    connect(drives, &DriveList::message, this, &MaterialPanel::message);
    connect(drives, &DriveList::error, this, &MaterialPanel::error);
    bodyLayout->addStretch(1);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(inner);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(inner->minimumSizeHint().width() + 20);

    auto* top = new QHBoxLayout;
    top->addWidget(title_, 1);
    top->addWidget(remove_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 4, 8);
    layout->addLayout(top);
    layout->addWidget(brdf_);
    layout->addWidget(file_);
    layout->addWidget(scroll, 1);

    connect(brdf_, &QComboBox::activated, this, [this](int index) {
        const std::string key = brdf_->itemData(index).toString().toStdString();
        if (key != core::kFileBrdf) {
            chooseBrdf(key);
            return;
        }
        const QString path = QFileDialog::getOpenFileName(
            this, tr("Material from a file"), {},
            tr("BRDFs: GLSL, or measured in MERL's format (*.brdf.glsl *.binary);;All files (*)"));
        if (!path.isEmpty()) loadBrdf(path);
        refresh();
    });
    connect(watcher_, &QFileSystemWatcher::fileChanged, this, &MaterialPanel::reloadSoon);
    connect(watcher_, &QFileSystemWatcher::directoryChanged, this, [this] {
        const QStringList known = watcher_->files();
        for (const QString& path : brdfFiles())
            if (!known.contains(path) && QFileInfo::exists(path)) reloadSoon(path);
    });
    connect(&workspace, &Workspace::documentReplaced, this, [this] { fileProblem_.clear(); });
    connect(&workspace, &Workspace::sceneChanged, this, &MaterialPanel::watchFiles);
    connect(remove_, &QPushButton::clicked, this, [this] { chooseBrdf({}); });
    connect(&workspace, &Workspace::sceneChanged, this, &MaterialPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &MaterialPanel::refresh);
    connect(&workspace, &Workspace::analysisChanged, this, &MaterialPanel::refresh);
    refresh();
}

MaterialPanel::~MaterialPanel() = default;

ParamSlider* MaterialPanel::addMaterialSlider(const ParamSpec& spec, std::function<void(core::Material&, float)> set) {
    return addSegmentSlider(spec, [set = std::move(set)](core::Segment& segment, float value) {
        if (segment.edit) set(*segment.edit, value);
    });
}

void MaterialPanel::makeSurfaceGroup() {
    auto* group = new QGroupBox(tr("Surface"), body_);
    albedo_ = new ColorButton(QStringLiteral("materialAlbedo"), tr("Diffuse colour"), group);
    specular_ = new ColorButton(QStringLiteral("materialSpecular"), tr("Specular colour"), group);
    specularEstimated_ = new QCheckBox(tr("Estimated"), group);
    specularEstimated_->setObjectName(QStringLiteral("materialSpecularEstimated"));
    specularEstimated_->setToolTip(tr("Use the reflectance estimated from the photograph (glossy segments)"));
    albedoRow_ = makeRow(tr("Diffuse"), {albedo_}, group);
    specularRow_ = makeRow(tr("Specular"), {specular_, specularEstimated_}, group);
    auto* params = new QWidget(group);
    paramLayout_ = new QVBoxLayout(params);
    paramLayout_->setContentsMargins(0, 0, 0, 0);
    fresnel_ = new QComboBox(group);
    fresnel_->setObjectName(QStringLiteral("materialFresnel"));
    fresnel_->setAccessibleName(tr("Fresnel"));
    fresnel_->setToolTip(tr("How reflection grows towards grazing angles"));
    fresnel_->addItem(tr("Same at every angle"), static_cast<int>(core::Fresnel::None));
    fresnel_->addItem(tr("Schlick"), static_cast<int>(core::Fresnel::Schlick));
    fresnel_->addItem(tr("Dielectric"), static_cast<int>(core::Fresnel::Dielectric));
    fresnel_->addItem(tr("Conductor"), static_cast<int>(core::Fresnel::Conductor));
    fresnelRow_ = makeRow(tr("Fresnel"), {fresnel_}, group);
    metal_ = new QComboBox(group);
    metal_->setObjectName(QStringLiteral("materialMetal"));
    metal_->setAccessibleName(tr("Metal"));
    metal_->setToolTip(tr("Measured n and k of pure metals"));
    metal_->addItem(tr("By hand"), QString());
    for (const core::Metal& metal : core::metals()) {
        metal_->addItem(QCoreApplication::translate("metals", metal.label), QString::fromUtf8(metal.key));
    }
    metalRow_ = makeRow(tr("Metal"), {metal_}, group);
    eta_ = new VectorEdit(QStringLiteral("materialEta"), tr("Index n"), tr("Index of refraction"), 0.01, 20, 3, group);
    k_ = new VectorEdit(QStringLiteral("materialK"), tr("Extinction k"), tr("Extinction coefficient of a metal"), 0, 20,
                        3, group);

    auto* layout = new QVBoxLayout(group);
    layout->addWidget(albedoRow_);
    layout->addWidget(specularRow_);
    layout->addWidget(params);
    layout->addWidget(fresnelRow_);
    layout->addWidget(metalRow_);
    layout->addWidget(eta_);
    layout->addWidget(k_);
    body_->layout()->addWidget(group);

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
    connect(eta_, &VectorEdit::valueChanged, this, [this](const core::Vector3f& value) {
        editMaterial(
            tr("Change index of refraction"), [&](core::Material& m) { m.eta = value; }, "eta");
    });
    connect(k_, &VectorEdit::valueChanged, this, [this](const core::Vector3f& value) {
        editMaterial(
            tr("Change extinction"), [&](core::Material& m) { m.k = value; }, "k");
    });
    for (ColorButton* button : {albedo_, specular_}) {
        connect(button, &ColorButton::editingFinished, &workspace(), &Workspace::endMerge);
    }
    for (VectorEdit* edit : {eta_, k_}) connect(edit, &VectorEdit::editingFinished, &workspace(), &Workspace::endMerge);
}

void MaterialPanel::makeBlendGroup() {
    auto* group = new QGroupBox(tr("Blend"), body_);
    blendNew_ = addMaterialSlider({.key = "blendNew",
                                   .label = tr("New"),
                                   .unit = {},
                                   .toolTip = tr("Weight of the new surface"),
                                   .minimum = 0,
                                   .maximum = 2,
                                   .initial = 1,
                                   .decimals = 2},
                                  [](core::Material& m, float v) { m.blendNew = v; });
    blendOriginal_ = addMaterialSlider({.key = "blendOriginal",
                                        .label = tr("Photograph"),
                                        .unit = {},
                                        .toolTip = tr("Weight of the photograph underneath"),
                                        .minimum = 0,
                                        .maximum = 2,
                                        .initial = 0,
                                        .decimals = 2},
                                       [](core::Material& m, float v) { m.blendOriginal = v; });
    auto* layout = new QVBoxLayout(group);
    layout->addWidget(blendNew_);
    layout->addWidget(blendOriginal_);
    body_->layout()->addWidget(group);
}

void MaterialPanel::makeTranslucencyGroup() {
    translucency_ = new QGroupBox(tr("Translucency"), body_);
    translucency_->setObjectName(QStringLiteral("translucency"));
    translucency_->setAccessibleName(tr("Translucency"));
    translucency_->setCheckable(true);
    translucency_->setToolTip(tr("Light that enters the object, scatters and leaves elsewhere: wax, marble, skin"));
    preset_ = new QComboBox(translucency_);
    preset_->setObjectName(QStringLiteral("translucencyPreset"));
    preset_->setAccessibleName(tr("Substance"));
    preset_->setToolTip(tr("Measured substances"));
    preset_->addItem(tr("By hand"), QString());
    for (const core::TranslucencyPreset& preset : core::translucencyPresets()) {
        preset_->addItem(QCoreApplication::translate("presets", preset.label), QString::fromUtf8(preset.key));
    }
    scatteringModel_ = new QComboBox(translucency_);
    scatteringModel_->setObjectName(QStringLiteral("translucencyModel"));
    scatteringModel_->setAccessibleName(tr("Model"));
    scatteringModel_->setToolTip(
        tr("How light spreads: the better dipole is nearer to the truth where much is absorbed"));
    scatteringModel_->addItem(tr("Dipole"));
    scatteringModel_->addItem(tr("Better dipole"));
    diffusionColor_ = new ColorButton(QStringLiteral("translucencyColor"), tr("Colour"), translucency_);
    diffusionColor_->setToolTip(tr("Colour of a thick piece; changes absorption and scattering"));
    freePath_ = new VectorEdit(QStringLiteral("translucencyFreePath"), tr("Free path"),
                               tr("How far light gets below the surface [mm]; changes absorption and scattering"),
                               0.001, static_cast<double>(core::kLongestFreePath), 3, translucency_);
    sigmaA_ = new VectorEdit(QStringLiteral("translucencySigmaA"), tr("Absorption"),
                             tr("Absorption coefficient [1/mm]"), 0, 100, 4, translucency_);
    sigmaSPrime_ = new VectorEdit(QStringLiteral("translucencySigmaSPrime"), tr("Scattering"),
                                  tr("Reduced scattering coefficient [1/mm]"), 0.0001, 1000, 3, translucency_);
    freePath_->setUnit(tr("mm"));
    for (VectorEdit* coefficient : {sigmaA_, sigmaSPrime_}) coefficient->setUnit(tr("1/mm"));
    const auto slider = [this](const ParamSpec& spec, std::function<void(core::Translucency&, float)> set) {
        return addMaterialSlider(spec, [set = std::move(set)](core::Material& material, float value) {
            if (material.translucency) set(*material.translucency, value);
        });
    };
    translucencyEta_ = slider({.key = "translucencyEta",
                               .label = tr("Index"),
                               .unit = {},
                               .toolTip = tr("Relative index of refraction; 1 = no boundary"),
                               .minimum = 1,
                               .maximum = 2.5,
                               .initial = 1.3,
                               .decimals = 2},
                              [](core::Translucency& t, float v) { t.eta = v; });
    translucencyScale_ =
        slider({.key = "translucencyScale",
                .label = tr("Size"),
                .unit = {},
                .toolTip = tr("Pretend the object is this many times as large: larger is less translucent"),
                .minimum = 0.01,
                .maximum = 100,
                .initial = 1,
                .logarithmic = true,
                .decimals = 2},
               [](core::Translucency& t, float v) { t.scale = v; });
    translucencyWeight_ = slider({.key = "translucencyWeight",
                                  .label = tr("Weight"),
                                  .unit = {},
                                  .toolTip = tr("Factor on the light that was scattered inside"),
                                  .minimum = 0,
                                  .maximum = 4,
                                  .initial = 1,
                                  .decimals = 2},
                                 [](core::Translucency& t, float v) { t.weight = v; });
    auto* layout = new QVBoxLayout(translucency_);
    layout->addWidget(makeRow(tr("Substance"), {preset_}, translucency_));
    layout->addWidget(makeRow(tr("Colour"), {diffusionColor_}, translucency_));
    layout->addWidget(freePath_);
    layout->addWidget(sigmaA_);
    layout->addWidget(sigmaSPrime_);
    layout->addWidget(makeRow(tr("Model"), {scatteringModel_}, translucency_));
    layout->addWidget(translucencyEta_);
    layout->addWidget(translucencyScale_);
    layout->addWidget(translucencyWeight_);
    body_->layout()->addWidget(translucency_);

    connect(translucency_, &QGroupBox::clicked, this, [this](bool on) {
        editMaterial(on ? tr("Make translucent") : tr("Make opaque"), [&](core::Material& m) {
            m.translucency.reset();
            if (on) m.translucency = core::toTranslucency(core::translucencyPresets().front());
        });
    });
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        const std::string key = preset_->itemData(index).toString().toStdString();
        editTranslucency(tr("Choose substance"),
                         [&](core::Translucency& t) {
                             const core::TranslucencyPreset* preset = core::findTranslucencyPreset(key);
                             t.preset = key;
                             if (preset == nullptr) return;
                             const core::Translucency values = core::toTranslucency(*preset);
                             t.preset = values.preset;
                             t.sigmaA = values.sigmaA;
                             t.sigmaSPrime = values.sigmaSPrime;
                             t.eta = values.eta;
                         },
                         {});
    });
    connect(scatteringModel_, &QComboBox::activated, this, [this](int index) {
        editTranslucency(tr("Change scattering model"),
                         [index](core::Translucency& t) { t.model = static_cast<core::ScatteringModel>(index); }, {});
    });
    const auto look = [](core::Translucency& t, const core::Vector3f& color, const core::Vector3f& freePath) {
        const core::Translucency wanted = core::translucencyFromDiffuse(color, freePath, t.eta, t.model);
        t.sigmaA = wanted.sigmaA;
        t.sigmaSPrime = wanted.sigmaSPrime;
        t.preset.clear();
    };
    connect(diffusionColor_, &ColorButton::colorChanged, this, [this, look](const core::Vector3f& value) {
        editTranslucency(
            tr("Change diffusion colour"), [&](core::Translucency& t) { look(t, value, core::diffuseMeanFreePath(t)); },
            "translucencyColor");
    });
    connect(diffusionColor_, &ColorButton::editingFinished, &workspace(), &Workspace::endMerge);
    connect(freePath_, &VectorEdit::valueChanged, this, [this, look](const core::Vector3f& value) {
        editTranslucency(
            tr("Change free path"), [&](core::Translucency& t) { look(t, core::diffuseReflectance(t), value); },
            "translucencyFreePath");
    });
    connect(sigmaA_, &VectorEdit::valueChanged, this, [this](const core::Vector3f& value) {
        editTranslucency(
            tr("Change absorption"),
            [&](core::Translucency& t) {
                t.sigmaA = value;
                t.preset.clear();
            },
            "sigmaA");
    });
    connect(sigmaSPrime_, &VectorEdit::valueChanged, this, [this](const core::Vector3f& value) {
        editTranslucency(
            tr("Change scattering"),
            [&](core::Translucency& t) {
                t.sigmaSPrime = value;
                t.preset.clear();
            },
            "sigmaSPrime");
    });
    for (VectorEdit* edit : {sigmaA_, sigmaSPrime_, freePath_}) {
        connect(edit, &VectorEdit::editingFinished, &workspace(), &Workspace::endMerge);
    }
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
        workspace().editSelected(tr("Remove edit"), [](core::Segment& s) { s.edit.reset(); });
        return;
    }
    setBrdf(tr("Change material to %1").arg(QCoreApplication::translate("brdfs", info->label)),
            core::defaultMaterial(*info));
}

void MaterialPanel::setBrdf(const QString& label, const core::Material& fresh) {
    workspace().editSelected(label, [&](core::Segment& s) {
        core::Material next = fresh;
        if (s.edit) {
            next.albedo = s.edit->albedo;
            next.specular = s.edit->specular;
            next.blendNew = s.edit->blendNew;
            next.blendOriginal = s.edit->blendOriginal;
            next.translucency = s.edit->translucency;
            next.drives = core::knownDrives(s.edit->drives, next);
        }
        s.edit = next;
    });
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
        // Of a file that is not there its folder tells when it comes.
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
        text = tr("Its last usable state is shown: %1").arg(fileProblem_);
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

void MaterialPanel::editTranslucency(const QString& label, const std::function<void(core::Translucency&)>& change,
                                     const QString& mergeKey) {
    editMaterial(
        label,
        [&](core::Material& m) {
            if (m.translucency) change(*m.translucency);
        },
        mergeKey);
}

void MaterialPanel::refresh() {
    const core::Segment* segment = workspace().selectedSegment();
    const bool edited = segment != nullptr && segment->edit.has_value();
    title_->setText(segment != nullptr       ? QString::fromStdString(segment->name)
                    : workspace().hasPhoto() ? tr("Click a segment in the picture or in the list")
                                             : tr("Nothing is open"));
    brdf_->setEnabled(segment != nullptr);
    remove_->setEnabled(edited);
    body_->setVisible(edited);
    showFile(edited ? *segment->edit : core::Material());
    const QSignalBlocker blockBrdf(brdf_);
    brdf_->setCurrentIndex(edited ? brdf_->findData(QString::fromStdString(segment->edit->brdf)) : 0);
    if (!edited) return;

    const core::Material& material = *segment->edit;
    const core::BrdfInfo* info = core::usable(material) ? core::findBrdf(material) : nullptr;
    rebuildParams(material);
    for (std::size_t i = 0; i < params_.size(); ++i) params_[i]->setValue(static_cast<double>(material.values.at(i)));
    const bool specular = info != nullptr && info->usesSpecular;
    albedoRow_->setVisible(info != nullptr && info->usesAlbedo);
    albedo_->setColor(material.albedo);
    specularRow_->setVisible(specular);
    specularEstimated_->setChecked(!material.specular.has_value());
    specular_->setEnabled(material.specular.has_value());
    const auto& analysis = workspace().analysis();
    const core::Reflectance* found = analysis != nullptr ? analysis->findReflectance(segment->label) : nullptr;
    specular_->setColor(material.specular
                            ? *material.specular
                            : segment->reflectance.value_or(found != nullptr ? found->rho : core::Vector3f(1, 1, 1)));
    const auto* user = specular && material.brdfFile ? material.brdfFile->user.get() : nullptr;
    const bool fresnel = specular && (user == nullptr || user->usesFresnel);
    fresnelRow_->setVisible(fresnel);
    const QSignalBlocker blockFresnel(fresnel_);
    fresnel_->setCurrentIndex(fresnel_->findData(static_cast<int>(material.fresnel)));
    eta_->setVisible(fresnel &&
                     (material.fresnel == core::Fresnel::Dielectric || material.fresnel == core::Fresnel::Conductor));
    k_->setVisible(fresnel && material.fresnel == core::Fresnel::Conductor);
    metalRow_->setVisible(fresnel && material.fresnel == core::Fresnel::Conductor);
    const core::Metal* metal = core::metalOf(material);
    const QSignalBlocker blockMetal(metal_);
    metal_->setCurrentIndex(metal == nullptr ? 0 : metal_->findData(QString::fromUtf8(metal->key)));
    eta_->setValue(material.eta);
    k_->setValue(material.k);
    blendNew_->setValue(static_cast<double>(material.blendNew));
    blendOriginal_->setValue(static_cast<double>(material.blendOriginal));

    translucency_->setChecked(material.translucency.has_value());
    const core::Translucency shown = material.translucency.value_or(core::Translucency());
    const QSignalBlocker blockPreset(preset_);
    preset_->setCurrentIndex(std::max(0, preset_->findData(QString::fromStdString(shown.preset))));
    scatteringModel_->setCurrentIndex(static_cast<int>(shown.model));
    diffusionColor_->setColor(core::diffuseReflectance(shown));
    freePath_->setValue(core::diffuseMeanFreePath(shown));
    sigmaA_->setValue(shown.sigmaA);
    sigmaSPrime_->setValue(shown.sigmaSPrime);
    translucencyEta_->setValue(static_cast<double>(shown.eta));
    translucencyScale_->setValue(static_cast<double>(shown.scale));
    translucencyWeight_->setValue(static_cast<double>(shown.weight));
}

}  // namespace ui
