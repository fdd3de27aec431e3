// SPDX-License-Identifier: GPL-3.0-or-later
// Varnish, glaze, plastic: a dielectric GGX coating over a diffuse base. Light that enters is refracted, scattered and
// partly reflected back inside, again and again, as in smooth plastic:
//
//   f = F·lobe + T(θi) T(θo) · ρ / (π η² (1 − ρ Fi)),   T = 1 − F,   Fi = 1 − (1 − Fe) / η²
//
// Fe, Fi: mean Fresnel reflectance from outside and inside. A white base under a smooth coating reflects all light;
// rough coatings lose what GGX loses. Reciprocal.
#ifndef PATINA_BRDF_COATED_H
#define PATINA_BRDF_COATED_H

#include "shaders/brdf/fresnel.h"
#include "shaders/brdf/microfacet.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

KERNEL_FN vec2 coated_alpha(BrdfParams b) { return vec2(clamp(b.values.x, kGgxMinAlpha, 1.0f)); }
KERNEL_FN float coated_ior(BrdfParams b) { return clamp(b.values.y, 1.0f, 4.0f); }

/// Mean transmission of a boundary from outside, ∫ (1 − F) 2c dc, by Gauss-Legendre quadrature in sqrt(c): 2c dc = 4t³
/// dt.
KERNEL_FN float coated_mean_transmission(float ior) {
    float sum = 0.0f;
    for (int i = 0; i < 5; ++i) {
        float x = i == 0 ? 0.0f : i < 3 ? 0.538469310f : 0.906179846f;
        float w = i == 0 ? 0.284444444f : i < 3 ? 0.239314335f : 0.118463443f;
        float t = 0.5f + 0.5f * (i == 1 || i == 3 ? -x : x);
        sum += w * 4.0f * t * t * t * (1.0f - fresnel_dielectric(t * t, ior));
    }
    return sum;
}

/// Probability of sampling the coating.
KERNEL_FN float coated_share(BrdfParams b, vec3 wo) {
    float f = fresnel_dielectric(wo.z, coated_ior(b));
    float base = (b.albedo.x + b.albedo.y + b.albedo.z) / 3.0f * (1.0f - f);
    return (f + 0.01f) / (f + base + 0.02f);
}

KERNEL_FN vec3 coated_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    float ior = coated_ior(b);
    float outside = coated_mean_transmission(ior);
    float inside = 1.0f - outside / (ior * ior);
    float t = (1.0f - fresnel_dielectric(wo.z, ior)) * (1.0f - fresnel_dielectric(wi.z, ior));
    vec3 rho = rgb(b.albedo);
    vec3 base = rho * (t * kInvPi / (ior * ior)) / (vec3(1.0f) - rho * inside);
    return base + vec3(fresnel_dielectric(0.5f * length(wo + wi), ior) * ggx_lobe(coated_alpha(b), wo, wi));
}

KERNEL_FN float coated_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    return mix(wi.z * kInvPi, ggx_lobe_pdf(coated_alpha(b), wo, wi), coated_share(b, wo));
}

KERNEL_FN vec3 coated_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    float p = coated_share(b, wo);
    if (u.x < p) return ggx_lobe_sample(coated_alpha(b), wo, vec2(u.x / p, u.y));
    return sample_cosine_hemisphere(vec2(min((u.x - p) / (1.0f - p), 0.99999994f), u.y));
}

KERNEL_FN vec3 coated_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return coated_eval(b, wo, wi) * (wi.z / max(coated_pdf(b, wo, wi), 1e-30f));
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo coated_params[] = {
    {"alpha", PARAM_LABEL("params", "Roughness"), "", 0.01f, 1.0f, 0.05f, true},
    {"ior", PARAM_LABEL("params", "Index of refraction"), "", 1.0f, 2.5f, 1.5f, false}};
inline constexpr core::BrdfTable coated_table = {PARAM_LABEL("brdfs", "Coated"), coated_params, true, false, 0};
#endif

#endif
