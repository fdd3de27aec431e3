// SPDX-License-Identifier: GPL-3.0-or-later
// The surface a path from the camera starts on: a point anywhere in its pixel, and the normal there. Colour is averaged
// over a pixel; depth and normals are known at its centre only.
#ifndef PATINA_SHADING_POINT_H
#define PATINA_SHADING_POINT_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

/// Normal `n` of a pixel or, where the surface goes on there, `beside`: that of the pixel `away` [px] from it. For
/// bilinear interpolation between pixel centres. Patches: w, dw/du, dw/dv at the centre, label (core::DepthLayers).
KERNEL_FN vec3 continued_normal(vec4 own, vec3 n, vec4 next, vec3 beside, vec2 away) {
    if (next.w != own.w || !(next.x > 0.0f) || !(dot(beside, n) > 0.0f)) return n;
    float du = own.y * away.x;
    float dv = own.z * away.y;
    return abs(next.x - own.x - du - dv) <= abs(du) + abs(dv) + 0.01f * own.x ? beside : n;
}

KERNEL_END

#endif
