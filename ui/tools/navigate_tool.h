// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// Leaves the left button to the canvas, which picks segments and moves the picture.
class NavigateTool : public Tool {
    Q_OBJECT
  public:
    using Tool::Tool;
    [[nodiscard]] Pointer pointer() const override { return {}; }
    [[nodiscard]] QString hint() const override;
};

}  // namespace ui
