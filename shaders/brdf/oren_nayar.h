// SPDX-License-Identifier: GPL-3.0-or-later
// Rough diffuse: Fujii's form of the Oren–Nayar model [ON94] with the multiple-scattering lobe that keeps its energy
// ("EON", [PKH25]): a white surface reflects exactly all light at every angle and roughness, which the original
// qualitative model misses by a few per cent in both directions. Reciprocal; cosine-weighted sampling.
#ifndef PATINA_BRDF_OREN_NAYAR_H
#define PATINA_BRDF_OREN_NAYAR_H

#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

KERNEL_FN float oren_nayar_roughness(BrdfParams b) { return clamp(b.values.x, 0.0f, 1.0f); }

/// Factor of the single-scattering lobe.
KERNEL_FN float oren_nayar_a(float r) { return 1.0f / (1.0f + (0.5f - 2.0f / (3.0f * kPi)) * r); }

/// Directional albedo of the white single-scattering lobe; `c` cosine to the normal, (0, 1].
KERNEL_FN float oren_nayar_albedo(float r, float c) {
    float s2 = max(1.0f - c * c, 0.0f);
    float s = sqrt(s2);
    float g = s * (acos(min(c, 1.0f)) - s * c);
    // (1 − s³) / c, without the cancellation at grazing angles
    float q = c * (1.0f + s + s2) / (1.0f + s);
    g += (2.0f / 3.0f) * s * (q - 1.0f);
    return oren_nayar_a(r) * (1.0f + r * kInvPi * g);
}

KERNEL_FN vec3 oren_nayar_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    float r = oren_nayar_roughness(b);
    float s = wo.x * wi.x + wo.y * wi.y;
    if (s > 0.0f) s = s / max(wo.z, wi.z);
    float a = oren_nayar_a(r);
    float mean = a * (1.0f + (2.0f / 3.0f - 28.0f / (15.0f * kPi)) * r);
    float lost = max(1.0f - oren_nayar_albedo(r, wo.z), 0.0f) * max(1.0f - oren_nayar_albedo(r, wi.z), 0.0f);
    vec3 rho = rgb(b.albedo);
    vec3 multiple = rho * rho * (mean * lost / max(1.0f - mean, 1e-6f)) / (vec3(1.0f) - rho * (1.0f - mean));
    return (rho * (a * (1.0f + r * s)) + multiple) * kInvPi;
}

KERNEL_FN float oren_nayar_pdf(BrdfParams, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    return wi.z * kInvPi;
}

KERNEL_FN vec3 oren_nayar_sample(BrdfParams, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    return sample_cosine_hemisphere(u);
}

KERNEL_FN vec3 oren_nayar_weight(BrdfParams b, vec3 wo, vec3 wi) { return oren_nayar_eval(b, wo, wi) * kPi; }

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo oren_nayar_params[] = {
    {"roughness", PARAM_LABEL("params", "Roughness"), "", 0.0f, 1.0f, 0.5f, false}};
inline constexpr core::BrdfTable oren_nayar_table = {PARAM_LABEL("brdfs", "Oren–Nayar"), oren_nayar_params, true, false,
                                                     0};
#endif

#endif
