// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/document.h"

#include <utility>

namespace core {

namespace {
constexpr std::size_t kMaxUndoSteps = 200;
}

Document::Document(Scene scene, std::string path) : scene_(std::move(scene)), path_(std::move(path)) {}

bool Document::modified() const { return state_ != savedState_; }

void Document::edit(const std::string& label, const std::function<void(Scene&)>& change, const std::string& mergeKey) {
    Scene next = scene_;
    change(next);
    if (next == scene_) return;
    const bool merges = !mergeKey.empty() && mergeKey == mergeKey_ && !undo_.empty();
    if (!merges) {
        undo_.push_back({label, scene_, state_});
        if (undo_.size() > kMaxUndoSteps) undo_.erase(undo_.begin());
    }
    mergeKey_ = mergeKey;
    redo_.clear();
    replace(std::move(next), ++lastState_);
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
