// SPDX-License-Identifier: GPL-3.0-or-later
// Measured isotropic BRDFs in the half-angle and difference-angle coordinates of [Rus98], as in MERL's files [MPBM03]:
// 90 half angles (spaced by the square), 90 difference angles and 180 azimuths of the difference, linear between the
// first two, nearest in the third. Sampling: with a tabulated probability a cosine lobe, otherwise a half vector whose elevation
// follows a table made for the elevation of `wo` (core/material/measured_brdf.cpp), mirrored at it.
#ifndef PATINA_BRDF_MEASURED_H
#define PATINA_BRDF_MEASURED_H

#include "shaders/shared/brdf_params.h"
#include "shaders/shared/sampling.h"

#define MEASURED_TABLES 15  // binding of the tables, in the group of the kernel's own inputs

KERNEL_BEGIN

const uint kMeasuredThetaH = 90u;
const uint kMeasuredThetaD = 90u;
const uint kMeasuredPhiD = 180u;
/// Elevations of `wo`, each with: the chance of the cosine lobe, then the cumulative chances of the half angles.
const uint kMeasuredRows = 45u;
const uint kMeasuredRowSize = 92u;
const uint kMeasuredValues = 4140u;  // first of the values, three (r, g, b) for each (theta_h, theta_d, phi_d)
const uint kMeasuredSize = 4378140u;

#ifdef __cplusplus
static_assert(kMeasuredValues == kMeasuredRows * kMeasuredRowSize && kMeasuredRowSize == kMeasuredThetaH + 2);
static_assert(kMeasuredSize == kMeasuredValues + 3 * kMeasuredThetaH * kMeasuredThetaD * kMeasuredPhiD);
KERNEL_FN float measured_number(BrdfParams b, uint i) { return b.measured[i]; }
#else
layout(set = 1, binding = MEASURED_TABLES) readonly buffer MeasuredTables { float measuredTables[]; };
float measured_number(BrdfParams b, uint i) { return measuredTables[b.file + i]; }
#endif

KERNEL_FN vec3 measured_entry(BrdfParams b, uint thetaH, uint thetaD, uint phiD) {
    uint i = kMeasuredValues + 3u * ((thetaH * kMeasuredThetaD + thetaD) * kMeasuredPhiD + phiD);
    return vec3(measured_number(b, i), measured_number(b, i + 1u), measured_number(b, i + 2u));
}

/// Position of a half angle [rad] along the table: bin i holds [i, i + 1).
KERNEL_FN float measured_theta_h_position(float thetaH) {
    return sqrt(max(thetaH, 0.0f) * (2.0f * kInvPi)) * float(kMeasuredThetaH);
}

KERNEL_FN vec3 measured_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 h = normalize(wo + wi);
    float sinH = sqrt(h.x * h.x + h.y * h.y);
    float thetaH = atan(sinH, h.z);
    float c = 1.0f;
    float s = 0.0f;
    if (sinH > 1e-7f) {
        c = h.x / sinH;
        s = h.y / sinH;
    }
    // wi in the frame whose pole is h.
    float x = wi.x * c + wi.y * s;
    vec3 d = vec3(x * h.z - wi.z * sinH, wi.y * c - wi.x * s, x * sinH + wi.z * h.z);
    float thetaD = atan(sqrt(d.x * d.x + d.y * d.y), d.z);
    float phiD = atan(d.y, d.x);
    if (phiD < 0.0f) phiD += kPi;

    float u = clamp(measured_theta_h_position(thetaH) - 0.5f, 0.0f, float(kMeasuredThetaH - 1u));
    float v = clamp(thetaD * (2.0f * kInvPi) * float(kMeasuredThetaD) - 0.5f, 0.0f, float(kMeasuredThetaD - 1u));
    uint u0 = uint(u);
    uint v0 = uint(v);
    uint u1 = min(u0 + 1u, kMeasuredThetaH - 1u);
    uint v1 = min(v0 + 1u, kMeasuredThetaD - 1u);
    uint p = min(uint(phiD * kInvPi * float(kMeasuredPhiD)), kMeasuredPhiD - 1u);
    float fu = u - float(u0);
    return mix(mix(measured_entry(b, u0, v0, p), measured_entry(b, u1, v0, p), fu),
               mix(measured_entry(b, u0, v1, p), measured_entry(b, u1, v1, p), fu), v - float(v0));
}

/// First number of the row of the elevation of `wo`.
KERNEL_FN uint measured_row(vec3 wo) {
    float row = acos(clamp(wo.z, 0.0f, 1.0f)) * (2.0f * kInvPi) * float(kMeasuredRows);
    return min(uint(row), kMeasuredRows - 1u) * kMeasuredRowSize;
}

/// sin²(θ/2) at the lower edge of a bin of half angles: equal steps of it are equal solid angles.
KERNEL_FN float measured_edge(uint bin) {
    float t = float(bin) / float(kMeasuredThetaH);
    float s = sin(0.25f * kPi * t * t);
    return s * s;
}

/// Bin of the half angle with that sin²(θ/2).
KERNEL_FN uint measured_bin(float s) {
    float position = measured_theta_h_position(2.0f * asin(sqrt(min(s, 0.5f))));
    uint bin = min(uint(position), kMeasuredThetaH - 1u);
    if (bin > 0u && s < measured_edge(bin)) bin -= 1u;
    return bin;
}

KERNEL_FN float measured_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    uint row = measured_row(wo);
    float cosineChance = measured_number(b, row);
    vec3 h = normalize(wo + wi);
    uint bin = measured_bin((h.x * h.x + h.y * h.y) / (2.0f * (1.0f + h.z)));
    float chance = measured_number(b, row + bin + 2u) - measured_number(b, row + bin + 1u);
    float solidAngle = 4.0f * kPi * (measured_edge(bin + 1u) - measured_edge(bin));
    float lobe = chance / (solidAngle * 4.0f * max(dot(wo, h), 1e-6f));
    return cosineChance * wi.z * kInvPi + (1.0f - cosineChance) * lobe;
}

KERNEL_FN vec3 measured_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    uint row = measured_row(wo);
    float cosineChance = measured_number(b, row);
    if (u.x < cosineChance) return sample_cosine_hemisphere(vec2(u.x / cosineChance, u.y));
    float v = min((u.x - cosineChance) / (1.0f - cosineChance), 0.99999994f);
    uint low = 0u;
    uint high = kMeasuredThetaH;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (measured_number(b, row + 1u + middle) <= v)
            low = middle;
        else
            high = middle;
    }
    float first = measured_number(b, row + 1u + low);
    float last = measured_number(b, row + 2u + low);
    if (last <= first) return vec3(0.0f, 0.0f, -1.0f);
    float s = mix(measured_edge(low), measured_edge(low + 1u), min((v - first) / (last - first), 1.0f));
    float sinH = 2.0f * sqrt(s * (1.0f - s));
    float phi = 2.0f * kPi * u.y;
    vec3 h = vec3(sinH * cos(phi), sinH * sin(phi), 1.0f - 2.0f * s);
    float c = dot(wo, h);
    if (c <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    return normalize(h * (2.0f * c) - wo);
}

KERNEL_FN vec3 measured_weight(BrdfParams b, vec3 wo, vec3 wi) {
    float pdf = measured_pdf(b, wo, wi);
    if (pdf <= 0.0f) return vec3(0.0f);
    return measured_eval(b, wo, wi) * (wi.z / pdf);
}

KERNEL_END

#endif
