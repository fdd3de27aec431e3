// SPDX-License-Identifier: GPL-3.0-or-later
// Fresnel factor of a specular lobe, per channel, including the specular colour.
#ifndef PATINA_FRESNEL_H
#define PATINA_FRESNEL_H

#include "shaders/shared/brdf_params.h"

KERNEL_BEGIN

// Values of BrdfParams.specular.w, the same as core::Fresnel.
const int kFresnelNone = 0;
const int kFresnelSchlick = 1;
const int kFresnelDielectric = 2;
const int kFresnelConductor = 3;

/// Unpolarised reflectance of a boundary to a medium of relative index `eta`; cosine to the normal on the incident
/// side. 1 under total internal reflection (eta < 1), 0 for eta = 1.
KERNEL_FN float fresnel_dielectric(float cosI, float eta) {
    float c = clamp(cosI, 0.0f, 1.0f);
    float g2 = eta * eta - 1.0f + c * c;
    if (eta == 1.0f) return 0.0f;
    if (g2 <= 0.0f) return 1.0f;
    float g = sqrt(g2);
    float s = (g - c) / (g + c);
    float p = (c * (g + c) - 1.0f) / (c * (g - c) + 1.0f);
    return 0.5f * s * s * (1.0f + p * p);
}

/// Unpolarised reflectance of a metal of complex index eta + i·k.
KERNEL_FN float fresnel_conductor(float cosI, float eta, float k) {
    float c = clamp(cosI, 0.0f, 1.0f);
    float c2 = c * c;
    float s2 = 1.0f - c2;
    float t0 = eta * eta - k * k - s2;
    float ab = sqrt(t0 * t0 + 4.0f * eta * eta * k * k);
    float t1 = ab + c2;
    float t2 = 2.0f * c * sqrt(max(0.5f * (ab + t0), 0.0f));
    float rs = (t1 - t2) / max(t1 + t2, 1e-20f);
    float t3 = c2 * ab + s2 * s2;
    float t4 = t2 * s2;
    float rp = rs * (t3 - t4) / max(t3 + t4, 1e-20f);
    return clamp(0.5f * (rs + rp), 0.0f, 1.0f);
}

/// Fresnel factor times specular colour at the angle between direction and half vector. None: the specular colour at
/// every angle. Schlick: F0 = specular colour. Dielectric, Conductor: exact, scaled by the specular colour.
KERNEL_FN vec3 fresnel_specular(BrdfParams b, float cosH) {
    vec3 c = rgb(b.specular);
    int mode = int(b.specular.w);
    if (mode == kFresnelSchlick) {
        float m = 1.0f - clamp(cosH, 0.0f, 1.0f);
        float m5 = m * m * m * m * m;
        return c + (vec3(1.0f) - c) * m5;
    }
    if (mode == kFresnelDielectric)
        return c * vec3(fresnel_dielectric(cosH, b.eta.x), fresnel_dielectric(cosH, b.eta.y),
                        fresnel_dielectric(cosH, b.eta.z));
    if (mode == kFresnelConductor)
        return c * vec3(fresnel_conductor(cosH, b.eta.x, b.k.x), fresnel_conductor(cosH, b.eta.y, b.k.y),
                        fresnel_conductor(cosH, b.eta.z, b.k.z));
    return c;
}

/// Fresnel transmission F_t through a dielectric boundary; 1 for an index-matched one.
KERNEL_FN float fresnel_transmission(float eta, float cosI) { return 1.0f - fresnel_dielectric(cosI, eta); }

KERNEL_END

#endif
