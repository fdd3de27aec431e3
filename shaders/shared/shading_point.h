// SPDX-License-Identifier: GPL-3.0-or-later
// The surface between the centres of pixels; colour and normals are known at the centres only.
#ifndef PATINA_SHADING_POINT_H
#define PATINA_SHADING_POINT_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

/// Whether the surface of a pixel continues in the pixel `away` [px] from it. Patches: w, dw/du, dw/dv at the centre
/// (core::DepthLayers).
KERNEL_FN bool surface_goes_on(vec3 own, vec3 next, vec2 away) {
    float du = own.y * away.x;
    float dv = own.z * away.y;
    return next.x > 0.0f && abs(next.x - own.x - du - dv) <= abs(du) + abs(dv) + 0.01f * own.x;
}

/// Normal `beside` of the pixel `away` [px] from a pixel where the surface continues there, otherwise the pixel's own
/// normal `n`. For bilinear interpolation between pixel centres. The patches' fourth component is the label.
KERNEL_FN vec3 continued_normal(vec4 own, vec3 n, vec4 next, vec3 beside, vec2 away) {
    bool same = next.w == own.w && dot(beside, n) > 0.0f;
    return same && surface_goes_on(vec3(own.x, own.y, own.z), vec3(next.x, next.y, next.z), away) ? beside : n;
}

KERNEL_END

#endif
