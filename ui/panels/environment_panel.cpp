// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/environment_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <numbers>

#include "core/io/image_io.h"
#include "ui/background_task.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/map_view.h"
#include "ui/widgets/param_slider.h"

namespace ui {

namespace {
enum MapChoice { kEnvironment, kReflected, kIncident };
constexpr float kDegrees = 180 / std::numbers::pi_v<float>;
}  // namespace

EnvironmentPanel::EnvironmentPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    which_ = new QComboBox(this);
    which_->setObjectName(QStringLiteral("environmentMap"));
    which_->setAccessibleName(tr("Map shown"));
    which_->setToolTip(tr("The light around the scene, or what is known about the selected glossy segment"));
    which_->addItem(tr("Light around the scene"), kEnvironment);
    which_->addItem(tr("Reflected by the segment (L_S)"), kReflected);
    which_->addItem(tr("Arriving at the segment (L_G)"), kIncident);
    map_ = new MapView(this);
    map_->setObjectName(QStringLiteral("environmentView"));
    map_->setAccessibleName(tr("Directional map"));
    hover_ = new QLabel(this);
    hover_->setObjectName(QStringLiteral("environmentHover"));
    hover_->setWordWrap(true);
    hover_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    hover_->setAlignment(Qt::AlignTop);
    coverage_ = new QCheckBox(tr("Mark what is guessed"), this);
    coverage_->setObjectName(QStringLiteral("environmentCoverage"));
    coverage_->setToolTip(tr("Hatch the directions nothing in the photograph reflects; they are interpolated"));
    exposure_ = new ParamSlider({.key = "environmentExposure",
                                 .label = tr("View exposure"),
                                 .unit = tr("EV"),
                                 .toolTip = tr("Brightness of this view only"),
                                 .minimum = -8,
                                 .maximum = 8,
                                 .initial = 0,
                                 .decimals = 1},
                                this);

    auto* file = new QGroupBox(tr("Source"), this);
    source_ = new QLabel(file);
    source_->setObjectName(QStringLiteral("environmentSource"));
    source_->setWordWrap(true);
    load_ = new QPushButton(tr("Load HDRI…"), file);
    load_->setObjectName(QStringLiteral("loadEnvironment"));
    load_->setToolTip(tr("Light the edits with a latitude-longitude map (EXR or HDR) in place of the recovered one"));
    recover_ = new QPushButton(tr("Recover"), file);
    recover_->setObjectName(QStringLiteral("recoverEnvironment"));
    recover_->setToolTip(tr("Go back to the light recovered from the photograph"));
    rotation_ = addSceneSlider({.key = "environmentRotation",
                                .label = tr("Rotation"),
                                .unit = tr("°"),
                                .toolTip = tr("Turns the light about the vertical axis of the camera"),
                                .minimum = -180,
                                .maximum = 180,
                                .initial = 0,
                                .decimals = 1},
                               [](core::Scene& scene, float v) { scene.environment.rotation = v / kDegrees; });
    scale_ = addSceneSlider({.key = "environmentScale",
                             .label = tr("Strength"),
                             .unit = {},
                             .toolTip = tr("Factor on the radiance of the light"),
                             .minimum = 0.01,
                             .maximum = 100,
                             .initial = 1,
                             .logarithmic = true,
                             .decimals = 2},
                            [](core::Scene& scene, float v) { scene.environment.scale = v; });
    use_ = new QComboBox(file);
    use_->setObjectName(QStringLiteral("environmentUse"));
    use_->setAccessibleName(tr("What the loaded map does"));
    use_->setToolTip(tr("A loaded map is all of the light, or only what the photograph does not show of it"));
    use_->addItem(tr("Replaces the recovered light"), static_cast<int>(core::EnvironmentUse::Replace));
    use_->addItem(tr("Completes the recovered light"), static_cast<int>(core::EnvironmentUse::Complete));
    fill_ = new QComboBox(file);
    fill_->setObjectName(QStringLiteral("environmentFill"));
    fill_->setAccessibleName(tr("Unseen directions"));
    fill_->setToolTip(tr("How directions that nothing in the photograph shows are filled"));
    fill_->addItem(tr("Gaps: smooth"), static_cast<int>(core::EnvironmentFill::Membrane));
    fill_->addItem(tr("Gaps: inverse distance (Shepard)"), static_cast<int>(core::EnvironmentFill::Shepard));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(load_);
    buttons->addWidget(recover_);
    auto* fileLayout = new QVBoxLayout(file);
    fileLayout->addWidget(source_);
    fileLayout->addLayout(buttons);
    fileLayout->addWidget(use_);
    fileLayout->addWidget(rotation_);
    fileLayout->addWidget(scale_);
    fileLayout->addWidget(fill_);

