// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QRect>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scene/mask.h"
#include "core/scene/scene.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/canvas/view_layer.h"
#include "ui/canvas/view_transform.h"

namespace ui {

/// A picture as the canvas uploads it: half floats, four a pixel.
struct CanvasPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> rgba;
    bool displayEncoded = false;
};
[[nodiscard]] std::shared_ptr<const CanvasPicture> makeCanvasPicture(const LayerPicture& picture);

/// What the pointer does on the picture.
struct Pointer {
    bool strokes = false;   ///< the left button draws strokes; otherwise it selects segments and moves the picture
    float brushRadius = 0;  ///< [picture pixels] of the circle around it; 0 = none
    Qt::CursorShape shape = Qt::ArrowCursor;
    bool operator==(const Pointer&) const = default;
};

/// The picture pixel under the pointer.
struct CursorValue {
    int x = 0;  ///< picture pixel
    int y = 0;
    bool inside = false;
    bool hasResult = false;  ///< `result` was read back from the device
    core::Vector3f result{0, 0, 0};
};

/// Everything the canvas shows, independent of any device.
struct CanvasState {
    std::shared_ptr<const core::Photo> photo;
    std::shared_ptr<const CanvasPicture> original;
    std::shared_ptr<const CanvasPicture> layerPicture;
    ViewLayer layer = ViewLayer::Result;
    std::shared_ptr<const core::Scene> scene;  ///< nullptr until there is an analysis
    std::shared_ptr<const core::Analysis> analysis;
    std::uint64_t sceneNumber = 0;  ///< counts the scenes that were set
    bool suspended = false;         ///< the renderer gets no work at all
    bool refining = true;           ///< false: changes stop at their first picture
    std::uint16_t selected = 0;
    QRect selectedBounds;  ///< smallest rectangle around the selected segment [picture pixels]
    bool outlineShown = true;
    float exposureStops = 0;
    bool comparing = false;
    std::shared_ptr<const core::Mask> mask;  ///< shown in red
    float brushRadius = 0;                   ///< [picture pixels]; 0 = no brush
    /// Selected pixels. Mutable, because the painter notes what it has seen.
    mutable PixelOverlay overlay;
    bool brushShown = false;      ///< the pointer is over the view
    QPointF brushCenter;          ///< picture position under the pointer
    double rulerMillimetres = 0;  ///< size of a picture pixel [mm]; 0 = no ruler
    ViewTransform view;
    QPoint cursor;  ///< picture pixel under the pointer
    bool cursorInside = false;
};

}  // namespace ui
