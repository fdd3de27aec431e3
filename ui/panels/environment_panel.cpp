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
#include <QVBoxLayout>

#include "core/io/image_io.h"
#include "ui/background_task.h"
#include "ui/recent_files.h"
#include "ui/translations.h"
#include "ui/widgets/map_view.h"
#include "ui/widgets/param_control.h"
#include "ui/widgets/param_slider.h"

namespace ui {

namespace {
enum MapChoice { kEnvironment, kReflected, kIncident };
}  // namespace

EnvironmentPanel::EnvironmentPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(makeView());
    layout->addWidget(makeSourceGroup());
    layout->addWidget(makeReflectanceGroup());
    layout->addStretch(1);
    connect(&workspace, &Workspace::sceneChanged, this, &EnvironmentPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &EnvironmentPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &EnvironmentPanel::refreshMap);
    connect(&workspace, &Workspace::analysisChanged, this, &EnvironmentPanel::refresh);
    connect(&workspace, &Workspace::analysisChanged, this, &EnvironmentPanel::refreshMap);
    connect(&workspace, &Workspace::documentReplaced, this, [this] { loading_.reset(); });
    refresh();
    refreshMap();
}

QWidget* EnvironmentPanel::makeView() {
    auto* view = new QWidget(this);
    which_ = new QComboBox(view);
    which_->setObjectName(QStringLiteral("environmentMap"));
    which_->setAccessibleName(tr("Displayed map"));
    which_->setToolTip(tr("Show the light around the scene, or the maps of the selected glossy segment"));
    which_->addItem(tr("Light around the scene"), kEnvironment);
    which_->addItem(tr("Reflected by the segment (L_S)"), kReflected);
    which_->addItem(tr("Arriving at the segment (L_G)"), kIncident);
    map_ = new MapView(view);
    map_->setObjectName(QStringLiteral("environmentView"));
    map_->setAccessibleName(tr("Directional map"));
    auto* hover = new QLabel(view);
    hover->setObjectName(QStringLiteral("environmentHover"));
    hover->setWordWrap(true);
    hover->setMinimumHeight(2 * fontMetrics().lineSpacing());
    hover->setAlignment(Qt::AlignTop);
    auto* coverage = new QCheckBox(tr("Highlight estimated directions"), view);
    coverage->setObjectName(QStringLiteral("environmentCoverage"));
    coverage->setToolTip(tr("Hatch the interpolated directions, which nothing in the photograph reflects"));
    auto* exposure = new ParamSlider({.key = "environmentExposure",
                                      .label = tr("View exposure"),
                                      .unit = tr("EV"),
                                      .toolTip = tr("Brightness of this view only"),
                                      .minimum = -8,
                                      .maximum = 8,
                                      .initial = 0,
                                      .decimals = 1},
                                     view);
    auto* layout = new QVBoxLayout(view);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : {static_cast<QWidget*>(which_), static_cast<QWidget*>(map_), static_cast<QWidget*>(hover),
                            static_cast<QWidget*>(coverage), static_cast<QWidget*>(exposure)})
        layout->addWidget(widget);
    connect(which_, &QComboBox::currentIndexChanged, this, &EnvironmentPanel::refreshMap);
    connect(map_, &MapView::hovered, hover, &QLabel::setText);
    connect(coverage, &QCheckBox::toggled, map_, &MapView::setCoverageShown);
    connect(exposure, &ParamSlider::valueChanged, this,
            [this](double stops) { map_->setExposure(static_cast<float>(stops)); });
    return view;
}

