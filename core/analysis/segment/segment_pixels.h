// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/camera.h"

namespace core::analysis {

struct Pixel {
    int x, y;
};

/// The four neighbours of a pixel: left, right, above, below.
inline constexpr std::array<Pixel, 4> kNeighbors{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Smallest rectangle around pixels.
struct PixelBox {
    int x0 = std::numeric_limits<int>::max(), y0 = std::numeric_limits<int>::max(), x1 = -1, y1 = -1;
    void add(Pixel p) {
        x0 = std::min(x0, p.x);
        y0 = std::min(y0, p.y);
        x1 = std::max(x1, p.x);
        y1 = std::max(y1, p.y);
    }
    [[nodiscard]] int width() const { return x1 - x0 + 1; }
    [[nodiscard]] int height() const { return y1 - y0 + 1; }
};

/// One segment among the others, as every way to invent its back sees it.
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
    Inside,   ///< the segment goes on
    Outline,  ///< the object ends here: something farther, nothing, or what it stands on
    Unknown,  ///< the picture ends, or something nearer hides where the object ends
};
[[nodiscard]] Beyond beyond(const SegmentPixels& segment, Pixel pixel, Pixel step);
/// Whether the segment ends beyond a side of a pixel because what it stands on begins there.
[[nodiscard]] bool touchesSupport(const SegmentPixels& segment, Pixel pixel, Pixel step);

}  // namespace core::analysis
