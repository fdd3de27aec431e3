// SPDX-License-Identifier: GPL-3.0-or-later
// The anisotropic GGX lobe [WMLT07] without its Fresnel factor, shared by the BRDFs that have one. `alpha`: widths
// along the frame's x and y axes.
//
// With g(v) = 1 / (vz + sqrt(αx² vx² + αy² vy² + vz²)), so that G1(v) = 2 vz g(v), everything is free of divisions by
// cosines: lobe = D · g(wi) · g(wo)     pdf = D · g(wo) / 2 (visible normals, [Hei18])     lobe · cos / pdf = G1(wi)
#ifndef PATINA_BRDF_MICROFACET_H
#define PATINA_BRDF_MICROFACET_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

/// Smallest width that float can resolve.
const float kGgxMinAlpha = 0.001f;

KERNEL_FN float ggx_g(vec2 alpha, vec3 v) {
    float x = alpha.x * v.x;
    float y = alpha.y * v.y;
    return 1.0f / (v.z + sqrt(x * x + y * y + v.z * v.z));
}

/// Normal distribution [1/sr] at a half vector that need not be unit length. Written with the squared sine instead of
/// 1 − cos², which would cancel for small alpha.
KERNEL_FN float ggx_d(vec2 alpha, vec3 h) {
    float x = h.x / alpha.x;
    float y = h.y / alpha.y;
    float t = (x * x + y * y + h.z * h.z) / dot(h, h);
    return 1.0f / (kPi * alpha.x * alpha.y * t * t);
}

/// Value [1/sr] and density of `ggx_lobe_sample` [1/sr] for directions above the horizon.
KERNEL_FN float ggx_lobe(vec2 alpha, vec3 wo, vec3 wi) {
    return ggx_d(alpha, wo + wi) * ggx_g(alpha, wo) * ggx_g(alpha, wi);
}
KERNEL_FN float ggx_lobe_pdf(vec2 alpha, vec3 wo, vec3 wi) { return 0.5f * ggx_d(alpha, wo + wi) * ggx_g(alpha, wo); }

/// Mirrors `wo` (above the horizon) at a visible normal ([Hei18], listing 1); may return directions below the horizon.
KERNEL_FN vec3 ggx_lobe_sample(vec2 alpha, vec3 wo, vec2 u) {
    vec3 v = normalize(vec3(alpha.x * wo.x, alpha.y * wo.y, wo.z));
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
    vec3 h = normalize(vec3(alpha.x * m.x, alpha.y * m.y, max(m.z, 1e-6f)));
    return normalize(h * (2.0f * dot(wo, h)) - wo);
}

KERNEL_END

#endif
