// SPDX-License-Identifier: GPL-3.0-or-later
// GGX microfacets [WMLT07]: f = F · D · G1(wi) · G1(wo) / (4 cos θi cos θo), separable Smith shadowing, isotropic,
// single scattering (rough surfaces lose some energy). alpha is the width itself, not its root.
//
// With g(v) = 1 / (vz + sqrt(α² + (1−α²) vz²)), so that G1(v) = 2 vz g(v), everything is free of divisions by cosines:
//   f = F · D · g(wi) · g(wo)     pdf = D · g(wo) / 2 (visible normals, [Hei18])     f cos / pdf = F · G1(wi)
#ifndef PATINA_BRDF_GGX_H
#define PATINA_BRDF_GGX_H

#include "shaders/brdf/fresnel.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"

KERNEL_BEGIN

/// Below this width float cannot resolve the lobe any more.
const float kGgxMinAlpha = 0.001f;

KERNEL_FN float ggx_alpha(BrdfParams b) { return clamp(b.values.x, kGgxMinAlpha, 1.0f); }

KERNEL_FN float ggx_g(float alpha, float vz) {
    float a2 = alpha * alpha;
    return 1.0f / (vz + sqrt(a2 + (1.0f - a2) * vz * vz));
}

/// Normal distribution [1/sr] at a half vector that need not be unit length. Written with the squared sine instead of
/// 1 − cos², which would cancel for small alpha.
KERNEL_FN float ggx_d(float alpha, vec3 h) {
    float a2 = alpha * alpha;
    float l2 = dot(h, h);
    float t = (h.x * h.x + h.y * h.y + a2 * h.z * h.z) / l2;
    return a2 / (kPi * t * t);
}

KERNEL_FN vec3 ggx_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    float alpha = ggx_alpha(b);
    vec3 h = wo + wi;
    return fresnel_specular(b, dot(wo, h) / length(h)) * (ggx_d(alpha, h) * ggx_g(alpha, wo.z) * ggx_g(alpha, wi.z));
}

KERNEL_FN float ggx_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    float alpha = ggx_alpha(b);
    return 0.5f * ggx_d(alpha, wo + wi) * ggx_g(alpha, wo.z);
}

/// Mirrors `wo` at a visible normal ([Hei18], listing 1); directions below the horizon are absorbed.
KERNEL_FN vec3 ggx_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    float alpha = ggx_alpha(b);
    vec3 v = normalize(vec3(alpha * wo.x, alpha * wo.y, wo.z));
    float l2 = v.x * v.x + v.y * v.y;
    vec3 t1 = vec3(1.0f, 0.0f, 0.0f);
    if (l2 > 1e-20f) t1 = vec3(-v.y, v.x, 0.0f) / sqrt(l2);
    vec3 t2 = cross(v, t1);
    float r = sqrt(u.x);
    float phi = 2.0f * kPi * u.y;
    float p1 = r * cos(phi);
    float p2 = r * sin(phi);
    float s = 0.5f * (1.0f + v.z);
    p2 = (1.0f - s) * sqrt(max(1.0f - p1 * p1, 0.0f)) + s * p2;
    float p3 = sqrt(max(1.0f - p1 * p1 - p2 * p2, 0.0f));
    vec3 m = t1 * p1 + t2 * p2 + v * p3;
    vec3 h = normalize(vec3(alpha * m.x, alpha * m.y, max(m.z, 1e-6f)));
    return normalize(h * (2.0f * dot(wo, h)) - wo);
}

KERNEL_FN vec3 ggx_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 h = wo + wi;
    return fresnel_specular(b, dot(wo, h) / length(h)) * (2.0f * wi.z * ggx_g(ggx_alpha(b), wi.z));
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo ggx_params[] = {
    {"alpha", PARAM_LABEL("params", "Roughness"), "", 0.01f, 1.0f, 0.2f, true}};
inline constexpr core::BrdfTable ggx_table = {PARAM_LABEL("brdfs", "GGX"), ggx_params, false, true,
                                              kernel::kFresnelSchlick};
#endif

#endif
