// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/substance_ruler.h"

#include <vector>

#include "core/base/statistics.h"
#include "ui/canvas/canvas.h"

namespace ui {
namespace {

/// Median depth of a segment's front [m]; 0 if none of it has a depth.
double medianDepth(const core::LabelImage& labels, const core::ImageF& depth, std::uint16_t label) {
    std::vector<float> values;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == label && depth[i] > 0) values.push_back(depth[i]);
    return values.empty() ? 0 : static_cast<double>(core::median(values));
}

}  // namespace

SubstanceRuler::SubstanceRuler(const Workspace& workspace, Canvas& canvas, QObject* parent)
    : QObject(parent), workspace_(workspace), canvas_(canvas) {
    connect(&workspace_, &Workspace::selectionChanged, this, &SubstanceRuler::update);
    connect(&workspace_, &Workspace::sceneChanged, this, &SubstanceRuler::update);
    connect(&workspace_, &Workspace::analysisChanged, this, &SubstanceRuler::update);
    connect(&workspace_, &Workspace::documentReplaced, this, &SubstanceRuler::update);
}

void SubstanceRuler::setShown(bool shown) {
    shown_ = shown;
    update();
}

double SubstanceRuler::millimetresPerPixel() {
    const core::Segment* segment = workspace_.selectedSegment();
    const std::shared_ptr<const core::Analysis>& analysis = workspace_.analysis();
    if (segment == nullptr || !segment->edit || !segment->edit->translucency || analysis == nullptr) return 0;
    const core::Photo& photo = *workspace_.scene().photo;
    if (analysis != depthFrom_ || segment->label != depthOf_) {
        if (!analysis->front->depth.sameSize(photo.labels)) return 0;
        depth_ = medianDepth(photo.labels, analysis->front->depth, segment->label);
        depthFrom_ = analysis;
        depthOf_ = segment->label;
    }
    const double focal = 0.5 * static_cast<double>(photo.camera.fx + photo.camera.fy);
    return 1000 * depth_ / focal * static_cast<double>(segment->edit->translucency->scale);
}

void SubstanceRuler::update() { canvas_.setRuler(shown_ ? millimetresPerPixel() : 0); }

}  // namespace ui
