#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Blend of the new radiance and the photograph in one edited segment (docs/method.md#re-shading), translucent light added.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/pixels.glsl"
#include "shaders/shared/composite_block.h"
#include "shaders/brdf/fresnel.h"
#include "shaders/shared/drive.h"
#include "shaders/shared/sampling.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { CompositeBlock block; };
layout(set = 1, binding = COMPOSITE_PIXELS) readonly buffer Pixels { uint pixels[]; };
layout(set = 1, binding = COMPOSITE_ACCUMULATION) uniform texture2D accumulationMap;
layout(set = 1, binding = COMPOSITE_COUNT) uniform texture2D countMap;
layout(set = 1, binding = COMPOSITE_FILTERED) uniform texture2D filteredMap;
layout(set = 1, binding = COMPOSITE_DIFFUSION) uniform texture2D diffusionMap;
layout(set = 1, binding = COMPOSITE_RESULT, rgba32f) uniform writeonly image2D resultMap;
layout(set = 1, binding = COMPOSITE_DRIVES) readonly buffer Drives { Drive drives[]; };
layout(set = 1, binding = COMPOSITE_DRIVE_VALUES) readonly buffer DriveValues { float driveValues[]; };

#include "shaders/lib/drives.glsl"

// A weight of the block in this pixel.
float weightAt(float weight, uint slot, ivec2 pixel) {
    return drivenWeight(weight, slot, block.firstDrive, block.driveCount, pixel);
}

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    ivec2 pixel = unpackPixel(pixels[block.firstPixel + index]);
    vec3 photo = texelFetch(frontColorMap, pixel, 0).rgb;
    vec3 fresh = block.filtered != 0u ? texelFetch(filteredMap, pixel, 0).rgb
                                      : texelFetch(accumulationMap, pixel, 0).rgb / texelFetch(countMap, pixel, 0).x;
    if (block.translucent != 0u) {
        vec3 diffusion = texelFetch(diffusionMap, pixel, 0).rgb;
        vec3 wo = normalize(-frontPosition(pixel));
        vec3 n = shading_normal(texelFetch(frontNormalMap, pixel, 0).xyz, wo);
        float transmission = fresnel_transmission(sliceValue(block.eta), max(dot(n, wo), 0.0));
        fresh += weightAt(block.translucentWeight, kDriveTranslucentWeight, pixel) * transmission * kInvPi * diffusion;
    }
    vec3 result = weightAt(block.blendNew, kDriveBlendNew, pixel) * fresh +
                  weightAt(block.blendOriginal, kDriveBlendOriginal, pixel) * photo;
    imageStore(resultMap, pixel, vec4(result, 1.0));
}
