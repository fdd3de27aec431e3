// SPDX-License-Identifier: GPL-3.0-or-later
// What every kernel that looks at the photographed scene reads: bind group 0 (shaders/lib/geometry.glsl).
#ifndef PATINA_GEOMETRY_BLOCK_H
#define PATINA_GEOMETRY_BLOCK_H

#include "shaders/shared/interop.h"

#define GEOMETRY_BLOCK 0         // GeometryBlock
#define GEOMETRY_PYRAMID 1       // uint per cell: packRange; where: pyramidTexel of pyramidIndex
#define GEOMETRY_FRONT_PATCH 2   // w [1/m], dw/du, dw/dv [1/(m px)], label
#define GEOMETRY_BACK_PATCH 3    // w, dw/du, dw/dv, unused
#define GEOMETRY_FRONT_COLOR 4   // radiance
#define GEOMETRY_BACK_COLOR 5    // radiance
#define GEOMETRY_FRONT_NORMAL 6  // unit, outward
#define GEOMETRY_BACK_NORMAL 7   // unit, outward
#define GEOMETRY_ENVIRONMENT \
    8  // radiance, latitude-longitude (core/base/directional_map.h); a = density of its sampling [1/sr]
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
    float leastW;             // all solids lie between them [1/m]; leastW > greatestW: there is none
    float greatestW;
    uint pad0;
};
KERNEL_BLOCK(GeometryBlock, 80)

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

// Inverse depth in the pyramid's unit, of which a cell stores the least and the greatest value in 16 bits each.
KERNEL_FN float rangeScale(float leastW, float greatestW) {
    // Below this span, rounding of a ray's w would count.
    return 65528.0f / max(greatestW - leastW, 0.05f * greatestW);
}

const uint kEmptyCell = 0x0000ffffu;  // least > greatest

// Where w = leastW is, so that ranges can be rounded outwards.
const float kRangeStart = 4.0f;

// Cell that holds [range.x, range.y], rounded outwards by more than a ray's w may be off; `scale`: rangeScale.
KERNEL_FN uint packRange(vec2 range, float leastW, float scale) {
    if (!(range.x <= range.y)) return kEmptyCell;
    float low = clamp((range.x - leastW) * scale + (kRangeStart - 2.0f), 0.0f, 65535.0f);
    float high = clamp((range.y - leastW) * scale + (kRangeStart + 3.0f), 0.0f, 65535.0f);
    return uint(low) | (uint(high) << 16u);
}

// What holds two cells.
KERNEL_FN uint joinRanges(uint a, uint b) { return min(a & 0xffffu, b & 0xffffu) | (max(a >> 16u, b >> 16u) << 16u); }

// Where cell (x, y) of a level is stored, `step` levels above the finest one, which has `rows` rows (GeometryBlock).
// All levels stand in one map, coarser ones above finer ones, and the map lies in `blocks` blocks of 4x4 cells along a
// row: one line of a processor's cache each.
KERNEL_FN uint pyramidIndex(uint x, uint y, uint step, uint rows, uint blocks) {
    y += rows >> step;
    return (((y >> 2u) * blocks + (x >> 2u)) << 4u) + ((y & 3u) << 2u) + (x & 3u);
}

// The pyramid is a texture because processors read one by eight lanes at once, and a buffer lane by lane. The index of
// a cell counts its texels row by row.
const uint kPyramidWidth = 4096u;  // [texel]; any device has textures as wide
KERNEL_FN uvec2 pyramidTexel(uint index) { return uvec2(index & (kPyramidWidth - 1u), index / kPyramidWidth); }

KERNEL_END

#endif
