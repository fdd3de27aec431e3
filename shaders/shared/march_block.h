// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of march_rays.comp and march_constant.comp (immediates).
#ifndef PATINA_MARCH_BLOCK_H
#define PATINA_MARCH_BLOCK_H

#include "shaders/shared/interop.h"

#define MARCH_RAYS 0  // two vec4 per ray: origin [m], direction (unit; zero = no ray, hits nothing)
#define MARCH_HITS 1  // one vec4 per ray: x + 1 (0 = none), y, 1 = entered through the back layer, distance [m]

KERNEL_BEGIN

struct MarchBlock {
    uint rayCount;
    uint share;         // pyramid only: rays per workgroup
    float stepSize;     // constant steps only [m]
    float maxDistance;  // constant steps only [m]
    float without;      // pyramid only: pixels with this label count as empty; -1 = none
    uint workers;       // pyramid only: number of equal parts of the workgroups that neighbouring shares go to in turn
    uint groupsPerWorker;
    uint pad0;
};
KERNEL_BLOCK(MarchBlock, 32)

KERNEL_END

#endif
