// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/panel.h"

namespace ui {

/// Quality of the picture and of the geometry it is computed from: samples, bounces, filters. All of its controls are
/// rows of core/scene/params.h.
class RenderPanel : public Panel {
    Q_OBJECT
  public:
    explicit RenderPanel(Workspace& workspace, QWidget* parent = nullptr);

  private:
    void refresh();
};

}  // namespace ui
