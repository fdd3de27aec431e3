#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Edge-aware filter of the re-shaded radiance, twin of core/shading/image_filter.h, which states the weights.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/pixels.glsl"
#include "shaders/shared/filter_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { FilterBlock block; };
layout(set = 1, binding = FILTER_PIXELS) readonly buffer Pixels { uint pixels[]; };
layout(set = 1, binding = FILTER_ACCUMULATION) uniform texture2D accumulationMap;
layout(set = 1, binding = FILTER_COUNT) uniform texture2D countMap;
layout(set = 1, binding = FILTER_SOURCE) uniform texture2D sourceMap;
layout(set = 1, binding = FILTER_TARGET, rgba32f) uniform writeonly image2D targetMap;

const float kEpsilon = 1.0e-6;
const float kSpline[3] = float[3](6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0);  // by distance from the centre

bool together(vec4 patchHere, ivec2 pixel, out vec4 patchThere) {
    patchThere = vec4(0.0);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(geometry.width, geometry.height)))) return false;
    patchThere = texelFetch(frontPatchMap, pixel, 0);
    return patchThere.x > 0.0 && patchThere.w == patchHere.w;
}

vec3 meanRadiance(ivec2 pixel) {
    return texelFetch(accumulationMap, pixel, 0).rgb / max(texelFetch(countMap, pixel, 0).x, 1.0);
}

vec4 start(ivec2 pixel, vec4 patchHere) {
    vec3 color = meanRadiance(pixel);
    float n = texelFetch(countMap, pixel, 0).x;
    float variance;
    if (n >= float(block.temporalSamples)) {
        float mean = luminance(color);
        variance = (texelFetch(accumulationMap, pixel, 0).w / n - mean * mean) / (n - 1.0);
    } else {
        float sum = 0.0;
        float squared = 0.0;
        float count = 0.0;
        for (int dy = -3; dy <= 3; ++dy)
            for (int dx = -3; dx <= 3; ++dx) {
                vec4 patchThere;
                if (!together(patchHere, pixel + ivec2(dx, dy), patchThere)) continue;
                float l = luminance(meanRadiance(pixel + ivec2(dx, dy)));
                sum += l;
                squared += l * l;
                count += 1.0;
            }
        variance = squared / count - (sum / count) * (sum / count);
    }
    return vec4(color, max(variance, 0.0));
}

float smoothVariance(ivec2 pixel, vec4 patchHere) {
    float sum = 0.0;
    float weights = 0.0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            vec4 patchThere;
            if (!together(patchHere, pixel + ivec2(dx, dy), patchThere)) continue;
            float w = float((2 - abs(dx)) * (2 - abs(dy)));
            sum += w * texelFetch(sourceMap, pixel + ivec2(dx, dy), 0).w;
            weights += w;
        }
    return sum / weights;
}

vec4 filtered(ivec2 pixel, vec4 patchHere) {
    int stride = 1 << block.level;
    float z = 1.0 / patchHere.x;
    vec3 position = backProject(vec2(pixel) + 0.5, z);
    vec3 normal = texelFetch(frontNormalMap, pixel, 0).xyz;
    float luminanceHere = luminance(texelFetch(sourceMap, pixel, 0).rgb);
    float luminanceScale = 1.0 / (block.luminanceSigma * sqrt(smoothVariance(pixel, patchHere)) + kEpsilon);
    float depthScale = 1.0 / (block.depthSigma * (z / geometry.camera.x) * float(stride));
    vec3 color = vec3(0.0);
    float weights = 0.0;
    float variance = 0.0;
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
            ivec2 q = pixel + stride * ivec2(dx, dy);
            vec4 patchThere;
            if (!together(patchHere, q, patchThere)) continue;
            vec4 source = texelFetch(sourceMap, q, 0);
            float w = kSpline[abs(dx)] * kSpline[abs(dy)];
            if (dx != 0 || dy != 0) {
                float cosine = max(dot(normal, texelFetch(frontNormalMap, q, 0).xyz), 0.0);
                float plane = abs(dot(normal, backProject(vec2(q) + 0.5, 1.0 / patchThere.x) - position));
                float distance = float(max(abs(dx), abs(dy)));
                w *= pow(cosine, block.normalPower) *
                     exp(-plane * depthScale / distance - abs(luminance(source.rgb) - luminanceHere) * luminanceScale);
            }
            color += w * source.rgb;
            weights += w;
            variance += w * w * source.w;
        }
    return vec4(color / weights, variance / (weights * weights));
}

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    ivec2 pixel = unpackPixel(pixels[block.firstPixel + index]);
    vec4 patchHere = texelFetch(frontPatchMap, pixel, 0);
    imageStore(targetMap, pixel, block.level < 0 ? start(pixel, patchHere) : filtered(pixel, patchHere));
}
