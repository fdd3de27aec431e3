// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/back_side_panel.h"

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
#include <algorithm>
#include <cmath>

#include "core/io/image_io.h"
#include "ui/widgets/param_slider.h"
#include "ui/widgets/profile_view.h"
#include "ui/words.h"

namespace ui {

namespace {
constexpr float kMillimetres = 1000;
constexpr float kPercent = 100;
}  // namespace

QString BackSidePanel::methodName(core::BackSideMethod method) {
    switch (method) {
        case core::BackSideMethod::Automatic:
            return tr("Automatic");
        case core::BackSideMethod::Offset:
            return tr("Constant thickness");
        case core::BackSideMethod::ParallelMirror:
            return tr("Mirrored at a plane facing the camera");
        case core::BackSideMethod::PcaMirror:
            return tr("Mirrored at a fitted plane");
        case core::BackSideMethod::SpannedMirror:
            return tr("Rounded: mirrored at its outline");
        case core::BackSideMethod::FlatFaces:
            return tr("Box: flat faces continued");
    }
    return {};
}

QString BackSidePanel::outcomeText() const {
    const core::Segment* segment = workspace().selectedSegment();
    const auto& analysis = workspace().analysis();
    if (segment == nullptr || analysis == nullptr || workspace().scene().backDepth != nullptr) return {};
    const auto info = std::ranges::find(analysis->backSides, segment->label, &core::BackSideInfo::label);
    if (info == analysis->backSides.end()) return {};
    QString text;
    if (!info->note.empty()) {
        text = tr("%1. %2").arg(methodName(info->used), translated(info->note));
    } else if (segment->backSide.method == core::BackSideMethod::Automatic) {
        text = tr("Automatic: %1 (penalty %2)")
                   .arg(methodName(info->used), locale().toString(static_cast<double>(info->mirrorError), 'f', 2));
    } else if (info->used != core::BackSideMethod::Offset) {
        text = tr("Penalty %1").arg(locale().toString(static_cast<double>(info->mirrorError), 'f', 2));
    }
    if (info->onSupport)
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + tr("Ends at the plane it stands on.");
    return text;
}

BackSidePanel::BackSidePanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    title_ = new QLabel(this);
    title_->setObjectName(QStringLiteral("backSideTitle"));
    method_ = new QComboBox(this);
    method_->setObjectName(QStringLiteral("backSideMethod"));
    method_->setAccessibleName(tr("Back side method"));
    method_->setToolTip(tr("How the side the camera does not see is invented"));
    for (const core::BackSideMethod method :
         {core::BackSideMethod::Automatic, core::BackSideMethod::SpannedMirror, core::BackSideMethod::FlatFaces,
          core::BackSideMethod::PcaMirror, core::BackSideMethod::ParallelMirror, core::BackSideMethod::Offset})
        method_->addItem(methodName(method), static_cast<int>(method));
    outcome_ = new QLabel(this);
    outcome_->setObjectName(QStringLiteral("backSideOutcome"));
    outcome_->setWordWrap(true);
    offset_ = addSegmentSlider({.key = "backSideOffset",
                                .label = tr("Thickness"),
                                .unit = tr("mm"),
                                .toolTip = tr("Distance between front and back, for constant thickness"),
                                .minimum = 0.1,
                                .maximum = 1000,
                                .initial = 50,
                                .logarithmic = true,
                                .decimals = 1},
                               [](core::Segment& s, float v) { s.backSide.offset = v / kMillimetres; });
    thickness_ = addSegmentSlider({.key = "backSideMinThickness",
                                   .label = tr("At least"),
                                   .unit = tr("mm"),
                                   .toolTip = tr("Smallest thickness anywhere on the segment"),
                                   .minimum = 0.1,
                                   .maximum = 100,
                                   .initial = 2,
                                   .logarithmic = true,
                                   .decimals = 1},
                                  [](core::Segment& s, float v) { s.backSide.minThickness = v / kMillimetres; });
    planeShift_ = addSegmentSlider({.key = "backSidePlaneShift",
                                    .label = tr("Move mirror"),
                                    .unit = tr("mm"),
                                    .toolTip = tr("Moves the mirror that was found away from the camera"),
                                    .minimum = -200,
                                    .maximum = 200,
                                    .initial = 0,
                                    .decimals = 1},
                                   [](core::Segment& s, float v) { s.backSide.planeShift = v / kMillimetres; });
    scale_ = addSegmentSlider({.key = "backSideScale",
                               .label = tr("Stretch"),
                               .unit = tr("%"),
                               .toolTip = tr("Factor on the thickness that was invented"),
                               .minimum = 10,
                               .maximum = 400,
                               .initial = 100,
                               .logarithmic = true,
                               .decimals = 0},
                              [](core::Segment& s, float v) { s.backSide.thicknessScale = v / kPercent; });
    auto* front = new QGroupBox(tr("Front"), this);
    smoothAutomatically_ = new QCheckBox(tr("Smooth surface automatically"), front);
    smoothAutomatically_->setObjectName(QStringLiteral("smoothAutomatically"));
    smoothAutomatically_->setToolTip(
        tr("The smoothing follows the noise of the depth map; part of the depth filter, which has to be on"));
    smoothing_ = addSegmentSlider({.key = "smoothing",
                                   .label = tr("Smoothing"),
                                   .unit = tr("px"),
                                   .toolTip = tr("Bumps and dents of the surface narrower than about this are smoothed "
                                                 "away: more for porcelain, less for fur and carving; 0 = none"),
                                   .minimum = 0,
                                   .maximum = 100,
                                   .initial = 12,
                                   .decimals = 1},
                                  [](core::Segment& s, float v) { s.smoothing = v; });
    auto* frontLayout = new QVBoxLayout(front);
    frontLayout->addWidget(smoothAutomatically_);
    frontLayout->addWidget(smoothing_);
    profile_ = new ProfileView(this);
    profile_->setObjectName(QStringLiteral("backSideProfile"));
    profile_->setAccessibleName(tr("Preview of the back side"));

