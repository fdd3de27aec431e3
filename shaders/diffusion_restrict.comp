#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Restricts the light of a grid to the next coarser one by the two-scale relation of quadratic B-splines, [1 3 3 1]/4 in
// each direction, which is exact (core/shading/diffusion_grid.h). One workgroup per brick.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/diffusion_blocks.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DiffusionGridBlock block; };
layout(set = 0, binding = DIFFUSION_RESTRICT_BRICKS) readonly buffer Bricks { uint words[]; };
layout(set = 0, binding = DIFFUSION_RESTRICT_LIGHT) buffer Light { vec4 light[]; };

#include "shaders/lib/bricks.glsl"

shared vec4 fine[1000];  // 10x10x10: the eight children's cells and one around them

vec4 alongX(uint at) { return 0.25 * (fine[at] + fine[at + 3u]) + 0.75 * (fine[at + 1u] + fine[at + 2u]); }
vec4 alongXY(uint at) { return 0.25 * (alongX(at) + alongX(at + 30u)) + 0.75 * (alongX(at + 10u) + alongX(at + 20u)); }

void main() {
    uint index = listIndex();
    uint lane = index % DIFFUSION_BRICK_CELLS;
    uint item = index / DIFFUSION_BRICK_CELLS;
    uint brick = item < block.brickCount ? block.firstBrick + item : 0u;
    for (uint i = lane; i < 1000u; i += 64u) {
        ivec3 cell = ivec3(i % 10u, i / 10u % 10u, i / 100u) - 1;  // relative to the first child's first
        ivec3 child = cell >> 2;                                   // -1 to 2
        ivec3 n = (child >> 1) + 1;
        uint parent = brickWord(brick, DIFFUSION_BRICK_NEIGHBOURS + uint(n.x + 3 * n.y + 9 * n.z));
        ivec3 c = child & 1;
        uint source = brickWord(parent, DIFFUSION_BRICK_CHILDREN + uint(c.x + 2 * c.y + 4 * c.z));
        fine[i] = light[cellIn(source, cell)];
    }
    barrier();
    if (brick == 0u) return;
    uvec3 cell = uvec3(cellOfLane(lane));
    uint at = 2u * (cell.x + 10u * cell.y + 100u * cell.z);
    light[brick * DIFFUSION_BRICK_CELLS + lane] =
        0.25 * (alongXY(at) + alongXY(at + 300u)) + 0.75 * (alongXY(at + 100u) + alongXY(at + 200u));
}
