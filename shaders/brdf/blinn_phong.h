// SPDX-License-Identifier: GPL-3.0-or-later
// Blinn–Phong: a lobe cosⁿθh around the half vector, normalised over half vectors as by Ashikhmin and Shirley [AS00]:
//
//   f = ks·F · (n+1)/(8π) · cosⁿθh / (wi·h · max(cos θi, cos θo))
//
// Reciprocal, reflects at most ks, and tends to a mirror of colour ks at every angle, as the Phong lobe here does.
#ifndef PATINA_BRDF_BLINN_PHONG_H
#define PATINA_BRDF_BLINN_PHONG_H

#include "shaders/brdf/fresnel.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"

KERNEL_BEGIN

KERNEL_FN float blinn_phong_exponent(BrdfParams b) { return max(b.values.x, 0.0f); }

KERNEL_FN float blinn_phong_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    float n = blinn_phong_exponent(b);
    vec3 h = wo + wi;
    float l2 = max(dot(h, h), 1e-12f);
    // cosⁿ = (1 − sin²)^(n/2); wi·h = |wo + wi| / 2
    float c2 = 1.0f - (h.x * h.x + h.y * h.y) / l2;
    return (n + 1.0f) * 0.25f * kInvPi * pow(max(c2, 1e-30f), 0.5f * n) / sqrt(l2);
}

KERNEL_FN vec3 blinn_phong_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return fresnel_specular(b, 0.5f * length(wo + wi)) * min(wi.z / wo.z, 1.0f);
}

KERNEL_FN vec3 blinn_phong_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return fresnel_specular(b, 0.5f * length(wo + wi)) * (blinn_phong_pdf(b, wo, wi) / max(wo.z, wi.z));
}

/// Mirrors `wo` at a half vector of the lobe; half vectors that face away from `wo` are absorbed.
KERNEL_FN vec3 blinn_phong_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    float c = pow(1.0f - u.x, 1.0f / (blinn_phong_exponent(b) + 1.0f));
    float s = sqrt(max(1.0f - c * c, 0.0f));
    float phi = 2.0f * kPi * u.y;
    vec3 h = vec3(s * cos(phi), s * sin(phi), c);
    float oh = dot(wo, h);
    if (oh <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    return normalize(h * (2.0f * oh) - wo);
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo blinn_phong_params[] = {
    {"exponent", PARAM_LABEL("params", "Exponent"), "", 1.0f, 10000.0f, 400.0f, true}};
inline constexpr core::BrdfTable blinn_phong_table = {PARAM_LABEL("brdfs", "Blinn–Phong"), blinn_phong_params, false,
                                                      true, kernel::kFresnelNone};
#endif

#endif
