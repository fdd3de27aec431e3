// SPDX-License-Identifier: GPL-3.0-or-later
// The photographed scene as kernels read it: bind group 0 (shaders/lib/geometry.glsl).
#ifndef PATINA_GEOMETRY_BLOCK_H
#define PATINA_GEOMETRY_BLOCK_H

#include "shaders/shared/interop.h"

#define GEOMETRY_BLOCK 0              // GeometryBlock
#define GEOMETRY_PYRAMID 1            // uint per cell: packRange; where: pyramidTexel of pyramidIndex
#define GEOMETRY_FRONT_PATCH 2        // w [1/m], dw/du, dw/dv [1/(m px)], label
#define GEOMETRY_BACK_PATCH 3         // w, dw/du, dw/dv, unused
#define GEOMETRY_FRONT_COLOR 4        // radiance
#define GEOMETRY_BACK_COLOR 5         // radiance
#define GEOMETRY_FRONT_NORMAL 6       // unit, outward
#define GEOMETRY_BACK_NORMAL 7        // unit, outward
#define GEOMETRY_ENVIRONMENT 8        // radiance, latitude-longitude; a = density of its sampling [1/sr]
#define GEOMETRY_ENVIRONMENT_TABLE 9  // float: core::EnvironmentSampler::table()

KERNEL_BEGIN

struct GeometryBlock {
    vec4 camera;             // fx, fy, cx, cy [px]
    uint width;              // [px]
    uint height;             // [px]
    uint pyramidTop;         // coarsest level of the pyramid: cells of 2^pyramidTop pixels
    uint environmentWidth;   // [texel]
    uint environmentHeight;  // [texel]
    uint tableColumns;       // cells of the environment's table
    uint tableRows;
    uint tableCell;           // texels along a cell's side
    float meanLuminance;      // of the environment
    uint environmentSampled;  // 1: paths sample the environment too
    uint pyramidFinest;       // finest level that is stored; 0: the pixels, as long as the device's buffers hold them
    uint pyramidRows;         // rows of cells of the finest level, rounded up so that each level has half as many
    uint pyramidBlocks;       // blocks of 4x4 cells along a row
    float minW;               // all solids lie between them [1/m]; minW > maxW: there is none
    float maxW;
    uint pad0;
};
KERNEL_BLOCK(GeometryBlock, 80)

// Range of an empty cell: overlaps nothing.
const float kEmptyRangeMin = 3.0e38f;
const float kEmptyRangeMax = -3.0e38f;

// Range of w of the solid in one pixel: the patches linear over the pixel, rounding included.
KERNEL_FN vec2 pixelRange(vec4 frontPatch, vec4 backPatch) {
    if (!(frontPatch.x > 0.0f)) return vec2(kEmptyRangeMin, kEmptyRangeMax);
    float frontMax = frontPatch.x + 0.5f * (abs(frontPatch.y) + abs(frontPatch.z));
    float backMin = backPatch.x - 0.5f * (abs(backPatch.y) + abs(backPatch.z));
    return vec2(backMin - 1.0e-6f * abs(backMin), frontMax + 1.0e-6f * abs(frontMax));
}

// Scale from inverse depth to the pyramid's unit; a cell stores the smallest and the largest value in 16 bits each.
KERNEL_FN float rangeScale(float minW, float maxW) {
    // Smallest span for which rounding of a ray's w does not matter.
    return 65528.0f / max(maxW - minW, 0.05f * maxW);
}

const uint kEmptyCell = 0x0000ffffu;  // smallest > largest

// Position of w = minW, which leaves room for rounding outwards.
const float kRangeStart = 4.0f;

// Cell that holds [range.x, range.y], rounded outwards by more than a ray's w may be off; `scale`: rangeScale.
KERNEL_FN uint packRange(vec2 range, float minW, float scale) {
    if (!(range.x <= range.y)) return kEmptyCell;
    float low = clamp((range.x - minW) * scale + (kRangeStart - 2.0f), 0.0f, 65535.0f);
    float high = clamp((range.y - minW) * scale + (kRangeStart + 3.0f), 0.0f, 65535.0f);
    return uint(low) | (uint(high) << 16u);
}

// Range that contains those of two cells.
KERNEL_FN uint joinRanges(uint a, uint b) { return min(a & 0xffffu, b & 0xffffu) | (max(a >> 16u, b >> 16u) << 16u); }

// Where cell (x, y) of a level is stored, `step` levels above the finest one, which has `rows` rows (GeometryBlock).
// All levels stand in one map, coarser ones above finer ones, and the map lies in `blocks` blocks of 4x4 cells along a
// row: one line of a processor's cache each.
KERNEL_FN uint pyramidIndex(uint x, uint y, uint step, uint rows, uint blocks) {
    y += rows >> step;
    return (((y >> 2u) * blocks + (x >> 2u)) << 4u) + ((y & 3u) << 2u) + (x & 3u);
}

// The pyramid is a texture, because drivers read one for eight lanes at once and a buffer lane by lane. The index of a
// cell counts the texels row by row.
const uint kPyramidWidth = 4096u;  // [texel]; any device has textures as wide
KERNEL_FN uvec2 pyramidTexel(uint index) { return uvec2(index & (kPyramidWidth - 1u), index / kPyramidWidth); }

KERNEL_END

#endif
