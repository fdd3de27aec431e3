#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// One pass of the edge-avoiding depth filter, twin of core::analysis::runFilterPass; core/analysis/depth/filter_depth.h
// explains the weights.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/depth_filter_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { DepthFilterBlock block; };
layout(set = 0, binding = DEPTH_FILTER_DEPTH) readonly buffer Depth { float inverseDepths[]; };
layout(set = 0, binding = DEPTH_FILTER_COLOR) readonly buffer Color { uint colors[]; };
layout(set = 0, binding = DEPTH_FILTER_LABELS) readonly buffer Labels { uint labels[]; };
layout(set = 0, binding = DEPTH_FILTER_PARAMETERS) readonly buffer Parameters { vec4 parameters[]; };
layout(set = 0, binding = DEPTH_FILTER_RESULT) writeonly buffer Result { float results[]; };

uint labelAt(int i) { return (labels[i >> 1] >> (16 * (i & 1))) & 0xffffu; }

float deviationAt(float w) {
    float cell = clamp((w - block.curveFirst) * block.cellsPerUnit, 0.0, float(DEPTH_FILTER_CELLS - 1));
    int i = min(int(cell), DEPTH_FILTER_CELLS - 2);
    float t = cell - float(i);
    float low = parameters[DEPTH_FILTER_PAIRS + (i >> 2)][i & 3];
    float high = parameters[DEPTH_FILTER_PAIRS + ((i + 1) >> 2)][(i + 1) & 3];
    return (1.0 - t) * low + t * high;
}

// Squared distance of two colours, [0, 3].
float squaredDistance(uint a, uint b) {
    ivec3 difference = ivec3((uvec3(a) >> uvec3(0, 8, 16)) & 255u) - ivec3((uvec3(b) >> uvec3(0, 8, 16)) & 255u);
    difference *= difference;
    return float(difference.x + difference.y + difference.z) * (1.0 / (255.0 * 255.0));
}

float filtered(int here) {
    float w = inverseDepths[here];
    float limit = deviationAt(w);
    if (w <= 0.0 || limit <= 0.0) return w;
    float factor = 1.0 / (limit * limit);
    uint label = labelAt(here);
    uint center = colors[here];
    ivec2 size = ivec2(block.width, block.height);
    ivec2 pixel = ivec2(here % size.x, here / size.x);
    float sum = 0.0;
    float weight = 1.0;
    for (int i = 0; i < DEPTH_FILTER_PAIRS; ++i) {
        ivec2 offset = ivec2(parameters[i].xy);
        ivec2 a = pixel + offset;
        ivec2 b = pixel - offset;
        if (any(lessThan(min(a, b), ivec2(0))) || any(greaterThanEqual(max(a, b), size))) continue;
        int ia = a.y * size.x + a.x;
        int ib = b.y * size.x + b.x;
        float wa = inverseDepths[ia];
        float wb = inverseDepths[ib];
        float residual = 0.5 * (wa + wb) - w;
        float squared = residual * residual * factor;
        if (squared >= kMaxSquaredResidual || wa <= 0.0 || wb <= 0.0 || labelAt(ia) != label || labelAt(ib) != label) continue;
        float similar =
            max(1.0 - (squaredDistance(colors[ia], center) + squaredDistance(colors[ib], center)) * block.colorFactor, 0.0);
        float k = parameters[i].z * similar * similar / ((1.0 + squared) * (1.0 + squared));
        sum += k * residual;
        weight += k;
    }
    return w + sum / weight;
}

void main() {
    uint index = listIndex();
    if (index >= sliceValue(block.count)) return;
    results[index] = filtered(int(block.first + index));
}
