// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "core/base/binary_mask.h"
#include "ui/canvas/canvas.h"
#include "ui/scene_change.h"
#include "ui/tools/selection_worker.h"
#include "ui/workspace.h"

namespace ui {

/// The selection of the open document as tools see it: what is selected, how a change is previewed and made, and how it
/// becomes a segment. Every change is one undo step.
class SelectionSession : public QObject {
    Q_OBJECT
  public:
    SelectionSession(Workspace& workspace, Canvas& canvas, QObject* parent = nullptr);

    [[nodiscard]] Workspace& workspace() const { return workspace_; }
    [[nodiscard]] Canvas& canvas() const { return canvas_; }
    [[nodiscard]] SelectionWorker& worker() { return worker_; }
    /// Whether segments are being changed in the background.
    [[nodiscard]] bool changingSegments() const { return change_->running(); }
    /// nullptr: no photograph is open.
    [[nodiscard]] const std::shared_ptr<const core::Photo>& photo() const { return workspace_.scene().photo; }
    [[nodiscard]] bool hasDepth() const { return workspace_.hasDepth(); }
    /// nullptr: nothing is selected.
    [[nodiscard]] const std::shared_ptr<const core::PixelSelection>& selection() const {
        return workspace_.scene().selection;
    }
    /// What is selected, of the photograph's size; empty if nothing is.
    [[nodiscard]] const core::BinaryMask& selected() const;

    /// What a shape that is drawn does to the selection.
    [[nodiscard]] core::MaskUse use() const { return use_; }
    void setUse(core::MaskUse use);
    /// The same while keys are held: Shift adds, Alt takes away, both intersect.
    [[nodiscard]] core::MaskUse useWith(Qt::KeyboardModifiers modifiers) const;
    /// Pixels by which operations grow, shrink and smooth.
    [[nodiscard]] int width() const { return width_; }
    void setWidth(int width) { width_ = width; }

    /// Shows what the selection would become; nullptr = no change. With `part`, the same as before outside this box.
    void preview(const core::BinaryMask* result, const core::PixelBox* part = nullptr);
    /// Makes `selection` the selection; one that selects nothing is none.
    void replace(const QString& label, core::PixelSelection selection);
    /// Combines `mask` with the selection.
    void apply(const QString& label, const core::BinaryMask& mask, core::MaskUse use);
    /// Replaces the selection, in the background, by what `operation` makes of it.
    using Operation =
        std::function<core::BinaryMask(const core::Selector&, const core::BinaryMask& selected, const core::Progress&)>;
    void change(const QString& label, Operation operation);
    /// The same, and says how many pixels it changed.
    void refine(const QString& label, Operation operation);
    void clear();
    void selectAll();

    /// Makes a segment of what is selected, and selects that segment; nothing is selected afterwards.
    void makeSegment();
    /// Changes the current segment by what is selected.
    void changeSegment(core::MaskUse use);
    /// Makes segments of all objects that stand on the supports of the scene.
    void findObjects();

  signals:
    /// The selection, or what can be done with it.
    void changed();
    void message(const QString& text);
    void error(const QString& sentence);

  private:
    void change(const QString& label, Operation operation, const std::function<void(std::size_t changed)>& done);
    void followScene();
    void followDocument();
    /// One undo step after which nothing is selected and `segment` is current.
    void changeScene(const QString& step, const SceneChange::Operation& change, const std::string& segment);

    Workspace& workspace_;
    Canvas& canvas_;
    SelectionWorker worker_;
    SceneChange* change_;
    std::shared_ptr<const core::PixelSelection> shown_;
    core::MaskUse use_ = core::MaskUse::Replace;
    int width_ = 3;
};

}  // namespace ui
