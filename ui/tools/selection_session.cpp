// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/selection_session.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/scene/segments.h"
#include "ui/words.h"

namespace ui {

namespace {

bool anySelected(const core::BinaryMask& mask) {
    return std::ranges::any_of(mask.pixels(), [](std::uint8_t value) { return value != 0; });
}

}  // namespace

SelectionSession::SelectionSession(Workspace& workspace, Canvas& canvas, QObject* parent)
    : QObject(parent), workspace_(workspace), canvas_(canvas) {
    connect(&workspace, &Workspace::documentReplaced, this, &SelectionSession::followDocument);
    connect(&workspace, &Workspace::sceneChanged, this, &SelectionSession::followScene);
    connect(&workspace, &Workspace::selectionChanged, this, &SelectionSession::changed);
    connect(&worker_, &SelectionWorker::failed, this, &SelectionSession::error);
}

void SelectionSession::followDocument() {
    const std::shared_ptr<const core::Photo>& opened = photo();
    hasDepth_ =
        opened != nullptr && std::ranges::any_of(std::as_const(opened->depth).pixels(), [](float z) { return z > 0; });
    worker_.setPhoto(opened);
    shown_.reset();
    preview(nullptr);
    emit changed();
}

void SelectionSession::followScene() {
    if (photo() == nullptr) return;
    worker_.setPhoto(photo());
    if (selection() != shown_) {
        worker_.dropPreview();
        preview(nullptr);
    }
    emit changed();
}

const core::BinaryMask& SelectionSession::selected() const {
    static const core::BinaryMask kNothing;
    return selection() != nullptr ? selection()->mask : kNothing;
}

void SelectionSession::setUse(core::MaskUse use) {
    if (use_ == use) return;
    use_ = use;
    emit changed();
}

core::MaskUse SelectionSession::useWith(Qt::KeyboardModifiers modifiers) const {
    const bool shift = modifiers.testFlag(Qt::ShiftModifier), alt = modifiers.testFlag(Qt::AltModifier);
    if (shift && alt) return core::MaskUse::Intersect;
    if (shift) return core::MaskUse::Add;
    return alt ? core::MaskUse::TakeFrom : use_;
}

void SelectionSession::preview(const core::BinaryMask* result, const core::PixelBox* part) {
    shown_ = selection();
    canvas_.showSelection(shown_ != nullptr ? &shown_->mask : nullptr, result, part);
}

void SelectionSession::replace(const QString& label, core::PixelSelection selection) {
    if (photo() == nullptr) return;
    std::shared_ptr<const core::PixelSelection> next;
    if (anySelected(selection.mask)) next = std::make_shared<const core::PixelSelection>(std::move(selection));
    const bool same = next == nullptr ? this->selection() == nullptr
                                      : this->selection() != nullptr && this->selection()->mask == next->mask &&
                                            this->selection()->add.size() == next->add.size() &&
                                            this->selection()->remove.size() == next->remove.size();
    if (same) {
        preview(nullptr);
        return;
    }
    workspace_.editScene(label, [&](core::Scene& scene) { scene.selection = next; });
}

void SelectionSession::apply(const QString& label, const core::BinaryMask& mask, core::MaskUse use) {
    core::PixelSelection next;
    next.mask = core::combineMasks(selected(), mask, use);
    replace(label, std::move(next));
}

void SelectionSession::change(const QString& label, Operation operation) {
    const auto before = selection();
    if (before == nullptr) return;
    const auto result = std::make_shared<core::BinaryMask>();
    worker_.change([before, result, operation = std::move(operation)](
                       const core::Selector& selector,
                       const core::Progress& progress) { *result = operation(selector, before->mask, progress); },
                   [this, before, result, label] {
                       // Something else was selected meanwhile.
                       if (selection() != before) return;
                       core::PixelSelection next;
                       next.mask = std::move(*result);
                       replace(label, std::move(next));
                   });
}

void SelectionSession::clear() {
    worker_.cancel();
    replace(tr("Clear selection"), {});
}

void SelectionSession::selectAll() {
    if (photo() == nullptr) return;
    core::PixelSelection all;
    all.mask = core::BinaryMask(photo()->color.width(), photo()->color.height(), 1);
    replace(tr("Select all"), std::move(all));
}

void SelectionSession::changeScene(const QString& step, const SceneChange& change, const std::string& segment) {
    try {
        core::Notes notes;
        core::Scene changed = change(workspace_.scene(), &notes);
        changed.selection.reset();
        const core::Segment* current = changed.findSegment(segment);
        const std::uint16_t label = current != nullptr ? current->label : std::uint16_t{0};
        workspace_.editScene(step, [&](core::Scene& scene) { scene = std::move(changed); });
        workspace_.select(label);
        if (!notes.empty()) emit message(translatedEach(notes).join(QLatin1Char(' ')));
    } catch (const core::Error& problem) {
        emit error(translated(problem));
    }
}

void SelectionSession::makeSegment() {
    if (worker_.changing()) {
        worker_.change([](const core::Selector&, const core::Progress&) {}, [this] { makeSegment(); });
        return;
    }
    if (selection() == nullptr) {
        emit message(tr("Select something in the picture first."));
        return;
    }
    int number = 1;
    const auto name = [&] { return tr("object %1").arg(number).toStdString(); };
    const auto taken = [&] {
        return std::ranges::any_of(workspace_.scene().segments,
                                   [&](const core::Segment& segment) { return segment.name == name(); });
    };
    while (taken()) ++number;
    changeScene(
        tr("New segment"),
        [&](const core::Scene& scene, core::Notes* notes) {
            return core::withSegment(scene, selected(), name(), notes);
        },
        name());
}

void SelectionSession::changeSegment(core::MaskUse use) {
    const core::Segment* segment = workspace_.selectedSegment();
    if (segment == nullptr || selection() == nullptr) return;
    const QString name = QString::fromStdString(segment->name);
    const QString step = use == core::MaskUse::Add        ? tr("Add to %1").arg(name)
                         : use == core::MaskUse::TakeFrom ? tr("Take from %1").arg(name)
                                                          : tr("Intersect with %1").arg(name);
    changeScene(
        step,
        [&, label = segment->label](const core::Scene& scene, core::Notes* notes) {
            return core::combineSegment(scene, label, selected(), use, notes);
        },
        segment->name);
}

void SelectionSession::findObjects() {
    if (photo() == nullptr) return;
    const auto objects = std::make_shared<core::LabelImage>();
    worker_.change([objects](const core::Selector& selector,
                             const core::Progress& progress) { *objects = selector.propose(progress); },
                   [this, objects] {
                       try {
                           core::Notes notes;
                           core::Scene changed =
                               core::withSegments(workspace_.scene(), *objects, &notes, tr("object").toStdString());
                           const std::size_t found = changed.segments.size() - workspace_.scene().segments.size();
                           if (found > 0)
                               workspace_.editScene(tr("Find objects"), [&](core::Scene& scene) { scene = changed; });
                           notes.empty() ? emit message(tr("Objects found: %1").arg(found))
                                         : emit message(translatedEach(notes).join(QLatin1Char(' ')));
                       } catch (const core::Error& problem) {
                           emit message(translated(problem));
                       }
                   });
}

}  // namespace ui
