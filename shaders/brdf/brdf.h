// SPDX-License-Identifier: GPL-3.0-or-later
// Any BRDF by its id: the one header a kernel or the reference renderer includes. All directions are unit length in the
// shading frame (n = +z) and point away from the surface; functions are zero when either is below the horizon.
//
// A BRDF called X is five things in shaders/brdf/X.h:
//   vec3 X_eval(b, wo, wi)    the BRDF [1/sr], without the cosine
//   float X_pdf(b, wo, wi)    density of X_sample [1/sr] over the upper hemisphere; 1 − its integral is absorbed
//   vec3 X_sample(b, wo, u)   direction from two uniform numbers; wi.z <= 0: the path is absorbed
//   vec3 X_weight(b, wo, wi)  eval · cos / pdf in closed form, finite wherever X_sample can go
//   X_table                   its description and parameters (core::BrdfTable), C++ only
#ifndef PATINA_BRDF_H
#define PATINA_BRDF_H

#include "shaders/brdf/registry.h"
#include "shaders/brdf/user.h"

KERNEL_BEGIN

// A kernel is compiled for the BRDFs in use (bit = id); the others read as absorbing.
#ifdef __cplusplus
const uint kBrdfSet = 0xffffffffu;
#else
layout(constant_id = 0) const uint kBrdfSet = 0xffffffffu;
#endif

#define BRDF_CASE(id, name)                                                 \
    case (id):                                                              \
        if ((kBrdfSet & (1u << (id))) != 0u) return name##_eval(b, wo, wi); \
        break;
KERNEL_FN vec3 brdf_eval(BrdfParams b, vec3 wo, vec3 wi) {
    switch (int(b.type)) {
        BRDF_DISPATCH_LIST(BRDF_CASE)
        default:
            BRDF_USER_CASE(user_eval(b, wo, wi))
    }
    return vec3(0.0f);
}
#undef BRDF_CASE

#define BRDF_CASE(id, name)                                                \
    case (id):                                                             \
        if ((kBrdfSet & (1u << (id))) != 0u) return name##_pdf(b, wo, wi); \
        break;
KERNEL_FN float brdf_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    switch (int(b.type)) {
        BRDF_DISPATCH_LIST(BRDF_CASE)
        default:
            BRDF_USER_CASE(user_pdf(b, wo, wi))
    }
    return 0.0f;
}
#undef BRDF_CASE

#define BRDF_CASE(id, name)                                                  \
    case (id):                                                               \
        if ((kBrdfSet & (1u << (id))) != 0u) return name##_sample(b, wo, u); \
        break;
KERNEL_FN vec3 brdf_sample(BrdfParams b, vec3 wo, vec2 u) {
    switch (int(b.type)) {
        BRDF_DISPATCH_LIST(BRDF_CASE)
        default:
            BRDF_USER_CASE(user_sample(b, wo, u))
    }
    return vec3(0.0f, 0.0f, -1.0f);
}
#undef BRDF_CASE

#define BRDF_CASE(id, name)                                                   \
    case (id):                                                                \
        if ((kBrdfSet & (1u << (id))) != 0u) return name##_weight(b, wo, wi); \
        break;
KERNEL_FN vec3 brdf_weight(BrdfParams b, vec3 wo, vec3 wi) {
    switch (int(b.type)) {
        BRDF_DISPATCH_LIST(BRDF_CASE)
        default:
            BRDF_USER_CASE(user_weight(b, wo, wi))
    }
    return vec3(0.0f);
}
#undef BRDF_CASE

KERNEL_END

#endif
