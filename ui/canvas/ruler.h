// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <memory>

#include "core/analysis/analysis.h"
#include "ui/workspace.h"

namespace ui {

class Canvas;

/// A length to be drawn beside a picture.
struct Ruler {
    double millimetres = 0;  ///< 1, 2 or 5 times a power of ten
    double pixels = 0;       ///< device pixels
    bool operator==(const Ruler&) const = default;
};

/// The longest round length of at most 200 logical pixels, so of 80 at least. `millimetresPerPixel` [mm per device
/// pixel], finite and > 0, else no length.
[[nodiscard]] Ruler roundRuler(double millimetresPerPixel, double devicePixelRatio);

/// "5 mm", "2 cm", "0.1 mm", "1 m".
[[nodiscard]] QString rulerText(double millimetres);

/// The ruler with its text, white with a dark rim on nothing, premultiplied RGBA8888 of device pixels.
[[nodiscard]] QImage rulerImage(const Ruler& ruler, double devicePixelRatio);

/// Shows in the canvas how large the selected segment is for the light below its surface.
class SubstanceRuler : public QObject {
    Q_OBJECT
  public:
    SubstanceRuler(const Workspace& workspace, Canvas& canvas, QObject* parent);

    void setShown(bool shown);
    /// Of the selected segment's substance at its median depth, per picture pixel [mm]; 0 when nothing translucent is
    /// selected.
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
