// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "gpu/buffer.h"
#include "gpu/texture.h"

namespace render {

/// Pictures the passes work on, of the photo's size; shared by all segments, which are disjoint.
struct Targets {
    gpu::Texture accumulation;  ///< rgba32float: sum of radiance, sum of squared luminance
    gpu::Texture count;         ///< r32float: samples in the sum
    gpu::Texture filtered;      ///< rgba32float: colour, variance; 1x1 until the filter is used
    gpu::Texture filterPing;    ///< scratch of the filter
    gpu::Texture filterPong;    ///< scratch of the filter
    gpu::Texture diffusion;     ///< rgba32float: radiant exitance below the boundary, 1 = known; 1x1 until a segment
                                ///< is translucent
    gpu::Texture result;        ///< rgba32float: the edited photograph
};

/// Smallest rectangle around pixels, first to last but one; empty when x1 <= x0.
struct PixelBounds {
    int x0 = std::numeric_limits<int>::max();
    int y0 = std::numeric_limits<int>::max();
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] bool empty() const { return x1 <= x0 || y1 <= y0; }
    void include(int x, int y) { include({x, y, x + 1, y + 1}); }
    void include(const PixelBounds& other) {
        x0 = std::min(x0, other.x0);
        y0 = std::min(y0, other.y0);
        x1 = std::max(x1, other.x1);
        y1 = std::max(y1, other.y1);
    }
};

/// Pixels of one segment with a valid depth.
struct PixelList {
    gpu::Buffer buffer;  ///< x | y << 16
    std::uint32_t count = 0;
    PixelBounds bounds;
};

/// What all paths need besides the geometry.
struct PathInputs {
    gpu::Buffer shading;      ///< kernel::SegmentShading per label
    gpu::Buffer dropped;      ///< one uint
    gpu::Buffer drives;       ///< kernel::Drive of all segments
    gpu::Buffer driveValues;  ///< float: the planes the drives refer to
    gpu::Buffer measured;     ///< tables of measured BRDFs, one after the other
};

}  // namespace render
