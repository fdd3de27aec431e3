// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/smart_select_tool.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/selection/pointing.h"

namespace ui {

namespace {

/// Distance between the seeds of a drag, in parts of the picture's shorter side, and most of them in one drag.
constexpr double kSeedSpacing = 0.015;
constexpr std::size_t kMostSeeds = 64;

core::BinaryMask pointedAt(const core::PixelSelection& selection, const core::Selector& selector,
                           const core::Progress& progress) {
    static const core::BinaryMask kNothing;
    return core::selectFrom(selector, selection.base != nullptr ? *selection.base : kNothing,
                            {selection.add, selection.remove}, progress);
}

bool hasSeeds(const core::PixelSelection& selection) { return !selection.add.empty() || !selection.remove.empty(); }

}  // namespace

SmartSelectTool::SmartSelectTool(SelectionSession& session, QObject* parent) : Tool(session, parent) {
    connect(&session.workspace(), &Workspace::documentReplaced, this, [this] {
        asked_.reset();
        stroke_.reset();
        hovered_.reset();
    });
    connect(&session.worker(), &SelectionWorker::stateChanged, this, &Tool::hintChanged);
}

QString SmartSelectTool::hint() const {
    if (!session().worker().prepared() && session().worker().busy())
        return tr("Finding regions… A click waits until they are known.");
    return session().selection() == nullptr
               ? tr("Click an object to select it; drag over several of its parts.")
               : tr("Click adds, Alt-click takes away. Press Enter to make a segment of it.");
}

std::shared_ptr<const core::PixelSelection> SmartSelectTool::latest() const {
    return asked_ != nullptr && session().worker().busy() ? asked_ : session().selection();
}

core::PixelSelection SmartSelectTool::with(const std::vector<core::Pixel>& seeds, bool removes) const {
    core::PixelSelection next;
    if (const auto before = latest(); before != nullptr) {
        next.add = before->add;
        next.remove = before->remove;
        // What was selected otherwise is the base for pointing.
        if (hasSeeds(*before))
            next.base = before->base;
        else
            next.base = std::shared_ptr<const core::BinaryMask>(before, &before->mask);
    }
    for (const core::Pixel& seed : seeds) {
        const auto same = [&](const core::Pixel& other) { return other.x == seed.x && other.y == seed.y; };
        std::erase_if(next.add, same);
        std::erase_if(next.remove, same);
        (removes ? next.remove : next.add).push_back(seed);
    }
    return next;
}

void SmartSelectTool::addSeed(const core::Pixel& pixel) {
    if (inPicture(pixel) && stroke_->seeds.size() < kMostSeeds) stroke_->seeds.push_back(pixel);
}

void SmartSelectTool::press(const ToolEvent& event) {
    stroke_.emplace();
    stroke_->removes = event.modifiers.testFlag(Qt::AltModifier);
    addSeed(pixelAt(event.position));
}

void SmartSelectTool::drag(const QPointF& position) {
    if (!stroke_ || session().photo() == nullptr) return;
    const core::Pixel pixel = pixelAt(position);
    const auto& color = session().photo()->color;
    const double spacing = std::max(4.0, kSeedSpacing * std::min(color.width(), color.height()));
    if (!stroke_->seeds.empty()) {
        const core::Pixel& last = stroke_->seeds.back();
        if (std::hypot(pixel.x - last.x, pixel.y - last.y) < spacing) return;
    }
    addSeed(pixel);
}

void SmartSelectTool::release() {
    if (!stroke_) return;
    const Stroke stroke = *std::exchange(stroke_, std::nullopt);
    if (stroke.seeds.empty()) {
        emit session().message(tr("Click inside the picture."));
        return;
    }
    const auto next = std::make_shared<core::PixelSelection>(with(stroke.seeds, stroke.removes));
    asked_ = next;
    session().worker().change(
        [next](const core::Selector& selector, const core::Progress& progress) {
            next->mask = pointedAt(*next, selector, progress);
        },
        [this, next, removes = stroke.removes] {
            session().replace(removes ? tr("Take from selection") : tr("Select"), *next);
        });
}

void SmartSelectTool::hover(const ToolEvent& event) {
    const core::Pixel pixel = pixelAt(event.position);
    const bool removes = event.modifiers.testFlag(Qt::AltModifier);
    if (!inPicture(pixel)) {
        leave();
        return;
    }
    if (hovered_ && hovered_->x == pixel.x && hovered_->y == pixel.y && hoverRemoves_ == removes) return;
    hovered_ = pixel;
    hoverRemoves_ = removes;
    // The selection is about to change.
    if (session().worker().prepared() && session().worker().busy()) return;
    const auto before = session().selection();
    const auto next = std::make_shared<core::PixelSelection>(with({pixel}, removes));
    session().worker().preview(
        [next](const core::Selector& selector, const core::Progress& progress) {
            next->mask = pointedAt(*next, selector, progress);
        },
        [this, before, next] {
            if (session().selection() == before) session().preview(&next->mask);
        });
}

void SmartSelectTool::leave() {
    hovered_.reset();
    session().worker().dropPreview();
    session().preview(nullptr);
}

bool SmartSelectTool::cancel() {
    if (!stroke_) return false;
    stroke_.reset();
    return true;
}

}  // namespace ui
