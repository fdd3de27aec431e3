// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of dipole_gather.comp (push constants): some surface samples onto some pixels.
#ifndef PATINA_DIPOLE_GATHER_BLOCK_H
#define PATINA_DIPOLE_GATHER_BLOCK_H

#include "shaders/shared/interop.h"

#define DIPOLE_GATHER_PARAMS 0     // DipoleParams
#define DIPOLE_GATHER_PIXELS 1     // the segment's pixels, x | y << 16
#define DIPOLE_GATHER_POINTS 2     // SurfacePoint per sample
#define DIPOLE_GATHER_SUMS 3       // vec4 per sample: sum of transmitted radiance
#define DIPOLE_GATHER_DIFFUSION 4  // rgba32float: sum of E R_d, number of samples in it

KERNEL_BEGIN

struct DipoleGatherBlock {
    uint firstPixel;
    uint pixelCount;  // pixels of this slice
    uint firstPoint;  // samples summed already; 0 starts a new sum
    uint pointCount;  // samples of this slice; 0 only clears
    float sumScale;   // pi / rays: sum of radiance -> irradiance
    float pad0;
    float pad1;
    float pad2;
};
KERNEL_BLOCK(DipoleGatherBlock, 32)

KERNEL_END

#endif
