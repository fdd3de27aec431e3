#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Marches a list of rays: for the analysis, the benchmark and the tests.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/march_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { MarchBlock block; };
#define MARCH_WITHOUT block.without
#include "shaders/lib/march.glsl"

layout(set = 1, binding = MARCH_RAYS) readonly buffer Rays { vec4 rays[]; };
layout(set = 1, binding = MARCH_HITS) writeonly buffer Hits { vec4 hits[]; };

void main() {
    uint index = listIndex();
    if (index >= sliceValue(block.rayCount)) return;
    vec3 origin = rays[2u * index].xyz;
    vec3 direction = rays[2u * index + 1u].xyz;
    if (direction == vec3(0.0)) {
        hits[index] = vec4(-1.0, -1.0, 0.0, 0.0);
        return;
    }
    MarchHit hit = block.method == MARCH_PYRAMID ? march(origin, direction)
                                                 : marchConstant(origin, direction, block.stepSize, block.maxDistance);
    hits[index] = hit.found ? vec4(hit.pixel, hit.back ? 1.0 : 0.0, hit.distance) : vec4(-1.0, -1.0, 0.0, 0.0);
}
