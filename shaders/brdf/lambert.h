// SPDX-License-Identifier: GPL-3.0-or-later
// Lambert: f = albedo / π, cosine-weighted sampling.
#ifndef PATINA_BRDF_LAMBERT_H
#define PATINA_BRDF_LAMBERT_H

#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

KERNEL_FN vec3 lambert_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return rgb(b.albedo) * kInvPi;
}

KERNEL_FN float lambert_pdf(BrdfParams, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    return wi.z * kInvPi;
}

KERNEL_FN vec3 lambert_sample(BrdfParams, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    return sample_cosine_hemisphere(u);
}

KERNEL_FN vec3 lambert_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return rgb(b.albedo);
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::BrdfTable lambert_table = {PARAM_LABEL("brdfs", "Lambert"), {}, true, false, 0};
#endif

#endif
