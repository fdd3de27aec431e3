#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// The baseline of [BRD14] Sec. 3.5 for the benchmark: constant steps through the depth image, which miss anything thinner.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/geometry.glsl"
#include "shaders/lib/list.glsl"
#include "shaders/shared/march_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { MarchBlock block; };
layout(set = 1, binding = MARCH_RAYS) readonly buffer Rays { vec4 rays[]; };
layout(set = 1, binding = MARCH_HITS) writeonly buffer Hits { vec4 hits[]; };

// Pixel, layer and distance of the first step inside a solid, as MARCH_HITS. The solid that contains the origin does not
// count until the ray has left it.
vec4 firstHit(vec3 p, vec3 d) {
    const vec4 none = vec4(0.0);
    if (d == vec3(0.0)) return none;
    bool inside = true;
    for (float t = 0.0; t <= block.maxDistance; t += block.stepSize) {
        vec3 q = p + d * t;
        if (!(q.z > 0.0)) return none;
        vec2 uv = geometry.camera.xy * q.xy / q.z + geometry.camera.zw;
        if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(geometry.width, geometry.height)))) return none;
        ivec2 pixel = ivec2(uv);
        vec4 frontPatch = texelFetch(frontPatchMap, pixel, 0);
        float w = 1.0 / q.z;
        bool solid = false;
        if (frontPatch.x > 0.0) {
            vec4 backPatch = texelFetch(backPatchMap, pixel, 0);
            vec2 offset = uv - vec2(pixel) - 0.5;
            float room = frontPatch.x + dot(frontPatch.yz, offset) - w;
            float depth = w - backPatch.x - dot(backPatch.yz, offset);
            solid = room >= 0.0 && depth >= 0.0;
            if (solid && !inside) return vec4(pixel + ivec2(1, 0), depth < room ? 1.0 : 0.0, t);
        }
        inside = inside && solid;
    }
    return none;
}

void main() {
    uint index = listIndex();
    if (index < sliceValue(block.rayCount)) hits[index] = firstHit(rays[2u * index].xyz, rays[2u * index + 1u].xyz);
}
