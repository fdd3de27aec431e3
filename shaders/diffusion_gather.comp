#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolates the sum over all surface samples from the grid to the pixels of a segment (core/shading/diffusion_grid.h),
// and limits it to what the surface receives.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/pixels.glsl"
#include "shaders/shared/diffusion_blocks.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DiffusionGatherBlock block; };
layout(set = 1, binding = DIFFUSION_GATHER_BRICKS) readonly buffer Bricks { uint words[]; };
layout(set = 1, binding = DIFFUSION_GATHER_PIXELS) readonly buffer Pixels { uvec2 pixels[]; };
layout(set = 1, binding = DIFFUSION_GATHER_SUM) readonly buffer Sum { vec4 sums[]; };
layout(set = 1, binding = DIFFUSION_GATHER_DIFFUSION, rgba32f) uniform writeonly image2D diffusionMap;

#include "shaders/lib/bricks.glsl"

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    uvec2 item = pixels[block.firstPixel + index];
    ivec2 pixel = unpackPixel(item.x);
    if (sliceValue(block.known) == 0u) {
        imageStore(diffusionMap, pixel, vec4(0.0));
        return;
    }
    uint brick = item.y;
    uint level = sliceValue(block.level);
    for (uint l = 0u; l < level; ++l) brick = brickWord(brick, DIFFUSION_BRICK_PARENT);
    vec3 place = (diffusion_axes(frontPosition(pixel)) - block.corner.xyz) / block.corner.w - vec3(4 * brickOrigin(brick));
    ivec3 cell = clamp(ivec3(floor(place)), ivec3(0), ivec3(3));
    vec3 t = place - vec3(cell) - 0.5;
    vec3 weights[3] = vec3[3](0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t));
    vec3 sum = vec3(0.0);
    vec3 whole = vec3(0.0);  // the sum if all samples had an irradiance of 1
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 3; ++y) {
            float weight = weights[z].z * weights[y].y;
            for (int x = 0; x < 3; ++x) {
                uint from = 2u * cellAround(brick, cell + ivec3(x, y, z) - 1);
                sum += (weight * weights[x].x) * sums[from].rgb;
                whole += (weight * weights[x].x) * sums[from + 1u].rgb;
            }
        }
    vec3 exitance;
    for (int c = 0; c < 3; ++c)
        exitance[c] = diffusion_exitance(sum[c], whole[c], block.flatSurface[c], block.tolerance[c]);
    imageStore(diffusionMap, pixel, vec4(exitance, 1.0));
}
