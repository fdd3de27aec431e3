// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/selection/selection_stroke.h"
#include "ui/brush_size.h"
#include "ui/tools/tool.h"

namespace ui {

inline constexpr float kMinBrushRadius = 0.5f;

/// Size and behaviour of the brushes, which all of them share.
class BrushOptions : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;
    [[nodiscard]] const core::SelectionBrush& brush() const { return brush_; }
    void set(const core::SelectionBrush& brush);
    /// Largest radius [px].
    [[nodiscard]] float maximum() const { return maximum_; }
    void setMaximum(float radius);

  signals:
    void changed();

  private:
    core::SelectionBrush brush_;
    float maximum_ = kLeastMaxBrushRadius;
};

/// Paints the selection, or erases it. Alt does the opposite.
class BrushTool : public Tool {
    Q_OBJECT
  public:
    enum class Kind {
        Paint,
        Erase,
        Refine,  ///< paints where the outline is to be found again
    };
    /// `options` outlives the tool.
    BrushTool(SelectionSession& session, Kind kind, BrushOptions& options, QObject* parent = nullptr);

    [[nodiscard]] Pointer pointer() const override;
    [[nodiscard]] QString hint() const override;
    QWidget* makeOptions(QWidget* parent) override;
    void press(const ToolEvent& event) override;
    void drag(const QPointF& position) override;
    void release() override;
    bool finish() override;
    bool cancel() override;
    bool resize(float factor) override;

  private:
    void refine(const core::BinaryMask& painted);

    Kind kind_;
    BrushOptions& options_;
    std::shared_ptr<const core::Photo> photo_;  ///< whose images the stroke refers to
    std::optional<core::SelectionStroke> stroke_;
    bool erases_ = false;
};

}  // namespace ui
