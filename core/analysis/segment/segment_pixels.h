// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/camera.h"
#include "core/base/pixel.h"

namespace core::analysis {

/// One segment among the others: the input of every method that invents its back.
struct SegmentPixels {
    const Camera& camera;
    const LabelImage& labels;
    const Surface& front;
    const std::vector<bool>& supports;  ///< `findSupports`
    std::uint16_t label;
    std::vector<Pixel> pixels;  ///< those with depth, row by row
    PixelBox box;

    [[nodiscard]] bool contains(int x, int y) const {
        return labels.contains(x, y) && labels(x, y) == label && front.depth(x, y) > 0;
    }
    /// Width of a pixel at depth z [m].
    [[nodiscard]] float footprint(float z) const { return 2 * z / (camera.fx + camera.fy); }
};

/// What lies beyond a side of a pixel.
enum class Beyond {
    Inside,   ///< the segment continues
    Outline,  ///< the object ends: something farther, nothing, or the support it stands on
    Unknown,  ///< the end of the object is beyond the picture's border or hidden by something nearer
};
[[nodiscard]] Beyond beyond(const SegmentPixels& segment, Pixel pixel, Pixel step);
/// Whether the segment ends beyond a side of a pixel because the support it stands on begins there.
[[nodiscard]] bool touchesSupport(const SegmentPixels& segment, Pixel pixel, Pixel step);

}  // namespace core::analysis
