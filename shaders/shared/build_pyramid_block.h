// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of build_pyramid.comp (immediates): one dispatch per level, from the finest upwards.
#ifndef PATINA_BUILD_PYRAMID_BLOCK_H
#define PATINA_BUILD_PYRAMID_BLOCK_H

#include "shaders/shared/interop.h"

#define BUILD_PYRAMID_FRONT_PATCH 0
#define BUILD_PYRAMID_BACK_PATCH 1
#define BUILD_PYRAMID_RANGES 2

KERNEL_BEGIN

struct BuildPyramidBlock {
    uint step;          // levels above the finest one; 0 reads the patches
    uint width;         // of the level to write [cells]
    uint height;        // of the level to write [cells]
    uint sourceWidth;   // of the level below [cells]; of the picture for step 0
    uint sourceHeight;  // of the level below
    uint finest;        // GeometryBlock::pyramidFinest
    uint blocks;        // GeometryBlock::pyramidBlocks
    uint rows;          // GeometryBlock::pyramidRows
    float minW;         // GeometryBlock::minW [1/m]
    float scale;        // rangeScale
    uint pad0;
    uint pad1;
};
KERNEL_BLOCK(BuildPyramidBlock, 48)

KERNEL_END

#endif
