#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Samples BRDFs, and integrates them over cells of the hemisphere (render/kernels/brdf_check.h).
#extension GL_GOOGLE_include_directive : require
#include "shaders/brdf/brdf.h"
#include "shaders/lib/list.glsl"
#include "shaders/shared/check_brdf_block.h"
#include "shaders/shared/rng.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { CheckBrdfBlock block; };
layout(set = 0, binding = CHECK_BRDF_CASES) readonly buffer Cases { CheckBrdfCase cases[]; };
layout(set = 0, binding = CHECK_BRDF_CELLS) readonly buffer Cells { vec4 cells[]; };
layout(set = 0, binding = CHECK_BRDF_SAMPLES) writeonly buffer Samples { CheckBrdfSample samples[]; };
layout(set = 0, binding = CHECK_BRDF_SUMS) writeonly buffer Sums { CheckBrdfSums sums[]; };

#ifndef PATINA_USER_BRDFS
uint userFaults = 0u;
#endif

bool finite(float v) { return v > -3.0e38 && v < 3.0e38; }

uint faultsOf(vec3 f) {
    if (!finite(f.x) || !finite(f.y) || !finite(f.z)) return kCheckValue;
    return min(f.x, min(f.y, f.z)) < 0.0 ? kCheckNegative : 0u;
}

void drawSample(uint index) {
    uint perCase = sliceValue(block.perCase);
    uint s = index % perCase;
    CheckBrdfCase c = cases[index / perCase];
    vec2 u = rng_vec2(index / perCase, s, 0u, 77u);
    if (s < kCheckBrdfCorners) u = min(vec2(s & 3u, s >> 2) / 3.0, vec2(0.99999994));
    userFaults = 0u;
    vec3 wi = brdf_sample(c.brdf, c.wo.xyz, u);
    vec3 weight = vec3(0.0);
    uint faults = userFaults;
    if (wi.z > 0.0) {
        weight = brdf_weight(c.brdf, c.wo.xyz, wi);
        faults |= userFaults | faultsOf(brdf_eval(c.brdf, c.wo.xyz, wi));
        float pdf = brdf_pdf(c.brdf, c.wo.xyz, wi);
        if (!(pdf >= 0.0) || !finite(pdf)) faults |= kCheckPdf;
    }
    samples[index] = CheckBrdfSample(vec4(wi, float(faults)), vec4(weight, 0.0));
}

struct Point {
    vec4 value;  // f cos, pdf
    float asymmetry;
    uint faults;
};

Point evaluate(CheckBrdfCase c, vec3 wi) {
    userFaults = 0u;
    vec3 f = brdf_eval(c.brdf, c.wo.xyz, wi);
    float pdf = brdf_pdf(c.brdf, c.wo.xyz, wi);
    uint faults = userFaults | faultsOf(f);
    if (!(pdf >= 0.0) || !finite(pdf)) faults |= kCheckPdf;
    vec3 difference = abs(f - brdf_eval(c.brdf, wi, c.wo.xyz));
    return Point(vec4(f * wi.z, pdf), max(difference.x, max(difference.y, difference.z)) * wi.z, faults);
}

vec3 onSphere(float z, float phi) {
    float r = sqrt(max(1.0 - z * z, 0.0));
    return vec3(r * cos(phi), r * sin(phi), z);
}

void integrate(uint index) {
    uint perCase = sliceValue(block.perCase);
    CheckBrdfCase c = cases[index / perCase];
    uint cell = index % perCase;
    vec4 box = cells[index];
    vec4 value = vec4(0.0);
    vec4 square = vec4(0.0);
    vec4 fault = vec4(0.0);
    float asymmetry = 0.0;
    uint side = sliceValue(block.side);
    uint count = side * side;
    // Where things tend to go wrong, once per case.
    uint corners = cell == 0u ? 4u : 0u;
    for (uint i = 0u; i < count + corners; ++i) {
        vec2 u = rng_vec2(index, i, 0u, 78u);
        vec2 at = (vec2(i % side, i / side) + u) / float(side);
        vec3 wi = onSphere(max(mix(box.x, box.y, at.x), 1e-6), mix(box.z, box.w, at.y));
        if (i == count) wi = c.wo.xyz;
        if (i == count + 1u) wi = vec3(-c.wo.xy, c.wo.z);
        if (i == count + 2u) wi = vec3(0.0, 0.0, 1.0);
        if (i == count + 3u) wi = onSphere(1e-4, 2.0);
        Point p = evaluate(c, wi);
        if (p.faults != 0u && fault.w == 0.0) fault = vec4(wi, float(p.faults));
        if (i >= count) continue;
        value += p.value;
        square += p.value * p.value;
        asymmetry += p.asymmetry;
    }
    float n = float(count);
    sums[index] = CheckBrdfSums(value / n, square / n, fault, vec4(asymmetry / n, 0.0, 0.0, 0.0));
}

void main() {
    uint index = listIndex();
    if (index >= sliceValue(block.count)) return;
    index += block.first;
    if (sliceValue(block.mode) == CHECK_BRDF_SAMPLE)
        drawSample(index);
    else
        integrate(index);
}
