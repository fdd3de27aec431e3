// SPDX-License-Identifier: GPL-3.0-or-later
// Multiple scattering below a surface: the dipole of [JMLH01], derived again because the paper's eq. 4 has misprints.
//
// With σt' = σa + σs', α' = σs'/σt', D = 1/(3σt'), σtr = sqrt(σa/D), a real source at depth z_r = 1/σt' and a virtual
// one z_v = z_r + 4AD above the surface; the exitance per incident power is −D ∂φ/∂z at z = 0:
//   R_d(r) = α'/(4π) [ z_r (1+σtr d_r) e^(−σtr d_r)/d_r³ + z_v (1+σtr d_v) e^(−σtr d_v)/d_v³ ],  d² = r² + z²
#ifndef PATINA_DIPOLE_H
#define PATINA_DIPOLE_H

#include "shaders/brdf/fresnel.h"
#include "shaders/shared/interop.h"

KERNEL_BEGIN

struct DipoleParams {
    vec4 zr;          // rgb = depth of the real source [m]; w = smoothing h [m²], 0 = none
    vec4 zv;          // rgb = height of the virtual source [m]
    vec4 sigmaTr;     // rgb = effective transport coefficient [1/m]
    vec4 alphaPrime;  // rgb = reduced albedo; w = relative index of refraction
};
KERNEL_BLOCK(DipoleParams, 64)

KERNEL_FN float dipole_source(float z, float sigmaTr, float r2) {
    float d2 = r2 + z * z;
    float d = sqrt(d2);
    float s = sigmaTr * d;
    return z * (1.0f + s) * exp(-s) / (d2 * d);
}

KERNEL_FN float dipole_potential(float d2, float sigmaTr) {
    float d = sqrt(d2);
    return exp(-sigmaTr * d) / d;
}

/// `dipole_source` averaged over r² ± h, its mirror image below r² = 0 included.
KERNEL_FN float dipole_source_smooth(float z, float sigmaTr, float r2, float h) {
    float z2 = z * z;
    float outer = dipole_potential(r2 + h + z2, sigmaTr);
    float inner = dipole_potential(abs(r2 - h) + z2, sigmaTr);
    float sum = r2 > h ? inner - outer : 2.0f * dipole_potential(z2, sigmaTr) - inner - outer;
    return z * max(sum, 0.0f) / h;
}

/// Diffuse reflectance profile R_d [1/m²] at squared distance r2 [m²].
///
/// Light that enters at one sample stands for the light on a patch around it. With a smoothing h, R_d is the mean over
/// the interval r² ± h: near the sample it is spread over a disc of area πh, far away it is R_d itself, and its
/// integral over the plane is the same (∫ z (1+σd) e^(−σd)/d³ d(r²) = −2z e^(−σd)/d). Without it, samples farther apart
/// than the mean free path show as dots.
KERNEL_FN vec3 dipole_rd(DipoleParams p, float r2) {
    float h = p.zr.w;
    if (r2 < 16.0f * h)
        return vec3(p.alphaPrime.x * (dipole_source_smooth(p.zr.x, p.sigmaTr.x, r2, h) +
                                      dipole_source_smooth(p.zv.x, p.sigmaTr.x, r2, h)),
                    p.alphaPrime.y * (dipole_source_smooth(p.zr.y, p.sigmaTr.y, r2, h) +
                                      dipole_source_smooth(p.zv.y, p.sigmaTr.y, r2, h)),
                    p.alphaPrime.z * (dipole_source_smooth(p.zr.z, p.sigmaTr.z, r2, h) +
                                      dipole_source_smooth(p.zv.z, p.sigmaTr.z, r2, h))) *
               (0.25f * kInvPi);
    return vec3(p.alphaPrime.x * (dipole_source(p.zr.x, p.sigmaTr.x, r2) + dipole_source(p.zv.x, p.sigmaTr.x, r2)),
                p.alphaPrime.y * (dipole_source(p.zr.y, p.sigmaTr.y, r2) + dipole_source(p.zv.y, p.sigmaTr.y, r2)),
                p.alphaPrime.z * (dipole_source(p.zr.z, p.sigmaTr.z, r2) + dipole_source(p.zv.z, p.sigmaTr.z, r2))) *
           (0.25f * kInvPi);
}

/// Fresnel transmission F_t through the boundary; 1 for an index-matched one.
KERNEL_FN float fresnel_transmission(float eta, float cosI) { return 1.0f - fresnel_dielectric(cosI, eta); }

KERNEL_END

#endif
