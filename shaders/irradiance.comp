#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Light that enters a translucent body at its surface samples (docs/method.md#translucency): paths weighted by cosine and
// Fresnel transmission, summed in order.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/geometry.glsl"
#include "shaders/shared/irradiance_block.h"
#include "shaders/shared/path.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { IrradianceBlock block; };
layout(set = 1, binding = IRRADIANCE_SHADING) readonly buffer Shading { SegmentShading shading[]; };
layout(set = 1, binding = IRRADIANCE_DROPPED) buffer Dropped { uint dropped; };
layout(set = 1, binding = IRRADIANCE_POINTS) readonly buffer Points { SurfacePoint points[]; };
layout(set = 1, binding = IRRADIANCE_SUMS) buffer Sums { vec4 sums[]; };
layout(set = 1, binding = IRRADIANCE_DRIVES) readonly buffer Drives { Drive drives[]; };
layout(set = 1, binding = IRRADIANCE_DRIVE_VALUES) readonly buffer DriveValues { float driveValues[]; };

#include "shaders/lib/path.glsl"
#include "shaders/lib/pixels.glsl"

void main() {
    uint index = listIndex();
    if (index >= block.pointCount) return;
    index += block.firstPoint;
    vec3 n = points[index].normal.xyz;
    PathVertex start = PathVertex(points[index].position.xyz, n, n, block.label, ivec2(0), kPathEnter,
                                  sliceValue(block.eta));
    uint id = uint(points[index].position.w);
    vec3 sum = sliceValue(block.firstRay) == 0u ? vec3(0.0) : sums[index].rgb;
    uint rayCount = sliceValue(block.rayCount);
    for (uint i = 0u; i < rayCount; ++i) {
        vec3 radiance = pathRadiance(start, PathId(id, block.firstRay + i, block.seed), sliceValue(block.bounces));
        if (path_valid(radiance)) sum += radiance;
        else atomicAdd(dropped, 1u);
    }
    sums[index] = vec4(sum, 0.0);
}
