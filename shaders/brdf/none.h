// SPDX-License-Identifier: GPL-3.0-or-later
// Reflects nothing: black, or the body of a purely translucent material.
#ifndef PATINA_BRDF_NONE_H
#define PATINA_BRDF_NONE_H

#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"

KERNEL_BEGIN

KERNEL_FN vec3 none_eval(BrdfParams, vec3, vec3) { return vec3(0.0f); }
KERNEL_FN float none_pdf(BrdfParams, vec3, vec3) { return 0.0f; }
KERNEL_FN vec3 none_sample(BrdfParams, vec3, vec2) { return vec3(0.0f, 0.0f, -1.0f); }
KERNEL_FN vec3 none_weight(BrdfParams, vec3, vec3) { return vec3(0.0f); }

KERNEL_END

#ifdef __cplusplus
inline constexpr core::BrdfTable none_table = {PARAM_LABEL("brdfs", "None"), {}, false, false, 0};
#endif

#endif