QWidget* EnvironmentPanel::makeSourceGroup() {
    auto* group = new QGroupBox(tr("Source"), this);
    source_ = new QLabel(group);
    source_->setObjectName(QStringLiteral("environmentSource"));
    source_->setWordWrap(true);
    load_ = new QPushButton(tr("Load HDRI…"), group);
    load_->setObjectName(QStringLiteral("loadEnvironment"));
    load_->setToolTip(tr("Light the edits with a latitude-longitude map (EXR or HDR) instead of the recovered light"));
    recover_ = new QPushButton(tr("Recover"), group);
    recover_->setObjectName(QStringLiteral("recoverEnvironment"));
    recover_->setToolTip(tr("Return to the light recovered from the photograph"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(load_);
    buttons->addWidget(recover_);
    auto* layout = new QVBoxLayout(group);
    layout->addWidget(source_);
    layout->addLayout(buttons);
    addControls(core::ParamGroup::Light, layout);
    connect(load_, &QPushButton::clicked, this, &EnvironmentPanel::chooseEnvironment);
    connect(recover_, &QPushButton::clicked, this, [this] {
        workspace().editScene(tr("Recover light"), [](core::Scene& scene) {
            scene.environment.path.clear();
            scene.environment.image.reset();
        });
    });
    return group;
}

QWidget* EnvironmentPanel::makeReflectanceGroup() {
    auto* group = new QGroupBox(tr("Reflectance of the segment"), this);
    rho_ = new QLabel(group);
    rho_->setObjectName(QStringLiteral("reflectanceValue"));
    rho_->setWordWrap(true);
    auto* layout = new QVBoxLayout(group);
    layout->addWidget(rho_);
    addControls(core::ParamGroup::Reflectance, layout);
    return group;
}

EnvironmentPanel::~EnvironmentPanel() = default;

void EnvironmentPanel::loadEnvironment(const QString& path) {
    auto image = std::make_shared<core::ImageRgb>();
    auto remarks = std::make_shared<core::Notes>();
    loading_ = std::make_unique<BackgroundTask>(
        [path, image, remarks](const core::Progress&) { *image = core::loadColor(path.toStdString(), remarks.get()); });
    connect(loading_.get(), &BackgroundTask::failed, this, &EnvironmentPanel::error);
    connect(loading_.get(), &BackgroundTask::succeeded, this, [this, path, image, remarks] {
        emit message(remarks->empty() ? QString() : translated(remarks->front()));
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

void EnvironmentPanel::chooseEnvironment() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Load environment"), RecentFiles::folder(workspace().document()),
                                     tr("Environment maps (*.exr *.hdr *.png *.jpg *.tif);;All files (*)"));
    if (!path.isEmpty()) loadEnvironment(path);
}

void EnvironmentPanel::refresh() {
    const core::EnvironmentParams& environment = workspace().scene().environment;
    const bool loaded = environment.image != nullptr;
    source_->setText(loaded ? QFileInfo(QString::fromStdString(environment.path)).fileName()
                            : tr("Recovered from the photograph"));
    load_->setEnabled(workspace().hasPhoto());
    recover_->setEnabled(loaded);
    refreshControls();
    control("environment.use")->setEnabled(loaded);
    control("environment.fill")->setEnabled(workspace().hasPhoto() && !loaded);
    const QString recovered =
        tr("The recovered light is tied to the photograph: it already has the direction and the strength that were "
           "photographed. Load an environment map to turn or scale the light.");
    for (const char* key : {"environment.rotation", "environment.scale"}) {
        control(key)->setUnavailable(workspace().hasPhoto() && !loaded ? recovered : QString());
        control(key)->setEnabled(loaded);
    }
    refreshReflectance();
}

void EnvironmentPanel::refreshReflectance() {
    const core::Segment* segment = workspace().selectedSegment();
    const bool glossy = segment != nullptr && segment->glossy;
    for (const char* key : {"reflectance", "lobe_width"}) control(key)->setEnabled(glossy);
    if (!glossy) {
        rho_->setText(tr("Select a segment flagged as glossy."));
        return;
    }
    const auto& analysis = workspace().analysis();
    const core::Reflectance* found = analysis != nullptr ? analysis->findReflectance(segment->label) : nullptr;
    rho_->setText(found != nullptr ? estimateText(*segment, *found) : tr("Being estimated."));
}

QString EnvironmentPanel::estimateText(const core::Segment& segment, const core::Reflectance& found) {
    QString text = tr("ρ = %1, %2, %3")
                       .arg(static_cast<double>(found.rho.x()), 0, 'f', 3)
                       .arg(static_cast<double>(found.rho.y()), 0, 'f', 3)
                       .arg(static_cast<double>(found.rho.z()), 0, 'f', 3);
    const auto solidAngle = static_cast<double>(found.commonSolidAngle);
    if (segment.reflectance) {
        text += tr(" (custom)");
    } else if (!found.reliable) {
        text += tr(". Only %1 sr are known both ways: a guess, better set it yourself.").arg(solidAngle, 0, 'f', 2);
    } else {
        text += tr(", from %1 sr known both ways").arg(solidAngle, 0, 'f', 2);
    }
    if (segment.lobeWidth) return text;
    const auto alpha = static_cast<double>(found.alpha);
    return text + '\n' +
           (found.alphaReliable ? tr("Lobe width %1, estimated").arg(alpha, 0, 'f', 3)
                                : tr("Lobe width %1, assumed: the reflections show no detail").arg(alpha, 0, 'f', 3));
}

void EnvironmentPanel::refreshMap() {
    const auto& analysis = workspace().analysis();
    if (analysis == nullptr) {
        map_->setEmpty(workspace().hasPhoto() ? tr("The light is being recovered.") : tr("No project open"));
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
