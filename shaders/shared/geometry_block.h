// SPDX-License-Identifier: GPL-3.0-or-later
// What every kernel that looks at the photographed scene reads: bind group 0 (shaders/lib/geometry.glsl).
#ifndef PATINA_GEOMETRY_BLOCK_H
#define PATINA_GEOMETRY_BLOCK_H

#include "shaders/shared/interop.h"

#define GEOMETRY_BLOCK 0         // GeometryBlock
#define GEOMETRY_PYRAMID 1       // vec2 (least w, greatest w) per cell, levels 1, 2, ... one after the other
#define GEOMETRY_FRONT_PATCH 2   // w [1/m], dw/du, dw/dv [1/(m px)], label
#define GEOMETRY_BACK_PATCH 3    // w, dw/du, dw/dv, unused
#define GEOMETRY_FRONT_COLOR 4   // radiance
#define GEOMETRY_BACK_COLOR 5    // radiance
#define GEOMETRY_FRONT_NORMAL 6  // unit, outward
#define GEOMETRY_BACK_NORMAL 7   // unit, outward
#define GEOMETRY_ENVIRONMENT \
    8  // radiance, latitude-longitude (core/directional_map.h); a = density of its sampling [1/sr]
#define GEOMETRY_ENVIRONMENT_TABLE 9  // float: core::EnvironmentSampler::table()

KERNEL_BEGIN

struct GeometryBlock {
    vec4 camera;             // fx, fy, cx, cy [px]
    uint width;              // [px]
    uint height;             // [px]
    uint levelCount;         // pyramid levels above the pixels; the last one is a single cell
    uint environmentWidth;   // [texel]
    uint environmentHeight;  // [texel]
    uint tableColumns;       // cells of the environment's table
    uint tableRows;
    uint tableCell;           // texels along a cell's side
    float meanLuminance;      // of the environment
    uint environmentSampled;  // 1: paths sample the environment too
    uint pad0;
    uint pad1;
};
KERNEL_BLOCK(GeometryBlock, 64)

// Range of an empty cell: overlaps nothing.
const float kEmptyRangeMin = 3.0e38f;
const float kEmptyRangeMax = -3.0e38f;

// Range [least, greatest] w of the solid in one pixel: the patches linear over the pixel, rounding included.
KERNEL_FN vec2 pixelRange(vec4 frontPatch, vec4 backPatch) {
    if (!(frontPatch.x > 0.0f)) return vec2(kEmptyRangeMin, kEmptyRangeMax);
    float frontMax = frontPatch.x + 0.5f * (abs(frontPatch.y) + abs(frontPatch.z));
    float backMin = backPatch.x - 0.5f * (abs(backPatch.y) + abs(backPatch.z));
    return vec2(backMin - 1.0e-6f * abs(backMin), frontMax + 1.0e-6f * abs(frontMax));
}

KERNEL_END

#endif
