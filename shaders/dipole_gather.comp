#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Dipole diffusion by brute force (DESIGN 3.6): the light of some surface samples on some pixels of the segment. Slices
// over the samples follow each other in order, so that the sums do not depend on how the work is sliced.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/pixels.glsl"
#include "shaders/shared/dipole.h"
#include "shaders/shared/dipole_gather_block.h"
#include "shaders/shared/irradiance_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DipoleGatherBlock block; };
layout(set = 1, binding = DIPOLE_GATHER_PARAMS) uniform Params { DipoleParams params; };
layout(set = 1, binding = DIPOLE_GATHER_PIXELS) readonly buffer Pixels { uint pixels[]; };
layout(set = 1, binding = DIPOLE_GATHER_POINTS) readonly buffer Points { SurfacePoint points[]; };
layout(set = 1, binding = DIPOLE_GATHER_SUMS) readonly buffer Sums { vec4 sums[]; };
layout(set = 1, binding = DIPOLE_GATHER_DIFFUSION, rgba32f) uniform image2D diffusionMap;

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    ivec2 pixel = unpackPixel(pixels[block.firstPixel + index]);
    vec3 p = frontPosition(pixel);
    vec3 sum = sliceValue(block.firstPoint) == 0u ? vec3(0.0) : imageLoad(diffusionMap, pixel).rgb;
    uint pointCount = sliceValue(block.pointCount);
    for (uint i = 0u; i < pointCount; ++i) {
        vec3 toPoint = points[block.firstPoint + i].position.xyz - p;
        sum += dipole_rd(params, dot(toPoint, toPoint)) * (block.sumScale * sums[block.firstPoint + i].rgb);
    }
    imageStore(diffusionMap, pixel, vec4(sum, float(block.firstPoint + block.pointCount)));
}
