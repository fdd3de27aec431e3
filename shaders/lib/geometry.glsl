// SPDX-License-Identifier: GPL-3.0-or-later
// Bind group 0: the photograph's two layers, the pyramid over them, and the light.
#ifndef PATINA_GEOMETRY_GLSL
#define PATINA_GEOMETRY_GLSL

#include "shaders/shared/geometry_block.h"

layout(set = 0, binding = GEOMETRY_BLOCK) uniform Geometry { GeometryBlock geometry; };
layout(set = 0, binding = GEOMETRY_PYRAMID) readonly buffer Pyramid { vec2 pyramid[]; };
layout(set = 0, binding = GEOMETRY_FRONT_PATCH) uniform texture2D frontPatchMap;
layout(set = 0, binding = GEOMETRY_BACK_PATCH) uniform texture2D backPatchMap;
layout(set = 0, binding = GEOMETRY_FRONT_COLOR) uniform texture2D frontColorMap;
layout(set = 0, binding = GEOMETRY_BACK_COLOR) uniform texture2D backColorMap;
layout(set = 0, binding = GEOMETRY_FRONT_NORMAL) uniform texture2D frontNormalMap;
layout(set = 0, binding = GEOMETRY_BACK_NORMAL) uniform texture2D backNormalMap;
layout(set = 0, binding = GEOMETRY_ENVIRONMENT) uniform texture2D environmentMap;

// Position [m] of continuous image point (u, v) at planar depth z.
vec3 backProject(vec2 uv, float z) {
    return vec3((uv.x - geometry.camera.z) / geometry.camera.x, (uv.y - geometry.camera.w) / geometry.camera.y, 1.0) * z;
}

vec3 environmentTexel(int x, int y) {
    int width = int(geometry.environmentWidth);
    int height = int(geometry.environmentHeight);
    x = x < 0 ? x + width : (x >= width ? x - width : x);
    return texelFetch(environmentMap, ivec2(x, clamp(y, 0, height - 1)), 0).rgb;
}

// Radiance from direction d (unit, pointing to the light): bilinear, wraps in U, clamped in V.
vec3 environmentRadiance(vec3 d) {
    vec2 size = vec2(geometry.environmentWidth, geometry.environmentHeight);
    vec2 texel = vec2(0.5 + atan(d.x, d.z) * (0.5 * kInvPi), acos(clamp(-d.y, -1.0, 1.0)) * kInvPi) * size - 0.5;
    vec2 base = floor(texel);
    vec2 f = texel - base;
    ivec2 i = ivec2(base);
    return mix(mix(environmentTexel(i.x, i.y), environmentTexel(i.x + 1, i.y), f.x),
               mix(environmentTexel(i.x, i.y + 1), environmentTexel(i.x + 1, i.y + 1), f.x), f.y);
}

#endif
