#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths the cells of one grid or several with [1 4 1]/6 twice, which is [1 8 18 8 1]/36, in each direction
// (core/shading/diffusion_grid.h). One workgroup per brick.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/diffusion_blocks.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DiffusionGridBlock block; };
layout(set = 0, binding = DIFFUSION_SMOOTH_BRICKS) readonly buffer Bricks { uint words[]; };
layout(set = 0, binding = DIFFUSION_SMOOTH_FROM) readonly buffer From { vec4 from[]; };
layout(set = 0, binding = DIFFUSION_SMOOTH_TO) writeonly buffer To { vec4 to[]; };

#include "shaders/lib/bricks.glsl"

shared vec4 around[512];   // 8x8x8: the brick and two cells around it
shared vec4 alongX[256];   // 4x8x8
shared vec4 alongXY[128];  // 4x4x8

void main() {
    uint index = listIndex();
    uint lane = index % DIFFUSION_BRICK_CELLS;
    uint item = index / DIFFUSION_BRICK_CELLS;
    uint brick = item < block.brickCount ? block.firstBrick + item : 0u;
    for (uint i = lane; i < 512u; i += 64u)
        around[i] = from[cellAround(brick, ivec3(i & 7u, (i >> 3) & 7u, i >> 6) - 2)];
    barrier();
    for (uint i = lane; i < 256u; i += 64u) {
        uint at = (i & 3u) + 8u * (i >> 2);
        alongX[i] = around[at] + around[at + 4u] + 8.0 * (around[at + 1u] + around[at + 3u]) + 18.0 * around[at + 2u];
    }
    barrier();
    for (uint i = lane; i < 128u; i += 64u) {
        uint at = (i & 15u) + 32u * (i >> 4);
        alongXY[i] = alongX[at] + alongX[at + 16u] + 8.0 * (alongX[at + 4u] + alongX[at + 12u]) + 18.0 * alongX[at + 8u];
    }
    barrier();
    if (brick == 0u) return;
    vec4 sum = alongXY[lane] + alongXY[lane + 64u] + 8.0 * (alongXY[lane + 16u] + alongXY[lane + 48u]) +
               18.0 * alongXY[lane + 32u];
    to[brick * DIFFUSION_BRICK_CELLS + lane] = sum / 46656.0;
}