    auto* file = new QGroupBox(tr("Measured back side"), this);
    backDepth_ = new QLabel(file);
    backDepth_->setObjectName(QStringLiteral("backDepthFile"));
    loadBackDepth_ = new QPushButton(tr("Load…"), file);
    loadBackDepth_->setObjectName(QStringLiteral("loadBackDepth"));
    loadBackDepth_->setToolTip(tr("Use a depth map of the far side (metres, planar) in place of the invented one"));
    clearBackDepth_ = new QPushButton(tr("Clear"), file);
    clearBackDepth_->setObjectName(QStringLiteral("clearBackDepth"));
    clearBackDepth_->setToolTip(tr("Go back to the invented back side"));
    auto* fileLayout = new QHBoxLayout(file);
    fileLayout->addWidget(backDepth_, 1);
    fileLayout->addWidget(loadBackDepth_);
    fileLayout->addWidget(clearBackDepth_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(title_);
    layout->addWidget(method_);
    layout->addWidget(outcome_);
    layout->addWidget(offset_);
    layout->addWidget(planeShift_);
    layout->addWidget(scale_);
    layout->addWidget(thickness_);
    layout->addWidget(front);
    layout->addWidget(profile_, 1);
    layout->addWidget(file);

    connect(method_, &QComboBox::activated, this, [this](int index) {
        const auto method = static_cast<core::BackSideMethod>(method_->itemData(index).toInt());
        this->workspace().editSelected(tr("Change back side"),
                                       [method](core::Segment& s) { s.backSide.method = method; });
    });
    connect(smoothAutomatically_, &QCheckBox::clicked, this, [this](bool on) {
        const auto value = static_cast<float>(smoothing_->value());
        this->workspace().editSelected(on ? tr("Smooth surface automatically") : tr("Set smoothing"),
                                       [&](core::Segment& segment) {
                                           segment.smoothing.reset();
                                           if (!on) segment.smoothing = value;
                                       });
    });
    connect(loadBackDepth_, &QPushButton::clicked, this, &BackSidePanel::chooseBackDepth);
    connect(clearBackDepth_, &QPushButton::clicked, this, [this] {
        this->workspace().editScene(tr("Remove measured back side"), [](core::Scene& scene) {
            scene.backDepthPath.clear();
            scene.backDepth.reset();
        });
    });
    connect(&workspace, &Workspace::sceneChanged, this, &BackSidePanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &BackSidePanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &BackSidePanel::refreshPreview);
    connect(&workspace, &Workspace::analysisChanged, this, &BackSidePanel::refresh);
    connect(&workspace, &Workspace::analysisChanged, this, &BackSidePanel::refreshPreview);
    refresh();
    refreshPreview();
}

void BackSidePanel::refresh() {
    const core::Scene& scene = workspace().scene();
    const core::Segment* segment = workspace().selectedSegment();
    const bool measured = scene.backDepth != nullptr;
    title_->setText(segment != nullptr ? QString::fromStdString(segment->name) : tr("No segment selected"));
    method_->setEnabled(segment != nullptr && !measured);
    thickness_->setEnabled(segment != nullptr);
    // What the shape came from decides what can be moved; a segment left to Automatic goes by what was taken.
    core::BackSideMethod used = segment != nullptr ? segment->backSide.method : core::BackSideMethod::Offset;
    if (const auto& analysis = workspace().analysis(); segment != nullptr && analysis != nullptr) {
        const auto info = std::ranges::find(analysis->backSides, segment->label, &core::BackSideInfo::label);
        if (info != analysis->backSides.end() && used == core::BackSideMethod::Automatic) used = info->used;
    }
    const bool invented = segment != nullptr && !measured;
    offset_->setEnabled(invented && used == core::BackSideMethod::Offset);
    planeShift_->setEnabled(invented &&
                            (used == core::BackSideMethod::PcaMirror || used == core::BackSideMethod::ParallelMirror ||
                             used == core::BackSideMethod::SpannedMirror));
    scale_->setEnabled(invented && used != core::BackSideMethod::Offset);
    outcome_->setText(outcomeText());
    refreshSmoothing();
    loadBackDepth_->setEnabled(workspace().hasPhoto());
    clearBackDepth_->setEnabled(measured);
    backDepth_->setText(measured ? QFileInfo(QString::fromStdString(scene.backDepthPath)).fileName() : tr("None"));
    if (segment == nullptr) return;
    const QSignalBlocker block(method_);
    method_->setCurrentIndex(method_->findData(static_cast<int>(segment->backSide.method)));
    offset_->setValue(static_cast<double>(segment->backSide.offset * kMillimetres));
    planeShift_->setValue(static_cast<double>(segment->backSide.planeShift * kMillimetres));
    scale_->setValue(static_cast<double>(segment->backSide.thicknessScale * kPercent));
    thickness_->setValue(static_cast<double>(segment->backSide.minThickness * kMillimetres));
}

void BackSidePanel::refreshSmoothing() {
    const core::Segment* segment = workspace().selectedSegment();
    const bool filtered = segment != nullptr && workspace().scene().depthFilter.enabled;
    const bool byHand = segment != nullptr && segment->smoothing.has_value();
    smoothAutomatically_->setEnabled(filtered);
    smoothAutomatically_->setChecked(!byHand);
    smoothing_->setEnabled(filtered && byHand);
    if (byHand) {
        smoothing_->setValue(static_cast<double>(*segment->smoothing));
    } else if (const auto& analysis = workspace().analysis(); segment != nullptr && analysis != nullptr) {
        const auto found = analysis->smoothing.find(segment->label);
        smoothing_->setValue(found != analysis->smoothing.end() ? static_cast<double>(found->second) : 0.0);
    }
}

void BackSidePanel::refreshPreview() {
    const core::Segment* segment = workspace().selectedSegment();
    const auto& analysis = workspace().analysis();
    if (segment == nullptr) {
        profile_->clear(tr("Select a segment to see its front and back."));
    } else if (analysis == nullptr || analysis->front == nullptr || analysis->back == nullptr) {
        profile_->clear(tr("The geometry is being computed."));
    } else {
        profile_->show(workspace().scene().photo->labels, segment->label, *analysis->front, *analysis->back);
    }
}

void BackSidePanel::chooseBackDepth() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Measured back side"), {},
                                                      tr("Depth maps (*.exr *.png *.tif *.tiff *.pfm);;All files (*)"));
    if (path.isEmpty()) return;
    try {
        auto depth = std::make_shared<core::ImageF>(core::loadScalar(path.toStdString()));
        const core::ImageRgb& color = workspace().scene().photo->color;
        if (!depth->sameSize(color)) {
            emit error(tr("The back side \"%1\" is %2x%3 pixels, but the photograph is %4x%5.")
                           .arg(path)
                           .arg(depth->width())
                           .arg(depth->height())
                           .arg(color.width())
                           .arg(color.height()));
            return;
        }
        for (float& z : depth->pixels()) z = std::isfinite(z) && z > 0 ? z : 0.0f;
        workspace().editScene(tr("Load measured back side"), [&](core::Scene& scene) {
            scene.backDepthPath = path.toStdString();
            scene.backDepth = depth;
        });
    } catch (const core::Error& problem) {
        emit error(translated(problem));
    }
}

}  // namespace ui
