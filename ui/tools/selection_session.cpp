// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/selection_session.h"

#include <QLocale>
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
    : QObject(parent), workspace_(workspace), canvas_(canvas), change_(new SceneChange(workspace, &canvas)) {
    connect(&workspace, &Workspace::documentReplaced, this, &SelectionSession::followDocument);
    connect(&workspace, &Workspace::sceneChanged, this, &SelectionSession::followScene);
    connect(&workspace, &Workspace::selectionChanged, this, &SelectionSession::changed);
    connect(change_, &SceneChange::message, this, &SelectionSession::message);
    connect(change_, &SceneChange::failed, this, &SelectionSession::error);
    connect(&worker_, &SelectionWorker::failed, this, &SelectionSession::error);
}

void SelectionSession::followDocument() {
    worker_.setPhoto(photo());
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
    change(label, std::move(operation), [](std::size_t) {});
}

void SelectionSession::refine(const QString& label, Operation operation) {
    change(label, std::move(operation), [this](std::size_t changed) {
        emit message(changed > 0 ? tr("Refined: %1 pixels changed").arg(QLocale().toString(quint64{changed}))
                                 : tr("Refined: the outline already follows the photograph"));
    });
}

void SelectionSession::change(const QString& label, Operation operation,
                              const std::function<void(std::size_t changed)>& done) {
    const auto before = selection();
    if (before == nullptr) return;
    const auto result = std::make_shared<core::BinaryMask>();
    worker_.change([before, result, operation = std::move(operation)](
                       const core::Selector& selector,
                       const core::Progress& progress) { *result = operation(selector, before->mask, progress); },
                   [this, before, result, label, done] {
                       // Something else was selected meanwhile.
                       if (selection() != before) return;
                       std::size_t changed = 0;
                       for (std::size_t i = 0; i < result->size(); ++i)
                           if ((*result)[i] != before->mask[i]) ++changed;
                       core::PixelSelection next;
                       next.mask = std::move(*result);
                       replace(label, std::move(next));
                       done(changed);
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

void SelectionSession::changeScene(const QString& step, const SceneChange::Operation& change,
                                   const std::string& segment) {
    change_->run(
        step,
        [change](const core::Scene& scene, core::Notes* notes, const core::Progress& progress) {
            core::Scene changed = change(scene, notes, progress);
            changed.selection.reset();
            return changed;
        },
        [this, segment](const core::Scene&, const core::Notes& notes) {
            core::Scene found = workspace_.scene();
            const core::Segment* current = found.findSegment(segment);
            workspace_.select(current != nullptr ? current->label : std::uint16_t{0});
            if (!notes.empty()) emit message(translatedEach(notes).join(QLatin1Char(' ')));
        });
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
        [selected = selection(), name = name()](const core::Scene& scene, core::Notes* notes, const core::Progress&) {
            return core::withSegment(scene, selected->mask, name, notes);
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
        [use, selected = selection(), label = segment->label](const core::Scene& scene, core::Notes* notes,
                                                              const core::Progress&) {
            return core::combineSegment(scene, label, selected->mask, use, notes);
        },
        segment->name);
}

void SelectionSession::findObjects() {
    if (photo() == nullptr) return;
    const auto objects = std::make_shared<core::LabelImage>();
    worker_.change([objects](const core::Selector& selector,
                             const core::Progress& progress) { *objects = selector.propose(progress); },
                   [this, objects] {
                       change_->run(
                           tr("Find objects"),
                           [objects, name = tr("object").toStdString()](const core::Scene& scene, core::Notes* notes,
                                                                        const core::Progress&) {
                               try {
                                   return core::withSegments(scene, *objects, notes, name);
                               } catch (const core::Error& problem) {
                                   // That there is none is no failure.
                                   notes->push_back(problem.message());
                                   return scene;
                               }
                           },
                           [this](const core::Scene& before, const core::Notes& notes) {
                               const std::size_t found = workspace_.scene().segments.size() - before.segments.size();
                               emit message(notes.empty() ? tr("Objects found: %1").arg(found)
                                                          : translatedEach(notes).join(QLatin1Char(' ')));
                           });
                   });
}

}  // namespace ui
