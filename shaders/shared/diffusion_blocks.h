// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters (immediates) and bindings of the kernels that sum light below a surface
// (core/shading/diffusion_grid.h).
#ifndef PATINA_DIFFUSION_BLOCKS_H
#define PATINA_DIFFUSION_BLOCKS_H

#include "shaders/shared/diffusion.h"

// diffusion_splat.comp: the light of samples into the finest grid.
#define DIFFUSION_SPLAT_BRICKS 0   // words, see diffusion.h
#define DIFFUSION_SPLAT_STARTS 1   // uint per brick of the finest level, and one more: its range of entries
#define DIFFUSION_SPLAT_ENTRIES 2  // uint: samples that reach into a brick
#define DIFFUSION_SPLAT_PLACES 3   // vec4 per sample: place in cells of the finest level; its area [m^2], 0 = not lit
#define DIFFUSION_SPLAT_SUMS 4     // vec4 per sample: sum of transmitted radiance
#define DIFFUSION_SPLAT_LIGHT 5    // vec4 per cell: light, area

// diffusion_restrict.comp: a grid's light and area into the next coarser one.
#define DIFFUSION_RESTRICT_BRICKS 0
#define DIFFUSION_RESTRICT_LIGHT 1  // vec4 per cell

// diffusion_smooth.comp: [1 4 1]/6 twice in each direction.
#define DIFFUSION_SMOOTH_BRICKS 0
#define DIFFUSION_SMOOTH_FROM 1  // vec4 per cell
#define DIFFUSION_SMOOTH_TO 2    // vec4 per cell

// diffusion_combine.comp: a level's part of the sum, added to that of all coarser levels.
#define DIFFUSION_COMBINE_BRICKS 0
#define DIFFUSION_COMBINE_NARROW 1  // vec4 per cell: light and area, smoothed twice
#define DIFFUSION_COMBINE_WIDE 2    // vec4 per cell: light and area, smoothed four times
#define DIFFUSION_COMBINE_SUM 3     // 2 vec4 per cell: sum of light; sum of area, which is that for an irradiance of 1

// diffusion_gather.comp: the sum onto pixels.
#define DIFFUSION_GATHER_BRICKS 0
#define DIFFUSION_GATHER_PIXELS 1     // uvec2: x | y << 16; brick of the finest level
#define DIFFUSION_GATHER_SUM 2        // vec4 per cell
#define DIFFUSION_GATHER_DIFFUSION 3  // rgba32float: radiant exitance before the boundary, 1 = known

KERNEL_BEGIN

/// For all kernels but the two below: bricks [firstBrick, firstBrick + brickCount).
struct DiffusionGridBlock {
    uint firstBrick;
    uint brickCount;
    uint levelFirst;  // splat: first brick of the finest level
    float scale;      // splat: sum of radiance -> irradiance
};
KERNEL_BLOCK(DiffusionGridBlock, 16)

struct DiffusionCombineBlock {
    vec4 narrow;  // rgb = weight of the light smoothed twice
    vec4 wide;    // rgb = weight of the light smoothed four times
    uint firstBrick;
    uint brickCount;
    float coarser;  // weight of the coarser levels' sum: 1, or 0 for the coarsest
    uint pad0;
};
KERNEL_BLOCK(DiffusionCombineBlock, 48)

struct DiffusionGatherBlock {
    vec4 corner;       // xyz = corner of the grids in their axes [m]; w = cell of the level to read [m]
    vec4 flatSurface;  // rgb = exitance of a flat surface for an irradiance of 1
    vec4 tolerance;    // rgb = deviation from it that the spread of samples explains
    uint firstPixel;
    uint pixelCount;
    uint level;  // 0 = the finest
    uint known;  // 0: only clear the pixels
};
KERNEL_BLOCK(DiffusionGatherBlock, 64)

KERNEL_END

#endif
