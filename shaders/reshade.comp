#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Monte Carlo re-shading of one edited segment (DESIGN 3.5): paths through its pixels, summed in the order of their
// numbers, so that the sums do not depend on how the work is sliced.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/geometry.glsl"
#include "shaders/shared/path.h"
#include "shaders/shared/reshade_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { ReshadeBlock block; };
layout(set = 1, binding = RESHADE_SHADING) readonly buffer Shading { SegmentShading shading[]; };
layout(set = 1, binding = RESHADE_DROPPED) buffer Dropped { uint dropped; };
layout(set = 1, binding = RESHADE_PIXELS) readonly buffer Pixels { uint pixels[]; };
layout(set = 1, binding = RESHADE_ACCUMULATION, rgba32f) uniform image2D accumulationMap;
layout(set = 1, binding = RESHADE_COUNT, r32f) uniform image2D countMap;
layout(set = 1, binding = RESHADE_DRIVES) readonly buffer Drives { Drive drives[]; };
layout(set = 1, binding = RESHADE_DRIVE_VALUES) readonly buffer DriveValues { float driveValues[]; };

#include "shaders/lib/path.glsl"
#include "shaders/lib/pixels.glsl"

PathVertex cameraVertex(ivec2 pixel) {
    vec3 p = frontPosition(pixel);
    vec3 wo = normalize(-p);
    vec3 n = shading_normal(texelFetch(frontNormalMap, pixel, 0).xyz, wo);
    return PathVertex(p, n, wo, uint(texelFetch(frontPatchMap, pixel, 0).w), pixel, kPathPrimary, 1.0);
}

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    ivec2 pixel = unpackPixel(pixels[block.firstPixel + index]);
    vec4 sum = sliceValue(block.firstSample) == 0u ? vec4(0.0) : imageLoad(accumulationMap, pixel);
    uint sampleCount = sliceValue(block.sampleCount);
    uint id = uint(pixel.y) * geometry.width + uint(pixel.x);
    PathVertex start = cameraVertex(pixel);
    for (uint i = 0u; i < sampleCount; ++i) {
        vec3 radiance = pathRadiance(start, PathId(id, block.firstSample + i, block.seed), sliceValue(block.bounces));
        if (path_valid(radiance)) {
            float l = luminance(radiance);
            sum += vec4(radiance, l * l);
        } else {
            atomicAdd(dropped, 1u);
        }
    }
    imageStore(accumulationMap, pixel, sum);
    imageStore(countMap, pixel, vec4(float(block.firstSample + block.sampleCount)));
}
