#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// The light of surface samples, and their area, into the cells of the finest grid (core/shading/diffusion_grid.h). One workgroup per brick.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/diffusion_blocks.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DiffusionGridBlock block; };
layout(set = 0, binding = DIFFUSION_SPLAT_BRICKS) readonly buffer Bricks { uint words[]; };
layout(set = 0, binding = DIFFUSION_SPLAT_STARTS) readonly buffer Starts { uint starts[]; };
layout(set = 0, binding = DIFFUSION_SPLAT_ENTRIES) readonly buffer Entries { uint entries[]; };
layout(set = 0, binding = DIFFUSION_SPLAT_PLACES) readonly buffer Places { vec4 places[]; };
layout(set = 0, binding = DIFFUSION_SPLAT_SUMS) readonly buffer Sums { vec4 sums[]; };
layout(set = 0, binding = DIFFUSION_SPLAT_LIGHT) writeonly buffer Light { vec4 light[]; };

#include "shaders/lib/bricks.glsl"

void main() {
    uint index = listIndex();
    if (index >= block.brickCount * DIFFUSION_BRICK_CELLS) return;
    uint brick = block.firstBrick + index / DIFFUSION_BRICK_CELLS;
    ivec3 cell = cellOfLane(index % DIFFUSION_BRICK_CELLS);
    vec3 center = vec3(4 * brickOrigin(brick) + cell) + 0.5;
    uint end = starts[brick - block.levelFirst + 1u];
    vec4 sum = vec4(0.0);
    for (uint entry = starts[brick - block.levelFirst]; entry < end; ++entry) {
        uint i = entries[entry];
        vec4 place = places[i];
        vec3 t = place.xyz - center;
        float weight = diffusion_spline(t.x) * diffusion_spline(t.y) * diffusion_spline(t.z);
        sum += (weight * place.w) * vec4(sums[i].rgb, 1.0);
    }
    light[cellIn(brick, cell)] = vec4(sliceValue(block.scale) * sum.rgb, sum.a);
}
