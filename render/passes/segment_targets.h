// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/pixel.h"
#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/texture.h"

namespace render {

/// Pictures the passes work on, of the photo's size; shared by all segments, which are disjoint.
struct Targets {
    gpu::Texture accumulation;  ///< rgba32float: sum of radiance, sum of squared luminance
    gpu::Texture count;         ///< r32float: samples in the sum
    gpu::Texture filtered;      ///< rgba32float: colour, variance; 1x1 until the filter is used
    gpu::Texture filterPing;    ///< scratch of the filter; empty until the filter is used
    gpu::Texture filterPong;    ///< scratch of the filter; empty until the filter is used
    gpu::Texture diffusion;     ///< rgba32float: radiant exitance below the boundary, 1 = known; 1x1 until a segment
                                ///< is translucent
    gpu::Texture result;        ///< rgba32float: the edited photograph
    bool operator==(const Targets&) const = default;
};

/// What the edits need beyond the result itself.
struct TargetUses {
    bool filter = false;
    bool translucency = false;
};

/// Makes the pictures that are missing or have another size.
void fitTargets(Targets& targets, const gpu::Device& device, std::uint32_t width, std::uint32_t height,
                const TargetUses& uses);

/// Pixels of one segment with a valid depth.
struct PixelList {
    gpu::Buffer buffer;  ///< x | y << 16
    std::uint32_t count = 0;
    core::PixelBox bounds;
    bool operator==(const PixelList&) const = default;
};

/// Part of a pixel list.
struct PixelRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// What all paths need besides the geometry.
struct PathInputs {
    gpu::Buffer shading;      ///< kernel::SegmentShading per label
    gpu::Buffer dropped;      ///< one uint
    gpu::Buffer drives;       ///< kernel::Drive of all segments
    gpu::Buffer driveValues;  ///< float: the planes the drives refer to
    gpu::Buffer measured;     ///< tables of measured BRDFs, one after the other
    bool operator==(const PathInputs&) const = default;
};

}  // namespace render