    auto* reflectance = new QGroupBox(tr("Reflectance of the segment"), this);
    rho_ = new QLabel(reflectance);
    rho_->setObjectName(QStringLiteral("reflectanceValue"));
    rho_->setWordWrap(true);
    rhoByHand_ = new QCheckBox(tr("Set by hand"), reflectance);
    rhoByHand_->setObjectName(QStringLiteral("reflectanceByHand"));
    rhoByHand_->setToolTip(tr("Replace the estimated ratio of reflected to arriving light"));
    rhoColor_ = new ColorButton(QStringLiteral("reflectanceColor"), tr("Reflectance"), reflectance);
    auto* byHand = new QHBoxLayout;
    byHand->addWidget(rhoByHand_);
    byHand->addWidget(rhoColor_, 1);
    lobeByHand_ = new QCheckBox(tr("Lobe width by hand"), reflectance);
    lobeByHand_->setObjectName(QStringLiteral("lobeByHand"));
    lobeByHand_->setToolTip(tr("Replace the estimated width of the segment's reflections (GGX alpha)"));
    lobe_ = addSegmentSlider({.key = "lobeWidth",
                              .label = tr("Lobe width"),
                              .unit = {},
                              .toolTip = tr("How blurred the segment's reflections are in the photograph (GGX alpha)"),
                              .minimum = 0.005,
                              .maximum = 0.5,
                              .initial = 0.05,
                              .logarithmic = true,
                              .decimals = 3},
                             [](core::Segment& segment, float v) { segment.lobeWidth = v; });
    auto* reflectanceLayout = new QVBoxLayout(reflectance);
    reflectanceLayout->addWidget(rho_);
    reflectanceLayout->addLayout(byHand);
    reflectanceLayout->addWidget(lobeByHand_);
    reflectanceLayout->addWidget(lobe_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(which_);
    layout->addWidget(map_);
    layout->addWidget(hover_);
    layout->addWidget(coverage_);
    layout->addWidget(exposure_);
    layout->addWidget(file);
    layout->addWidget(reflectance);
    layout->addStretch(1);

    connect(which_, &QComboBox::currentIndexChanged, this, &EnvironmentPanel::refreshMap);
    connect(map_, &MapView::hovered, hover_, &QLabel::setText);
    connect(coverage_, &QCheckBox::toggled, map_, &MapView::setCoverageShown);
    connect(exposure_, &ParamSlider::valueChanged, this,
            [this](double stops) { map_->setExposure(static_cast<float>(stops)); });
    connect(load_, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getOpenFileName(
            this, tr("Load environment"), {}, tr("Environment maps (*.exr *.hdr *.png *.jpg *.tif);;All files (*)"));
        if (!path.isEmpty()) loadEnvironment(path);
    });
    connect(recover_, &QPushButton::clicked, this, [this] {
        this->workspace().editScene(tr("Recover light"), [](core::Scene& scene) {
            scene.environment.path.clear();
            scene.environment.image.reset();
        });
    });
    connect(use_, &QComboBox::activated, this, [this](int index) {
        const auto use = static_cast<core::EnvironmentUse>(use_->itemData(index).toInt());
        this->workspace().editScene(tr("Change use of the map"),
                                    [use](core::Scene& scene) { scene.environment.use = use; });
    });
    connect(fill_, &QComboBox::activated, this, [this](int index) {
        const auto fill = static_cast<core::EnvironmentFill>(fill_->itemData(index).toInt());
        this->workspace().editScene(tr("Change filling of gaps"),
                                    [fill](core::Scene& scene) { scene.environment.fill = fill; });
    });
    connect(lobeByHand_, &QCheckBox::clicked, this, [this](bool on) {
        const auto value = static_cast<float>(lobe_->value());
        this->workspace().editSelected(on ? tr("Set lobe width") : tr("Estimate lobe width"),
                                       [&](core::Segment& segment) {
                                           segment.lobeWidth.reset();
                                           if (on) segment.lobeWidth = value;
                                       });
    });
    connect(rhoByHand_, &QCheckBox::clicked, this, [this](bool on) {
        const core::Vector3f value = rhoColor_->color();
        this->workspace().editSelected(on ? tr("Set reflectance") : tr("Estimate reflectance"),
                                       [&](core::Segment& segment) {
                                           segment.reflectance.reset();
                                           if (on) segment.reflectance = value;
                                       });
    });
    connect(rhoColor_, &ColorButton::colorChanged, this, [this](const core::Vector3f& value) {
        this->workspace().editSelected(
            tr("Set reflectance"), [&](core::Segment& segment) { segment.reflectance = value; },
            QStringLiteral("reflectance"));
    });
    connect(rhoColor_, &ColorButton::editingFinished, &workspace, &Workspace::endMerge);
    connect(&workspace, &Workspace::sceneChanged, this, &EnvironmentPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &EnvironmentPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &EnvironmentPanel::refreshMap);
    connect(&workspace, &Workspace::analysisChanged, this, &EnvironmentPanel::refreshMap);
    connect(&workspace, &Workspace::analysisChanged, this, &EnvironmentPanel::refreshReflectance);
    connect(&workspace, &Workspace::documentReplaced, this, [this] { loading_.reset(); });
    refresh();
    refreshMap();
}

EnvironmentPanel::~EnvironmentPanel() = default;

