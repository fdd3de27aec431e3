// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of irradiance.comp (immediates): some rays of some surface samples.
#ifndef PATINA_IRRADIANCE_BLOCK_H
#define PATINA_IRRADIANCE_BLOCK_H

#include "shaders/shared/interop.h"

#define IRRADIANCE_SHADING 0       // SegmentShading per label
#define IRRADIANCE_DROPPED 1       // one uint: samples that were not finite
#define IRRADIANCE_POINTS 2        // SurfacePoint per sample
#define IRRADIANCE_SUMS 3          // vec4 per sample: sum of transmitted radiance
#define IRRADIANCE_DRIVES 4        // Drive
#define IRRADIANCE_DRIVE_VALUES 5  // float

KERNEL_BEGIN

struct SurfacePoint {
    vec4 position;  // xyz [m]; w = the sample's number, which its random numbers depend on
    vec4 normal;    // xyz unit, outward
};
KERNEL_BLOCK(SurfacePoint, 32)

struct IrradianceBlock {
    uint firstPoint;
    uint pointCount;  // points of this slice
    uint firstRay;    // rays summed already; 0 starts a new sum
    uint rayCount;    // rays per point in this dispatch
    uint label;       // segment the points lie on
    uint seed;        // of the segment's own stream
    uint bounces;     // surfaces a path may visit
    float eta;        // relative index of refraction of the boundary
};
KERNEL_BLOCK(IrradianceBlock, 32)

KERNEL_END

#endif
