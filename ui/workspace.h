// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scene/brush.h"
#include "core/scene/changes.h"
#include "core/scene/document.h"

namespace ui {

/// The open document of a window with its selection and analysis. Panels edit through `document()` and listen here;
/// nothing in it computes.
class Workspace : public QObject {
    Q_OBJECT
  public:
    explicit Workspace(QObject* parent = nullptr);

    [[nodiscard]] core::Document& document() { return document_; }
    [[nodiscard]] const core::Document& document() const { return document_; }
    [[nodiscard]] const core::Scene& scene() const { return document_.scene(); }
    [[nodiscard]] bool hasPhoto() const { return scene().photo != nullptr; }
    /// Whether the photograph has depth anywhere.
    [[nodiscard]] bool hasDepth() const { return hasDepth_; }
    /// Opens another project; resets selection and analysis.
    void setDocument(core::Document document);

    /// Grows with every change, also across documents.
    [[nodiscard]] std::uint64_t generation() const { return generation_; }
    /// Generation of the last change that made the analysis stale.
    [[nodiscard]] std::uint64_t analysisGeneration() const { return analysisGeneration_; }

    /// Selected segment; 0 = none. Undo and redo of a step that makes or removes segments select again what was
    /// selected with the segments that come back.
    [[nodiscard]] std::uint16_t selectedLabel() const { return selected_; }
    [[nodiscard]] const core::Segment* selectedSegment() const { return scene().findSegment(selected_); }
    void select(std::uint16_t label);

    /// Latest analysis of this document, possibly of an older revision of it; nullptr before the first.
    [[nodiscard]] const std::shared_ptr<const core::Analysis>& analysis() const { return analysis_; }
    void setAnalysis(std::shared_ptr<const core::Analysis> analysis);

    /// One edit of the selected segment, as an undo step (see core::Document::edit). Does nothing without a selection.
    void editSelected(const QString& label, const std::function<void(core::Segment&)>& change,
                      const QString& mergeKey = {});
    /// One edit of the scene.
    void editScene(const QString& label, const std::function<void(core::Scene&)>& change, const QString& mergeKey = {});
    void endMerge() { document_.endMerge(); }

    /// The materials that the segments of this document had before they got others, one for each segment and BRDF. Not
    /// part of the document.
    void keepMaterial(std::uint16_t label, const core::Material& material);
    /// nullptr = the segment has never had one with this BRDF.
    [[nodiscard]] const core::Material* keptMaterial(std::uint16_t label, const core::Material& brdf) const;

    /// The parameter whose mask the pointer paints, in the selected segment's edit; "" = the pointer selects and moves.
    [[nodiscard]] const std::string& paintedParameter() const { return painted_; }
    /// "" or a parameter with a drive by mask; ignores any other.
    void setPaintedParameter(const std::string& parameter);
    /// The painted drive; nullptr = none.
    [[nodiscard]] const core::Drive* paintedDrive() const;
    [[nodiscard]] const core::Brush& brush() const { return brush_; }
    void setBrush(const core::Brush& brush);

    /// The next click on the picture calls `use` with its pixel instead of selecting what is there. nullptr = clicks
    /// select again, as they do after the click and when another segment is selected.
    void pickPixel(std::function<void(int x, int y)> use);
    [[nodiscard]] bool picking() const { return picked_ != nullptr; }
    void finishPicking(int x, int y);

  signals:
    void pickingChanged();
    /// The painted parameter or the brush.
    void paintingChanged();
    void sceneChanged(core::Stage firstStage);
    void selectionChanged(quint16 label);
    void analysisChanged();
    void documentReplaced();

  private:
    void changed(core::Stage stage);
    /// Selects what was selected when the document was in this state, if its segments are others than before.
    void restoreSelection();

    core::Document document_;
    bool hasDepth_ = false;
    std::uint64_t generation_ = 1;
    std::uint64_t analysisGeneration_ = 1;
    std::uint16_t selected_ = 0;
    std::map<std::uint64_t, std::uint16_t> selectedIn_;  ///< by state of the document
    std::vector<std::uint16_t> labels_;                  ///< of the segments at the last change
    std::string painted_;
    core::Brush brush_;
    std::function<void(int, int)> picked_;
    std::map<std::pair<std::uint16_t, std::string>, core::Material> materials_;  ///< by segment and BRDF
    std::shared_ptr<const core::Analysis> analysis_;
};

}  // namespace ui
