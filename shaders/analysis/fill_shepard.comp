#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Shepard's interpolation over the sphere, twin of core::analysis::DirectionTree::interpolate: a walk down the tree per
// texel, with a stack instead of recursion, in the same order.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/fill_shepard_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { FillShepardBlock block; };
layout(set = 0, binding = FILL_SHEPARD_LEVELS) readonly buffer Levels { uvec4 levels[]; };
layout(set = 0, binding = FILL_SHEPARD_NODES) readonly buffer Nodes { vec4 nodes[]; };
layout(set = 0, binding = FILL_SHEPARD_TARGETS) readonly buffer Targets { vec4 targets[]; };
layout(set = 0, binding = FILL_SHEPARD_RESULT) writeonly buffer Result { vec4 results[]; };

// asin for x in [0, 0.5] to 1e-6 relative (its series): the built-in one may be off by a thousandth.
float arcSineSeries(float x) {
    float q = x * x;
    return x * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0 +
           q * (945.0 / 42240.0 + q * (10395.0 / 599040.0 + q * (135135.0 / 9676800.0 + q * 0.01155180))))))));
}

float angleBetween(vec3 a, vec3 b) {
    float h = min(1.0, 0.5 * length(a - b));
    return h <= 0.5 ? 2.0 * arcSineSeries(h) : kPi - 4.0 * arcSineSeries(sqrt(0.5 * (1.0 - h)));
}

// A node of the tree, 4 bits of level and 14 of each coordinate: the map has at most 4096 x 2048 texels.
uint pack(uint level, uint x, uint y) { return level << 28 | y << 14 | x; }

void main() {
    uint index = listIndex();
    if (index >= sliceValue(block.count)) return;
    vec3 direction = targets[block.first + index].xyz;
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    uint stack[48];  // at most three waiting nodes per level
    int depth = 1;
    stack[0] = pack(block.levelCount - 1u, 0u, 0u);
    while (depth > 0) {
        uint packed = stack[--depth];
        uint level = packed >> 28;
        uvec2 cell = uvec2(packed & 0x3fffu, (packed >> 14) & 0x3fffu);
        uvec4 grid = levels[level];
        uint node = 2u * (grid.z + cell.y * grid.x + cell.x);
        vec4 group = nodes[node];
        vec4 content = nodes[node + 1u];
        if (!(content.w > 0.0)) continue;
        float distance = angleBetween(direction, group.xyz);
        if (level == 0u || group.w < block.opening * distance) {
            float k = 1.0 / max(distance * distance * distance, block.minCube);
            sum += k * content.xyz;
            weight += k * content.w;
            continue;
        }
        uvec2 fine = levels[level - 1u].xy;
        for (uint i = 4u; i-- > 0u;) {
            uvec2 child = 2u * cell + uvec2(i & 1u, i >> 1);
            if (child.x < fine.x && child.y < fine.y) stack[depth++] = pack(level - 1u, child.x, child.y);
        }
    }
    results[index] = vec4(sum / weight, 0.0);
}
