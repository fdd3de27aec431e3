// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of composite.comp (immediates): blend of one segment's new radiance with the photograph.
#ifndef PATINA_COMPOSITE_BLOCK_H
#define PATINA_COMPOSITE_BLOCK_H

#include "shaders/shared/interop.h"

#define COMPOSITE_PIXELS 0        // the segment's pixels, x | y << 16
#define COMPOSITE_ACCUMULATION 1  // rgba32float: sum of radiance, sum of squared luminance
#define COMPOSITE_COUNT 2         // r32float: samples in the sum
#define COMPOSITE_FILTERED 3      // rgba32float: filtered colour
#define COMPOSITE_DIFFUSION 4     // rgba32float: radiant exitance below the boundary, 1 = known
#define COMPOSITE_RESULT 5        // rgba32float
#define COMPOSITE_DRIVES 6        // Drive
#define COMPOSITE_DRIVE_VALUES 7  // float

KERNEL_BEGIN

struct CompositeBlock {
    uint firstPixel;
    uint pixelCount;
    uint filtered;  // 1: take the filtered colour
    float blendNew;
    float blendOriginal;
    float translucentWeight;
    float eta;         // relative index of refraction of the boundary
    uint translucent;  // 1: add translucentWeight times the translucent light
    uint firstDrive;   // first of the drives of the weights
    uint driveCount;
    uint pad0;
    uint pad1;
};
KERNEL_BLOCK(CompositeBlock, 48)

KERNEL_END

#endif
