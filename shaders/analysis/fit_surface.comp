#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Normals by robust plane fits, positions and patch areas. Twin of core::analysis::computeSurface
// (core/analysis/depth/normals.h).
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/fit_surface_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { FitSurfaceBlock block; };
layout(set = 0, binding = FIT_SURFACE_DEPTH) readonly buffer Depth { float inverseDepths[]; };
layout(set = 0, binding = FIT_SURFACE_LABELS) readonly buffer Labels { uint labels[]; };
layout(set = 0, binding = FIT_SURFACE_TAPS) readonly buffer Taps { vec4 taps[]; };
layout(set = 0, binding = FIT_SURFACE_KNOWN) readonly buffer Known { float known[]; };
layout(set = 0, binding = FIT_SURFACE_RESULT) writeonly buffer Result { float results[]; };

// Inverse depth of a pixel of the segment, 0 if there is none.
float inverseDepthAt(ivec2 pixel, uint label) {
    ivec2 size = ivec2(block.width, block.height);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size))) return 0.0;
    int i = pixel.y * size.x + pixel.x;
    return ((labels[i >> 1] >> (16 * (i & 1))) & 0xffffu) == label ? inverseDepths[i] : 0.0;
}

// Slope along `step`: from the side where inverse depth continues more linearly where the sides disagree.
float guessSlope(ivec2 pixel, ivec2 step, uint label, float w) {
    float before2 = inverseDepthAt(pixel - 2 * step, label);
    float before = inverseDepthAt(pixel - step, label);
    float after = inverseDepthAt(pixel + step, label);
    float after2 = inverseDepthAt(pixel + 2 * step, label);
    if (before <= 0.0 && after <= 0.0) return 0.0;
    if (before <= 0.0) return after - w;
    if (after <= 0.0) return w - before;
    float tolerance = w * (2.0 * block.relativeNoise + 1.0e-7);
    float errorBefore = tolerance + abs(before2 > 0.0 ? w - 2.0 * before + before2 : w - before);
    float errorAfter = tolerance + abs(after2 > 0.0 ? w - 2.0 * after + after2 : w - after);
    if (errorBefore > kMaxSideRatio * errorAfter) return after - w;
    if (errorAfter > kMaxSideRatio * errorBefore) return w - before;
    return 0.5 * (after - before);
}

// sqrt(d + 1) - sqrt(d)
float rootStep(float d) { return 1.0 / (sqrt(d + 1.0) + sqrt(d)); }

// Slope at the last pixel before an occluding contour, from the steps to its first three neighbours inside; false when
// they do not end like a square root.
bool contourSlope(float first, float second, float third, out float slope) {
    float ratio = second / first;
    slope = 0.0;
    if (!(ratio > 0.0) || !(ratio < kMaxContourRatio)) return false;
    float low = kMinContourDistance;
    float high = kMaxContourDistance;
    for (int i = 0; i < kContourBisections; ++i) {
        float d = sqrt(low * high);
        if (rootStep(d + 1.0) < ratio * rootStep(d))
            low = d;
        else
            high = d;
    }
    if (abs(third - first * rootStep(low + 2.0) / rootStep(low)) > kContourTolerance * abs(first)) return false;
    slope = first * 0.5 * (1.0 + sqrt(1.0 + 1.0 / low));
    return true;
}

// Slope along `step` where the segment, or its visible part, ends beside the pixel; false elsewhere.
bool slopeAtContour(ivec2 pixel, ivec2 step, uint label, float w, out float slope) {
    for (int inside = -1; inside <= 1; inside += 2) {
        float outer = inverseDepthAt(pixel - inside * step, label);
        float one = inverseDepthAt(pixel + inside * step, label);
        float two = inverseDepthAt(pixel + 2 * inside * step, label);
        float three = inverseDepthAt(pixel + 3 * inside * step, label);
        if (one <= 0.0 || two <= 0.0 || three <= 0.0 || one <= w) continue;
        if (outer > 0.0 && abs(w - outer) < kContourJump * (one - w)) continue;
        if (contourSlope(one - w, two - one, three - two, slope)) {
            slope *= float(inside);
            return true;
        }
    }
    return false;
}

