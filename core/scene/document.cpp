// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/document.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace core {

namespace {

constexpr std::size_t kMaxUndoSteps = 200;
/// Label maps, segments and selections that the undo history may hold [bytes].
constexpr std::size_t kMaxUndoBytes = std::size_t{1} << 30U;

/// Bytes of what a step does not share with the next one.
std::size_t ownBytes(const Scene& scene, const Scene& next) {
    std::size_t bytes = scene.segments.size() * sizeof(Segment);
    if (scene.photo != nullptr && scene.photo != next.photo)
        bytes += scene.photo->labels.size() * sizeof(std::uint16_t);
    if (scene.selection != nullptr && scene.selection != next.selection) bytes += scene.selection->mask.size();
    return bytes;
}

bool onlySelectionDiffers(const Scene& before, Scene after) {
    after.selection = before.selection;
    return before == after;
}

}  // namespace

Document::Document(Scene scene, std::string path) : scene_(std::move(scene)), path_(std::move(path)) {}

bool Document::modified() const { return state_ != savedState_; }

void Document::edit(const std::string& label, const std::function<void(Scene&)>& change, const std::string& mergeKey) {
    Scene next = scene_;
    change(next);
    if (next == scene_) return;
    const bool merges = !mergeKey.empty() && mergeKey == mergeKey_ && !undo_.empty();
    if (!merges) {
        undo_.push_back({label, scene_, state_});
        forgetOldSteps();
    }
    mergeKey_ = mergeKey;
    redo_.clear();
    const std::uint64_t state = onlySelectionDiffers(scene_, next) ? state_ : ++lastState_;
    replace(std::move(next), state);
}

void Document::forgetOldSteps() {
    std::size_t kept = 0, bytes = 0;
    const Scene* next = &scene_;
    for (auto step = undo_.rbegin(); step != undo_.rend() && kept < kMaxUndoSteps; ++step, ++kept) {
        bytes += ownBytes(step->scene, *next);
        if (bytes > kMaxUndoBytes) break;
        next = &step->scene;
    }
    kept = std::max<std::size_t>(kept, 1);
    if (kept < undo_.size()) undo_.erase(undo_.begin(), undo_.end() - static_cast<std::ptrdiff_t>(kept));
}

void Document::endMerge() { mergeKey_.clear(); }

std::string Document::undoLabel() const { return undo_.empty() ? std::string() : undo_.back().label; }
std::string Document::redoLabel() const { return redo_.empty() ? std::string() : redo_.back().label; }

void Document::undo() {
    if (undo_.empty()) return;
    Step step = std::move(undo_.back());
    undo_.pop_back();
    redo_.push_back({step.label, scene_, state_});
    mergeKey_.clear();
    replace(std::move(step.scene), step.state);
}

void Document::redo() {
    if (redo_.empty()) return;
    Step step = std::move(redo_.back());
    redo_.pop_back();
    undo_.push_back({step.label, scene_, state_});
    mergeKey_.clear();
    replace(std::move(step.scene), step.state);
}

void Document::setSaved(const std::string& path) {
    path_ = path;
    savedState_ = state_;
    mergeKey_.clear();
}

void Document::replace(Scene scene, std::uint64_t state) {
    const Stage stage = firstChangedStage(scene_, scene);
    scene_ = std::move(scene);
    state_ = state;
    ++revision_;
    if (listener_) listener_(stage);
}

}  // namespace core
