// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of analysis/fit_surface.comp (immediates).
#ifndef PATINA_FIT_SURFACE_BLOCK_H
#define PATINA_FIT_SURFACE_BLOCK_H

#include "shaders/shared/interop.h"

#define FIT_SURFACE_DEPTH 0   // float per pixel: inverse depth [1/m], 0 = none
#define FIT_SURFACE_LABELS 1  // 16 bits per pixel, two in a word
#define FIT_SURFACE_TAPS 2    // vec4 per tap: dx, dy, weight, 1 / limit of the residual
#define FIT_SURFACE_KNOWN 3   // 3 floats per pixel: normals that are taken as they are where not zero
#define FIT_SURFACE_RESULT 4  // 7 floats per pixel of the slice: normal, position [m], area [m^2]

#define FIT_SURFACE_MAX_TAPS 25

KERNEL_BEGIN

struct FitSurfaceBlock {
    vec4 camera;          // fx, fy, cx, cy [px]
    uint width;           // [px]
    uint height;          // [px]
    uint first;           // pixel of the slice
    uint count;           // pixels of the slice
    uint tapCount;        // 9 or 25
    uint hasKnown;        // 1: FIT_SURFACE_KNOWN is there
    float relativeNoise;  // of the depth
    float sign;           // -1: front, towards the camera; 1: back
};
KERNEL_BLOCK(FitSurfaceBlock, 48)

KERNEL_END

#endif
