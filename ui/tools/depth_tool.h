// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/selection/depth_range.h"
#include "ui/tools/tool.h"

namespace ui {

/// Selects what is as far away as the pixel that is clicked, or lies on the same plane.
class DepthTool : public Tool {
    Q_OBJECT
  public:
    using Tool::Tool;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool drawsShapes() const override { return true; }
    QWidget* makeOptions(QWidget* parent) override;
    void press(const ToolEvent& event) override;
    void hover(const ToolEvent& event) override;
    void leave() override;

  private:
    core::DepthSelection wanted_;
    int smoothing_ = 0;  ///< [px]
};

}  // namespace ui
