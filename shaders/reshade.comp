#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Monte Carlo re-shading of one edited segment (docs/method.md#re-shading): paths through its pixels, summed in the order
// of their numbers, so that the sums do not depend on the slices.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/geometry.glsl"
#include "shaders/shared/path.h"
#include "shaders/shared/reshade_block.h"
#include "shaders/shared/shading_point.h"

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

// Bilinear between the centres of pixels that show one surface.
vec3 normalAt(ivec2 pixel, vec4 patch_, vec2 offset) {
    vec3 own = texelFetch(frontNormalMap, pixel, 0).xyz;
    vec2 f = abs(offset);
    vec3 sum = own * ((1.0 - f.x) * (1.0 - f.y));
    for (int i = 1; i < 4; ++i) {
        ivec2 side = ivec2(i & 1, i >> 1);
        ivec2 q = pixel + ivec2(sign(offset)) * side;
        q = clamp(q, ivec2(0), ivec2(geometry.width, geometry.height) - 1);
        vec3 n = continued_normal(patch_, own, texelFetch(frontPatchMap, q, 0), texelFetch(frontNormalMap, q, 0).xyz,
                                  vec2(q - pixel));
        sum += n * ((side.x != 0 ? f.x : 1.0 - f.x) * (side.y != 0 ? f.y : 1.0 - f.y));
    }
    return sum;
}

// `offset` from the pixel's centre [px].
PathVertex cameraVertex(ivec2 pixel, vec2 offset) {
    vec4 patch_ = texelFetch(frontPatchMap, pixel, 0);
    vec3 p = backProject(vec2(pixel) + 0.5 + offset, 1.0 / (patch_.x + dot(patch_.yz, offset)));
    vec3 wo = normalize(-p);
    vec3 n = shading_normal(normalAt(pixel, patch_, offset), wo);
    return PathVertex(p, n, wo, uint(patch_.w), pixel, kPathPrimary, 1.0);
}

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    ivec2 pixel = unpackPixel(pixels[block.firstPixel + index]);
    vec4 sum = sliceValue(block.firstSample) == 0u ? vec4(0.0) : imageLoad(accumulationMap, pixel);
    uint sampleCount = sliceValue(block.sampleCount);
    uint id = uint(pixel.y) * geometry.width + uint(pixel.x);
    for (uint i = 0u; i < sampleCount; ++i) {
        PathVertex start = cameraVertex(pixel, rng_pixel(id, block.firstSample + i, block.seed) - 0.5);
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
