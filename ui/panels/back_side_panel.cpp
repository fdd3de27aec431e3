// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/back_side_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/io/image_io.h"
#include "ui/recent_files.h"
#include "ui/widgets/param_control.h"
#include "ui/widgets/profile_view.h"
#include "ui/words.h"

namespace ui {

const core::BackSideInfo* BackSidePanel::outcome() const {
    const core::Segment* segment = workspace().selectedSegment();
    const auto& analysis = workspace().analysis();
    if (segment == nullptr || analysis == nullptr) return nullptr;
    const auto info = std::ranges::find(analysis->backSides, segment->label, &core::BackSideInfo::label);
    return info == analysis->backSides.end() ? nullptr : &*info;
}

QString BackSidePanel::outcomeText() const {
    const core::BackSideInfo* info = outcome();
    if (info == nullptr || workspace().scene().backDepth != nullptr) return {};
    const QString used = sceneText(core::labelOf(info->used));
    const QString penalty = locale().toString(static_cast<double>(info->mirrorError), 'f', 2);
    QString text;
    if (!info->note.empty()) {
        text = tr("%1. %2").arg(used, translated(info->note));
    } else if (workspace().selectedSegment()->backSide.method == core::BackSideMethod::Automatic) {
        text = tr("Automatic: %1 (penalty %2)").arg(used, penalty);
    } else if (info->used != core::BackSideMethod::Offset) {
        text = tr("Penalty %1").arg(penalty);
    }
    if (info->onSupport)
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + tr("Ends at the plane it stands on.");
    return text;
}

BackSidePanel::BackSidePanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    title_ = new QLabel(this);
    title_->setObjectName(QStringLiteral("backSideTitle"));
    outcome_ = new QLabel(this);
    outcome_->setObjectName(QStringLiteral("backSideOutcome"));
    outcome_->setWordWrap(true);
    auto* front = new QGroupBox(tr("Front"), this);
    addControls(core::ParamGroup::Front, new QVBoxLayout(front));
    profile_ = new ProfileView(this);
    profile_->setObjectName(QStringLiteral("backSideProfile"));
    profile_->setAccessibleName(tr("Preview of the back side"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(title_);
    addControls(core::ParamGroup::BackSide, layout);
    layout->insertWidget(layout->indexOf(control("back_side.method")) + 1, outcome_);
    layout->addWidget(front);
    layout->addWidget(profile_, 1);
    layout->addWidget(makeFileGroup());

    connect(&workspace, &Workspace::sceneChanged, this, &BackSidePanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &BackSidePanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &BackSidePanel::refreshPreview);
    connect(&workspace, &Workspace::analysisChanged, this, &BackSidePanel::refresh);
    connect(&workspace, &Workspace::analysisChanged, this, &BackSidePanel::refreshPreview);
    refresh();
    refreshPreview();
}

QWidget* BackSidePanel::makeFileGroup() {
    auto* file = new QGroupBox(tr("Measured back side"), this);
    backDepth_ = new QLabel(file);
    backDepth_->setObjectName(QStringLiteral("backDepthFile"));
    loadBackDepth_ = new QPushButton(tr("Load…"), file);
    loadBackDepth_->setObjectName(QStringLiteral("loadBackDepth"));
    loadBackDepth_->setToolTip(tr("Use a depth map of the far side (metres, planar) instead of the invented one"));
    clearBackDepth_ = new QPushButton(tr("Clear"), file);
    clearBackDepth_->setObjectName(QStringLiteral("clearBackDepth"));
    clearBackDepth_->setToolTip(tr("Return to the invented back side"));
    auto* layout = new QHBoxLayout(file);
    layout->addWidget(backDepth_, 1);
    layout->addWidget(loadBackDepth_);
    layout->addWidget(clearBackDepth_);
    connect(loadBackDepth_, &QPushButton::clicked, this, &BackSidePanel::chooseBackDepth);
    connect(clearBackDepth_, &QPushButton::clicked, this, [this] {
        workspace().editScene(tr("Remove measured back side"), [](core::Scene& scene) {
            scene.backDepthPath.clear();
            scene.backDepth.reset();
        });
    });
    return file;
}

void BackSidePanel::refresh() {
    const core::Scene& scene = workspace().scene();
    const core::Segment* segment = workspace().selectedSegment();
    const bool measured = scene.backDepth != nullptr;
    title_->setText(segment != nullptr ? QString::fromStdString(segment->name) : tr("No segment selected"));
    refreshControls();
    enableControls();
    outcome_->setText(outcomeText());
    loadBackDepth_->setEnabled(workspace().hasPhoto());
    clearBackDepth_->setEnabled(measured);
    backDepth_->setText(measured ? QFileInfo(QString::fromStdString(scene.backDepthPath)).fileName() : tr("None"));
}

void BackSidePanel::enableControls() {
    const core::Scene& scene = workspace().scene();
    const core::Segment* segment = workspace().selectedSegment();
    const bool invented = segment != nullptr && scene.backDepth == nullptr;
    // The shape decides what can be moved: with Automatic, the one that the analysis chose.
    core::BackSideMethod used = segment != nullptr ? segment->backSide.method : core::BackSideMethod::Offset;
    if (used == core::BackSideMethod::Automatic && outcome() != nullptr) used = outcome()->used;
    const bool mirrored = used == core::BackSideMethod::PcaMirror || used == core::BackSideMethod::ParallelMirror ||
                          used == core::BackSideMethod::SpannedMirror;
    control("back_side.method")->setEnabled(invented);
    control("back_side.offset")->setEnabled(invented && used == core::BackSideMethod::Offset);
    control("back_side.plane_shift")->setEnabled(invented && mirrored);
    control("back_side.thickness_scale")->setEnabled(invented && used != core::BackSideMethod::Offset);
    control("smoothing")->setEnabled(segment != nullptr && scene.depthFilter.enabled);
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
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Measured back side"), RecentFiles::folder(workspace().document()),
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
