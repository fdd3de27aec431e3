// SPDX-License-Identifier: GPL-3.0-or-later
// The material of one segment as kernels read it; the same bytes in C++, std140 and std430.
#ifndef PATINA_BRDF_PARAMS_H
#define PATINA_BRDF_PARAMS_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

struct BrdfParams {
    vec4 albedo;    // rgb = diffuse albedo, [0, 1]
    vec4 specular;  // rgb = specular colour, w = Fresnel mode (shaders/brdf/fresnel.h)
    vec4 eta;       // rgb = index of refraction, real part
    vec4 k;         // rgb = extinction coefficient
    vec4 values;    // the BRDF's own parameters 0 to 3, in its table's order
    vec4 values2;   // parameters 4 to 7
    vec4 values3;   // parameters 8 to 11
    uint type;      // index in shaders/brdf/registry.h
    uint file;      // measured: first number of the table in kernels; user's: distinguishes one text from another
#ifdef __cplusplus
    const float* measured;  // measured: the table (shaders/brdf/measured.h), for the reference renderer
#else
    uint pad0;
    uint pad1;
#endif
};
KERNEL_BLOCK(BrdfParams, 128)

KERNEL_END

#endif
