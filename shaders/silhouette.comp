#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the partly covered pixels at an edited segment's outline (core/shading/silhouette.h), after its composite.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/pixels.glsl"
#include "shaders/shared/drive.h"
#include "shaders/shared/silhouette_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { SilhouetteBlock block; };
layout(set = 1, binding = SILHOUETTE_PIXELS) readonly buffer Pixels { MixedPixel pixels[]; };
layout(set = 1, binding = SILHOUETTE_RESULT, rgba32f) uniform image2D resultMap;
layout(set = 1, binding = SILHOUETTE_DRIVES) readonly buffer Drives { Drive drives[]; };
layout(set = 1, binding = SILHOUETTE_DRIVE_VALUES) readonly buffer DriveValues { float driveValues[]; };

#include "shaders/lib/drives.glsl"

void main() {
    uint index = listIndex();
    if (index >= block.pixelCount) return;
    ivec2 source = unpackPixel(pixels[index].source);
    float original = drivenWeight(block.blendOriginal, kDriveBlendOriginal, block.firstDrive, block.driveCount, source);
    vec3 kept = pixels[index].kept.rgb + original * pixels[index].keptOriginal.rgb;
    vec3 shown = imageLoad(resultMap, source).rgb;
    imageStore(resultMap, unpackPixel(pixels[index].pixel), vec4(pixels[index].coverage * shown + kept, 1.0));
}
