// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter that varies over the pixels of a segment, and its value from a stored one. Shared by kernels and the
// reference renderer; core/shading/drive_table.h makes the tables.
#ifndef PATINA_DRIVE_H
#define PATINA_DRIVE_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

struct Drive {
    vec4 from;    // rgb = the parameter's value where t = 0 (scalars: x); w = gain
    vec4 to;      // rgb = the value where t = 1; w = stored value for which t = range.x
    vec4 range;   // x = t of the stored value to.w; y, z = range of t
    uint slot;    // kDrive...
    uint offset;  // first of the plane of stored values
    uint origin;  // pixel of the plane's first value, x | y << 16
    uint stride;  // values in a row of the plane
};
KERNEL_BLOCK(Drive, 64)

// Slots 0 to 11 are BrdfParams::values.
const uint kDriveAlbedo = 12u;
const uint kDriveSpecular = 13u;
const uint kDriveEta = 14u;
const uint kDriveK = 15u;
const uint kDriveBlendNew = 16u;
const uint kDriveBlendOriginal = 17u;
const uint kDriveDiffuse = 18u;  // rgb: SegmentShading::diffuse, which the weight of the translucent light is part of
const uint kDriveTranslucentWeight = 19u;

/// Where the value of a pixel of the segment is stored.
KERNEL_FN uint drive_index(Drive d, uint x, uint y) {
    return d.offset + (y - (d.origin >> 16)) * d.stride + (x - (d.origin & 0xffffu));
}

KERNEL_FN vec3 drive_value(Drive d, float stored) {
    float t = clamp(d.range.x + d.from.w * (stored - d.to.w), d.range.y, d.range.z);
    return rgb(d.from) * (1.0f - t) + rgb(d.to) * t;
}

KERNEL_END

#endif
