// SPDX-License-Identifier: GPL-3.0-or-later
// GGX microfacets [WMLT07]: f = F · D · G1(wi) · G1(wo) / (4 cos θi cos θo), separable Smith shadowing, isotropic,
// single scattering (rough surfaces lose some energy). alpha is the width itself, not its root. A metal is its Fresnel
// mode "conductor" with n and k (core/material/metals.h).
#ifndef PATINA_BRDF_GGX_H
#define PATINA_BRDF_GGX_H

#include "shaders/brdf/fresnel.h"
#include "shaders/brdf/microfacet.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"

KERNEL_BEGIN

KERNEL_FN vec2 ggx_alpha(BrdfParams b) { return vec2(clamp(b.values.x, kGgxMinAlpha, 1.0f)); }

KERNEL_FN vec3 ggx_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 h = wo + wi;
    return fresnel_specular(b, dot(wo, h) / length(h)) * ggx_lobe(ggx_alpha(b), wo, wi);
}

KERNEL_FN float ggx_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    return ggx_lobe_pdf(ggx_alpha(b), wo, wi);
}

KERNEL_FN vec3 ggx_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    return ggx_lobe_sample(ggx_alpha(b), wo, u);
}

KERNEL_FN vec3 ggx_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 h = wo + wi;
    return fresnel_specular(b, dot(wo, h) / length(h)) * (2.0f * wi.z * ggx_g(ggx_alpha(b), wi));
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo ggx_params[] = {
    {"alpha", PARAM_LABEL("params", "Roughness"), "", 0.01f, 1.0f, 0.2f, true}};
inline constexpr core::BrdfTable ggx_table = {PARAM_LABEL("brdfs", "GGX"), ggx_params, false, true,
                                              kernel::kFresnelSchlick};
#endif

#endif
