// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of reshade.comp (immediates): one slice of one segment's paths.
#ifndef PATINA_RESHADE_BLOCK_H
#define PATINA_RESHADE_BLOCK_H

#include "shaders/shared/interop.h"

#define RESHADE_SHADING 0       // SegmentShading per label
#define RESHADE_DROPPED 1       // one uint: samples that were not finite
#define RESHADE_PIXELS 2        // the segment's pixels, x | y << 16
#define RESHADE_ACCUMULATION 3  // rgba32float: sum of radiance, sum of squared luminance
#define RESHADE_COUNT 4         // r32float: samples in the sum
#define RESHADE_DRIVES 5        // Drive
#define RESHADE_DRIVE_VALUES 6  // float

KERNEL_BEGIN

struct ReshadeBlock {
    uint firstPixel;   // in the list
    uint pixelCount;   // pixels of this slice
    uint firstSample;  // samples accumulated already; 0 starts a new sum
    uint sampleCount;  // paths per pixel in this dispatch; 0 only clears
    uint seed;
    uint bounces;  // surfaces a path may visit
    uint pad0;
    uint pad1;
};
KERNEL_BLOCK(ReshadeBlock, 32)

KERNEL_END

#endif
