// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/mask_painter.h"

namespace ui {

namespace {
/// Wait for the first sample of a picture before the stroke restarts it anyway [ms].
constexpr qint64 kMaxWait = 1000;
}  // namespace

MaskPainter::MaskPainter(Workspace& workspace, Canvas& canvas, QObject* parent)
    : QObject(parent), workspace_(workspace), canvas_(canvas) {
    connect(&canvas, &Canvas::strokeBegan, this, &MaskPainter::begin);
    connect(&canvas, &Canvas::doubleClicked, this, &MaskPainter::begin);
    connect(&canvas, &Canvas::strokeMoved, this, &MaskPainter::move);
    connect(&canvas, &Canvas::strokeEnded, this, &MaskPainter::end);
    connect(&canvas, &Canvas::progressChanged, this, &MaskPainter::publishWhenShown);
    connect(&workspace, &Workspace::paintingChanged, this, &MaskPainter::refresh);
    connect(&workspace, &Workspace::sceneChanged, this, &MaskPainter::refresh);
}

void MaskPainter::begin(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    const core::Drive* drive = workspace_.paintedDrive();
    if (drive == nullptr) return;
    photo_ = workspace_.scene().photo;
    core::Brush brush = workspace_.brush();
    if (modifiers.testFlag(Qt::ShiftModifier)) brush.erase = !brush.erase;
    stroke_.emplace(*drive->mask, brush, photo_->labels, workspace_.selectedLabel());
    ++strokes_;
    published_.start();
    move(position);
}

void MaskPainter::move(const QPointF& position) {
    if (!stroke_) return;
    stroke_->moveTo(static_cast<float>(position.x()), static_cast<float>(position.y()));
    unpublished_ = true;
    canvas_.setMask(std::make_shared<core::Mask>(stroke_->mask()));
    publishWhenShown();
}

void MaskPainter::end() {
    if (!stroke_) return;
    publish();
    stroke_.reset();
    photo_.reset();
    workspace_.endMerge();
    refresh();
}

void MaskPainter::publishWhenShown() {
    if (!stroke_ || !unpublished_) return;
    const bool shown = canvas_.upToDate() && canvas_.progress().samples > 0;
    if (shown || published_.elapsed() > kMaxWait) publish();
}

void MaskPainter::publish() {
    const core::Drive* painted = workspace_.paintedDrive();
    unpublished_ = false;
    published_.start();
    if (painted == nullptr || workspace_.scene().photo != photo_) return;
    const std::shared_ptr<const core::Mask> before = painted->mask;
    const auto after = std::make_shared<const core::Mask>(stroke_->mask());
    workspace_.editSelected(
        tr("Paint"),
        [&](core::Segment& segment) {
            for (core::Drive& drive : segment.edit->drives)
                if (drive.mask == before) drive.mask = after;
        },
        QStringLiteral("stroke%1of").arg(strokes_));
}

void MaskPainter::refresh() {
    const core::Drive* drive = workspace_.paintedDrive();
    if (drive == nullptr) {
        stroke_.reset();
        canvas_.setMask(nullptr);
    } else if (!stroke_) {
        canvas_.setMask(drive->mask);
    }
}

}  // namespace ui
