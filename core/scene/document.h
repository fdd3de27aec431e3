// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/changes.h"
#include "core/scene/scene.h"

namespace core {

/// An open project: the scene, its undo history, its file. Lives on one thread (the window's, or main).
class Document {
  public:
    Document() = default;
    explicit Document(Scene scene, std::string path = {});

    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// Grows with every change, undo and redo included; two different scenes never share a revision.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    /// Identifies the scene across undo and redo: the same again when a step is undone.
    [[nodiscard]] std::uint64_t state() const { return state_; }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] bool modified() const;

    /// Replaces the scene; no step is made when nothing changed, or when `change` throws. `label` names the step for
    /// the undo menu; successive edits with the same non-empty `mergeKey` (one slider being dragged) become one undo
    /// step until `endMerge`.
    void edit(const std::string& label, const std::function<void(Scene&)>& change, const std::string& mergeKey = {});
    void endMerge();

    [[nodiscard]] bool canUndo() const { return !undo_.empty(); }
    [[nodiscard]] bool canRedo() const { return !redo_.empty(); }
    [[nodiscard]] std::string undoLabel() const;
    [[nodiscard]] std::string redoLabel() const;
    void undo();
    void redo();

    /// Marks the current state as saved at `path`.
    void setSaved(const std::string& path);

    /// Called after every change with the first stage it touched.
    void setChangeListener(std::function<void(Stage)> listener) { listener_ = std::move(listener); }

  private:
    struct Step {
        std::string label;
        Scene scene;
        std::uint64_t state = 0;
    };
    void replace(Scene scene, std::uint64_t state);
    /// Drops the first steps when there are too many or they hold too much memory.
    void forgetOldSteps();

    Scene scene_;
    std::string path_;
    std::uint64_t revision_ = 1;
    std::uint64_t state_ = 1;
    std::uint64_t savedState_ = 1;
    std::uint64_t lastState_ = 1;
    std::vector<Step> undo_;
    std::vector<Step> redo_;
    std::string mergeKey_;
    std::function<void(Stage)> listener_;
};

}  // namespace core