void EnvironmentPanel::loadEnvironment(const QString& path) {
    auto image = std::make_shared<core::ImageRgb>();
    loading_ = std::make_unique<BackgroundTask>(
        [path, image](const core::Progress&) { *image = core::loadColor(path.toStdString()); });
    connect(loading_.get(), &BackgroundTask::failed, this, &EnvironmentPanel::error);
    connect(loading_.get(), &BackgroundTask::succeeded, this, [this, path, image] {
        emit message({});
        if (image->width() != 2 * image->height()) {
            emit error(
                tr("The environment map \"%1\" is %2x%3 pixels; a latitude-longitude map is twice as wide as high.")
                    .arg(path)
                    .arg(image->width())
                    .arg(image->height()));
            return;
        }
        workspace().editScene(tr("Load environment"), [&](core::Scene& scene) {
            scene.environment.path = path.toStdString();
            scene.environment.image = image;
        });
    });
    emit message(tr("Loading %1").arg(QFileInfo(path).fileName()));
    loading_->start();
}

void EnvironmentPanel::refresh() {
    const core::EnvironmentParams& environment = workspace().scene().environment;
    const bool loaded = environment.image != nullptr;
    source_->setText(loaded ? QFileInfo(QString::fromStdString(environment.path)).fileName()
                            : tr("Recovered from the photograph"));
    load_->setEnabled(workspace().hasPhoto());
    recover_->setEnabled(loaded);
    rotation_->setEnabled(workspace().hasPhoto());
    scale_->setEnabled(workspace().hasPhoto());
    rotation_->setValue(static_cast<double>(environment.rotation * kDegrees));
    scale_->setValue(static_cast<double>(environment.scale));
    use_->setEnabled(loaded);
    use_->setCurrentIndex(use_->findData(static_cast<int>(environment.use)));
    fill_->setEnabled(workspace().hasPhoto() && !loaded);
    fill_->setCurrentIndex(fill_->findData(static_cast<int>(environment.fill)));
    refreshReflectance();
}

void EnvironmentPanel::refreshReflectance() {
    const core::Segment* segment = workspace().selectedSegment();
    const bool glossy = segment != nullptr && segment->glossy;
    rhoByHand_->setEnabled(glossy);
    rhoColor_->setEnabled(glossy && segment->reflectance.has_value());
    lobeByHand_->setEnabled(glossy);
    lobe_->setEnabled(glossy && segment->lobeWidth.has_value());
    if (!glossy) {
        rho_->setText(tr("Select a segment flagged as glossy."));
        rhoByHand_->setChecked(false);
        lobeByHand_->setChecked(false);
        return;
    }
    lobeByHand_->setChecked(segment->lobeWidth.has_value());
    if (segment->lobeWidth) lobe_->setValue(static_cast<double>(*segment->lobeWidth));
    rhoByHand_->setChecked(segment->reflectance.has_value());
    const auto& analysis = workspace().analysis();
    const core::Reflectance* found = analysis != nullptr ? analysis->findReflectance(segment->label) : nullptr;
    if (segment->reflectance) rhoColor_->setColor(*segment->reflectance);
    if (found == nullptr) {
        rho_->setText(tr("Being estimated."));
        return;
    }
    if (!segment->reflectance) rhoColor_->setColor(found->rho);
    if (!segment->lobeWidth) lobe_->setValue(static_cast<double>(found->alpha));
    QString text = tr("ρ = %1, %2, %3")
                       .arg(static_cast<double>(found->rho.x()), 0, 'f', 3)
                       .arg(static_cast<double>(found->rho.y()), 0, 'f', 3)
                       .arg(static_cast<double>(found->rho.z()), 0, 'f', 3);
    if (segment->reflectance) {
        text += tr(" (yours)");
    } else if (!found->reliable) {
        text += tr(". Only %1 sr are known both ways: a guess, better set it by hand.")
                    .arg(static_cast<double>(found->commonSolidAngle), 0, 'f', 2);
    } else {
        text += tr(", from %1 sr known both ways").arg(static_cast<double>(found->commonSolidAngle), 0, 'f', 2);
    }
    if (!segment->lobeWidth)
        text += '\n' + (found->alphaReliable
                            ? tr("Lobe width %1, estimated").arg(static_cast<double>(found->alpha), 0, 'f', 3)
                            : tr("Lobe width %1, assumed: nothing with detail is reflected")
                                  .arg(static_cast<double>(found->alpha), 0, 'f', 3));
    rho_->setText(text);
}

void EnvironmentPanel::refreshMap() {
    const auto& analysis = workspace().analysis();
    if (analysis == nullptr) {
        map_->setEmpty(workspace().hasPhoto() ? tr("The light is being recovered.") : tr("Nothing is open."));
        return;
    }
    if (which_->currentData().toInt() == kEnvironment) {
        if (analysis->environment != nullptr && !analysis->environment->empty()) {
            map_->setMap(*analysis->environment);
        } else {
            map_->setEmpty(tr("There is no light to show."));
        }
        return;
    }
    const core::Reflectance* found = analysis->findReflectance(workspace().selectedLabel());
    if (found == nullptr) {
        map_->setEmpty(tr("Select a segment flagged as glossy."));
    } else {
        map_->setMap(which_->currentData().toInt() == kReflected ? found->reflected : found->incident);
    }
}

}  // namespace ui
