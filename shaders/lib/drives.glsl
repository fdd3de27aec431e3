// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that vary over the pixels of a segment. The includer declares `Drive drives[]` and `float driveValues[]`.
#ifndef PATINA_DRIVES_GLSL
#define PATINA_DRIVES_GLSL

#include "shaders/lib/list.glsl"
#include "shaders/shared/drive.h"

vec3 driveAt(uint i, ivec2 pixel) {
    return drive_value(drives[i], driveValues[drive_index(drives[i], uint(pixel.x), uint(pixel.y))]);
}

// The weight of `slot` in this pixel: `weight` of the block unless a drive of the composite replaces it.
float drivenWeight(float weight, uint slot, uint first, uint count, ivec2 pixel) {
    uint end = first + sliceValue(count);
    for (uint i = first; i < end; ++i)
        if (drives[i].slot == slot) weight = driveAt(i, pixel).x;
    return weight;
}

#endif
