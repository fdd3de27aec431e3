// SPDX-License-Identifier: GPL-3.0-or-later
// BRDFs that the user wrote (docs/user-brdfs.md). A kernel's text is preprocessed with PATINA_USER_BRDFS when the
// program is built; what is declared here is defined at its end when it is compiled, at run time
// (render/kernels/user_kernels.cpp).
#ifndef PATINA_BRDF_USER_H
#define PATINA_BRDF_USER_H

#include "shaders/shared/brdf_params.h"

#if defined(PATINA_USER_BRDFS) && !defined(__cplusplus)

// Faults in calls since this was last set to 0.
uint userFaults = 0u;
const uint kUserLoops = 1u;      // the steps of a call's loops ran out
const uint kUserDirection = 2u;  // a sampled direction was not of unit length

vec3 user_eval(BrdfParams b, vec3 wo, vec3 wi);
float user_pdf(BrdfParams b, vec3 wo, vec3 wi);
vec3 user_sample(BrdfParams b, vec3 wo, vec2 u);
vec3 user_weight(BrdfParams b, vec3 wo, vec3 wi);
#define BRDF_USER_CASE(call) return call;

#else

#define BRDF_USER_CASE(call) break;

#endif

#endif
