// SPDX-License-Identifier: GPL-3.0-or-later
// Bind group 0: the photograph's two layers, the pyramid over them, and the light.
#ifndef PATINA_GEOMETRY_GLSL
#define PATINA_GEOMETRY_GLSL

#include "shaders/shared/geometry_block.h"

layout(set = 0, binding = GEOMETRY_BLOCK) uniform Geometry { GeometryBlock geometry; };
layout(set = 0, binding = GEOMETRY_PYRAMID) uniform utexture2D pyramidMap;
layout(set = 0, binding = GEOMETRY_FRONT_PATCH) uniform texture2D frontPatchMap;
layout(set = 0, binding = GEOMETRY_BACK_PATCH) uniform texture2D backPatchMap;
layout(set = 0, binding = GEOMETRY_FRONT_COLOR) uniform texture2D frontColorMap;
layout(set = 0, binding = GEOMETRY_BACK_COLOR) uniform texture2D backColorMap;
layout(set = 0, binding = GEOMETRY_FRONT_NORMAL) uniform texture2D frontNormalMap;
layout(set = 0, binding = GEOMETRY_BACK_NORMAL) uniform texture2D backNormalMap;
layout(set = 0, binding = GEOMETRY_ENVIRONMENT) uniform texture2D environmentMap;
layout(set = 0, binding = GEOMETRY_ENVIRONMENT_TABLE) readonly buffer EnvironmentTable { float environmentTable[]; };

// Position [m] of continuous image point (u, v) at planar depth z.
vec3 backProject(vec2 uv, float z) {
    return vec3((uv.x - geometry.camera.z) / geometry.camera.x, (uv.y - geometry.camera.w) / geometry.camera.y, 1.0) * z;
}

vec4 environmentTexel(int x, int y) {
    int width = int(geometry.environmentWidth);
    int height = int(geometry.environmentHeight);
    x = x < 0 ? x + width : (x >= width ? x - width : x);
    return texelFetch(environmentMap, ivec2(x, clamp(y, 0, height - 1)), 0);
}

// Radiance from direction d (unit, pointing to the light): bilinear, wraps in U, clamped in V. w = density of
// sampleEnvironment at d [1/sr].
vec4 environmentLight(vec3 d) {
    vec2 size = vec2(geometry.environmentWidth, geometry.environmentHeight);
    vec2 texel = vec2(0.5 + atan(d.x, d.z) * (0.5 * kInvPi), acos(clamp(-d.y, -1.0, 1.0)) * kInvPi) * size - 0.5;
    vec2 base = floor(texel);
    vec2 f = texel - base;
    ivec2 i = ivec2(base);
    vec4 a = environmentTexel(i.x, i.y);
    vec4 b = environmentTexel(i.x + 1, i.y);
    vec4 c = environmentTexel(i.x, i.y + 1);
    vec4 e = environmentTexel(i.x + 1, i.y + 1);
    vec3 radiance = mix(mix(a.rgb, b.rgb, f.x), mix(c.rgb, e.rgb, f.x), f.y);
    bool right = f.x >= 0.5;
    return vec4(radiance, f.y < 0.5 ? (right ? b.w : a.w) : (right ? e.w : c.w));
}

vec3 environmentRadiance(vec3 d) { return environmentLight(d).rgb; }

// Index of the interval that contains u, in `count` cumulative probabilities from `first` on; `fraction`: position in it.
uint invertTable(uint first, uint count, float u, out float fraction) {
    uint low = 0u;
    uint high = count;
    while (high - low > 1u) {
        uint middle = (low + high) >> 1;
        if (environmentTable[first + middle] <= u)
            low = middle;
        else
            high = middle;
    }
    float start = environmentTable[first + low];
    fraction = (u - start) / (environmentTable[first + low + 1u] - start);
    return low;
}

// Direction towards bright parts of the environment, twin of core::EnvironmentSampler::sample; w = its density [1/sr].
vec4 sampleEnvironment(vec2 u) {
    vec2 size = vec2(geometry.environmentWidth, geometry.environmentHeight);
    float cell = float(geometry.tableCell);
    vec2 fraction;
    uint row = invertTable(0u, geometry.tableRows, u.y, fraction.y);
    uint first = geometry.tableRows + 1u + row * (geometry.tableColumns + 1u);
    uint column = invertTable(first, geometry.tableColumns, u.x, fraction.x);
    vec2 low = vec2(column, row) * cell;
    vec2 high = min(low + cell, size);
    float top = cos(kPi * low.y / size.y);
    float cosine = top + (cos(kPi * high.y / size.y) - top) * fraction.y;
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float phi = 2.0 * kPi * ((low.x + (high.x - low.x) * fraction.x) / size.x - 0.5);
    return vec4(sine * sin(phi), -cosine, sine * cos(phi), texelFetch(environmentMap, ivec2(low), 0).w);
}

#endif
