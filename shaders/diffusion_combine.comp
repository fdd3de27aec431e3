#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a level's part of the sum over all surface samples to that of the next coarser level, which the two-scale relation
// of quadratic B-splines interpolates exactly (core/shading/diffusion_grid.h). Sums light, and area as if every sample
// had an irradiance of 1.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/diffusion_blocks.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DiffusionCombineBlock block; };
layout(set = 0, binding = DIFFUSION_COMBINE_BRICKS) readonly buffer Bricks { uint words[]; };
layout(set = 0, binding = DIFFUSION_COMBINE_NARROW) readonly buffer Narrow { vec4 narrow[]; };
layout(set = 0, binding = DIFFUSION_COMBINE_WIDE) readonly buffer Wide { vec4 wide[]; };
layout(set = 0, binding = DIFFUSION_COMBINE_SUM) buffer Sum { vec4 sums[]; };

#include "shaders/lib/bricks.glsl"

void main() {
    uint index = listIndex();
    if (index >= block.brickCount * DIFFUSION_BRICK_CELLS) return;
    uint brick = block.firstBrick + index / DIFFUSION_BRICK_CELLS;
    ivec3 cell = cellOfLane(index % DIFFUSION_BRICK_CELLS);
    uint parent = brickWord(brick, DIFFUSION_BRICK_PARENT);
    ivec3 near = 2 * (brickOrigin(brick) & 1) + (cell >> 1);  // the coarse cell this one is in, relative to the parent
    ivec3 side = 2 * (cell & 1) - 1;                          // to the coarse cell next to it
    vec3 coarse = vec3(0.0);
    vec3 coarseArea = vec3(0.0);
    for (int tap = 0; tap < 8; ++tap) {
        ivec3 far = ivec3(tap & 1, (tap >> 1) & 1, tap >> 2);
        vec3 weight = mix(vec3(0.75), vec3(0.25), vec3(far));
        float product = weight.x * weight.y * weight.z;
        uint from = 2u * cellAround(parent, near + far * side);
        coarse += product * sums[from].rgb;
        coarseArea += product * sums[from + 1u].rgb;
    }
    uint i = cellIn(brick, cell);
    vec4 n = narrow[i];
    vec4 w = wide[i];
    float coarser = sliceValue(block.coarser);
    sums[2u * i] = vec4(block.narrow.rgb * n.rgb + block.wide.rgb * w.rgb + coarser * coarse, 0.0);
    sums[2u * i + 1u] = vec4(block.narrow.rgb * n.a + block.wide.rgb * w.a + coarser * coarseArea, 0.0);
}
