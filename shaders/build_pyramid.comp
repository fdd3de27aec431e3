#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Min/max pyramid over the solids of the two-layer depth image: each cell holds the least and the greatest inverse
// depth of the 2x2 cells below it. Any image size; the cells at the right and lower border cover fewer.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/shared/build_pyramid_block.h"
#include "shaders/shared/geometry_block.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Block { BuildPyramidBlock block; };
layout(set = 0, binding = BUILD_PYRAMID_FRONT_PATCH) uniform texture2D frontPatchMap;
layout(set = 0, binding = BUILD_PYRAMID_BACK_PATCH) uniform texture2D backPatchMap;
layout(set = 0, binding = BUILD_PYRAMID_RANGES) buffer Ranges { vec2 ranges[]; };

void main() {
    uvec2 cell = gl_GlobalInvocationID.xy;
    if (cell.x >= block.width || cell.y >= block.height) return;
    vec2 range = vec2(kEmptyRangeMin, kEmptyRangeMax);
    for (uint i = 0u; i < 4u; ++i) {
        uvec2 child = 2u * cell + uvec2(i & 1u, i >> 1);
        if (child.x >= block.sourceWidth || child.y >= block.sourceHeight) continue;
        vec2 part = block.level == 1u ? pixelRange(texelFetch(frontPatchMap, ivec2(child), 0),
                                                   texelFetch(backPatchMap, ivec2(child), 0))
                                      : ranges[block.sourceOffset + child.y * block.sourceWidth + child.x];
        range = vec2(min(range.x, part.x), max(range.y, part.y));
    }
    ranges[block.offset + cell.y * block.width + cell.x] = range;
}