// Normal of the fitted plane towards +z, not normalised.
vec3 fitNormal(ivec2 pixel, uint label, float w) {
    float offset = 0.0;
    vec2 g = vec2(guessSlope(pixel, ivec2(1, 0), label, w), guessSlope(pixel, ivec2(0, 1), label, w));
    float difference[FIT_SURFACE_MAX_TAPS];
    int count = int(block.tapCount);
    for (int i = 0; i < count; ++i) {
        float value = inverseDepthAt(pixel + ivec2(taps[i].xy), label);
        difference[i] = value > 0.0 ? value - w : kNothing;
    }
    float inverseW = 1.0 / w;
    for (int iteration = 0; iteration < 2; ++iteration) {
        float s = 0.0, su = 0.0, sv = 0.0, suu = 0.0, suv = 0.0, svv = 0.0, sw = 0.0, suw = 0.0, svw = 0.0;
        for (int i = 0; i < count; ++i) {
            vec2 uv = taps[i].xy;
            float residual = (difference[i] - (offset + g.x * uv.x + g.y * uv.y)) * inverseW * taps[i].w;
            float t = max(1.0 - residual * residual, 0.0);
            float k = t * t * taps[i].z;
            vec2 kuv = k * uv;
            s += k;
            su += kuv.x;
            sv += kuv.y;
            suu += kuv.x * uv.x;
            suv += kuv.x * uv.y;
            svv += kuv.y * uv.y;
            sw += k * difference[i];
            suw += kuv.x * difference[i];
            svw += kuv.y * difference[i];
        }
        if (s <= 0.0) break;
        // About the mean; a thin line of pixels does not determine the slope across it, where the guess remains.
        float regularization = kSlopeStiffness * s;
        float cuu = suu - su * su / s + regularization;
        float cuv = suv - su * sv / s;
        float cvv = svv - sv * sv / s + regularization;
        float cuw = suw - su * sw / s + regularization * g.x;
        float cvw = svw - sv * sw / s + regularization * g.y;
        float determinant = cuu * cvv - cuv * cuv;
        if (!(determinant > 0.0)) break;
        g = vec2(cvv * cuw - cuv * cvw, cuu * cvw - cuv * cuw) / determinant;
        offset = clamp((sw - g.x * su - g.y * sv) / s, -0.5 * w, w);
    }
    if (block.relativeNoise <= 0.0) {
        float slope;
        if (slopeAtContour(pixel, ivec2(1, 0), label, w, slope)) {
            g.x = slope;
            offset = 0.0;
        }
        if (slopeAtContour(pixel, ivec2(0, 1), label, w, slope)) {
            g.y = slope;
            offset = 0.0;
        }
    }
    vec2 uv = vec2(pixel) + 0.5 - block.camera.zw;
    return vec3(g * block.camera.xy, w + offset - dot(g, uv));
}

void main() {
    uint index = listIndex();
    if (index >= sliceValue(block.count)) return;
    int i = int(block.first + index);
    ivec2 pixel = ivec2(i % int(block.width), i / int(block.width));
    float w = inverseDepths[i];
    vec3 normal = vec3(0.0);
    vec3 position = vec3(0.0);
    float area = 0.0;
    if (w > 0.0) {
        if (block.hasKnown != 0u) normal = vec3(known[3 * i], known[3 * i + 1], known[3 * i + 2]);
        if (normal == vec3(0.0)) {
            uint label = (labels[i >> 1] >> (16 * (i & 1))) & 0xffffu;
            normal = fitNormal(pixel, label, w);
            float squared = dot(normal, normal);
            if (squared > 0.0) normal *= block.sign / sqrt(squared);
        }
        float z = 1.0 / w;
        position = vec3((vec2(pixel) + 0.5 - block.camera.zw) / block.camera.xy * z, z);
        float cosine = max(abs(dot(normal, position)), kMinViewCosine * length(position));
        area = cosine > 0.0 ? z * z * z / (block.camera.x * block.camera.y * cosine) : 0.0;
    }
    uint at = 7u * index;
    results[at] = normal.x;
    results[at + 1u] = normal.y;
    results[at + 2u] = normal.z;
    results[at + 3u] = position.x;
    results[at + 4u] = position.y;
    results[at + 5u] = position.z;
    results[at + 6u] = area;
}
