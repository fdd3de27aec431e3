#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Min/max pyramid over the solids of the two-layer depth image: the finest level holds the range of inverse depth of
// each pixel (or, in huge pictures, of each block of pixels), every other one those of the 2x2 cells below it. Any image
// size; the cells at the right and lower border cover fewer.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/build_pyramid_block.h"
#include "shaders/shared/geometry_block.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Block { BuildPyramidBlock block; };
layout(set = 0, binding = BUILD_PYRAMID_FRONT_PATCH) uniform texture2D frontPatchMap;
layout(set = 0, binding = BUILD_PYRAMID_BACK_PATCH) uniform texture2D backPatchMap;
layout(set = 0, binding = BUILD_PYRAMID_RANGES, r32ui) uniform uimage2D rangeMap;

ivec2 texelOf(uvec2 cell, uint step_) {
    return ivec2(pyramidTexel(pyramidIndex(cell.x, cell.y, step_, block.rows, block.blocks)));
}

void main() {
    uvec2 cell = gl_GlobalInvocationID.xy;
    if (cell.x >= block.width || cell.y >= block.height) return;
    uint step_ = sliceValue(block.step);
    uint side = step_ == 0u ? 1u << sliceValue(block.finest) : 2u;
    uint range = kEmptyCell;
    for (uint i = 0u; i < side * side; ++i) {
        uvec2 child = side * cell + uvec2(i & (side - 1u), i / side);
        if (child.x >= block.sourceWidth || child.y >= block.sourceHeight) continue;
        uint part;
        if (step_ == 0u) {
            vec4 frontPatch = texelFetch(frontPatchMap, ivec2(child), 0);
            part = packRange(pixelRange(frontPatch, texelFetch(backPatchMap, ivec2(child), 0)), block.minW, block.scale);
        } else {
            part = imageLoad(rangeMap, texelOf(child, step_ - 1u)).x;
        }
        range = joinRanges(range, part);
    }
    imageStore(rangeMap, texelOf(cell, block.step), uvec4(range));
}
