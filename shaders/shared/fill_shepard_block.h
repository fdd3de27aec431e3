// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of analysis/fill_shepard.comp (immediates).
#ifndef PATINA_FILL_SHEPARD_BLOCK_H
#define PATINA_FILL_SHEPARD_BLOCK_H

#include "shaders/shared/interop.h"

#define FILL_SHEPARD_LEVELS 0   // uvec4 per level: width, height, first node, 0; [0] = the texels
#define FILL_SHEPARD_NODES 1    // two vec4 per node: direction, radius [rad]; sum of radiance, weight
#define FILL_SHEPARD_TARGETS 2  // vec4 per texel to fill: direction, 0
#define FILL_SHEPARD_RESULT 3   // vec4 per texel to fill: radiance, 0

KERNEL_BEGIN

struct FillShepardBlock {
    uint levelCount;
    uint first;     // target of the slice
    uint count;     // targets of the slice
    float opening;  // a group counts as one when its radius is smaller than this fraction of its distance
    float minCube;  // smallest cube of a distance [rad^3]
    uint pad0;
    uint pad1;
    uint pad2;
};
KERNEL_BLOCK(FillShepardBlock, 32)

KERNEL_END

#endif
