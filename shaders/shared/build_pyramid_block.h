// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of build_pyramid.comp (push constants): one dispatch per level, from the finest upwards.
#ifndef PATINA_BUILD_PYRAMID_BLOCK_H
#define PATINA_BUILD_PYRAMID_BLOCK_H

#include "shaders/shared/interop.h"

#define BUILD_PYRAMID_FRONT_PATCH 0
#define BUILD_PYRAMID_BACK_PATCH 1
#define BUILD_PYRAMID_RANGES 2

KERNEL_BEGIN

struct BuildPyramidBlock {
    uint level;         // the level to write; 1 reads the patches
    uint width;         // of that level [cells]
    uint height;        // of that level [cells]
    uint offset;        // of that level's first cell
    uint sourceWidth;   // of the level below
    uint sourceHeight;  // of the level below
    uint sourceOffset;  // of the level below
    uint pad0;
};
KERNEL_BLOCK(BuildPyramidBlock, 32)

KERNEL_END

#endif
