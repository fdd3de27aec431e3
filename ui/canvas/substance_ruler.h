// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>

#include "core/analysis/analysis.h"
#include "ui/workspace.h"

namespace ui {

class Canvas;

/// Shows in the canvas the scale of the selected segment for light below its surface.
class SubstanceRuler : public QObject {
    Q_OBJECT
  public:
    SubstanceRuler(const Workspace& workspace, Canvas& canvas, QObject* parent);

    void setShown(bool shown);
    /// Size of a picture pixel in the selected segment's substance, at its median depth [mm]; 0 if nothing translucent
    /// is selected.
    [[nodiscard]] double millimetresPerPixel();

  private:
    void update();

    const Workspace& workspace_;
    Canvas& canvas_;
    bool shown_ = true;
    std::shared_ptr<const core::Analysis> depthFrom_;
    std::uint16_t depthOf_ = 0;
    double depth_ = 0;  ///< median [m] of segment `depthOf_` in `depthFrom_`
};

}  // namespace ui
