// SPDX-License-Identifier: GPL-3.0-or-later
// Phong, the paper's: an energy-normalised lobe cosⁿα around the mirror direction.
//
//   f = ks·F · (n+1)/(2π) · cosⁿα / max(cos θi, cos θo)
//
// The lobe integrates to one over the sphere, and the division by the larger cosine ([NNSK99], "max-Phong") keeps f
// reciprocal and its albedo <= ks, and makes the limit n → ∞ a mirror of colour ks at every angle. The textbook form
// without the division, (n+2)/(2π) cosⁿα, would turn a mirror dark towards grazing angles: its limit is ks·cos θ.
// (docs/deviations.md)
#ifndef PATINA_BRDF_PHONG_H
#define PATINA_BRDF_PHONG_H

#include "shaders/brdf/fresnel.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

KERNEL_FN float phong_exponent(BrdfParams b) { return max(b.values.x, 0.0f); }

/// Density of the lobe around the mirror direction of `wo` [1/sr].
KERNEL_FN float phong_lobe(float n, vec3 wo, vec3 wi) {
    float c = wi.z * wo.z - wi.x * wo.x - wi.y * wo.y;
    if (c <= 0.0f) return 0.0f;
    return (n + 1.0f) * (0.5f * kInvPi) * pow(min(c, 1.0f), n);
}

/// Fresnel factor at the half vector of two directions above the horizon.
KERNEL_FN vec3 phong_fresnel(BrdfParams b, vec3 wo, vec3 wi) {
    vec3 h = wo + wi;
    return fresnel_specular(b, dot(wo, h) / max(length(h), 1e-12f));
}

KERNEL_FN vec3 phong_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return phong_fresnel(b, wo, wi) * (phong_lobe(phong_exponent(b), wo, wi) / max(wo.z, wi.z));
}

KERNEL_FN float phong_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    return phong_lobe(phong_exponent(b), wo, wi);
}

/// The part of the lobe below the horizon is absorbed.
KERNEL_FN vec3 phong_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    float c = pow(1.0f - u.x, 1.0f / (phong_exponent(b) + 1.0f));
    float s = sqrt(max(1.0f - c * c, 0.0f));
    float phi = 2.0f * kPi * u.y;
    return from_local(vec3(-wo.x, -wo.y, wo.z), vec3(s * cos(phi), s * sin(phi), c));
}

KERNEL_FN vec3 phong_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return phong_fresnel(b, wo, wi) * min(wi.z / wo.z, 1.0f);
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo phong_params[] = {
    {"exponent", PARAM_LABEL("params", "Exponent"), "", 1.0f, 10000.0f, 100.0f, true}};
inline constexpr core::BrdfTable phong_table = {PARAM_LABEL("brdfs", "Phong"), phong_params, false, true,
                                                kernel::kFresnelNone};
#endif

#endif
