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
    vec4 zr;          // rgb = depth of the real source [m]; w = area per surface sample [m²], 0 = unblurred
    vec4 zv;          // rgb = height of the virtual source [m]
    vec4 sigmaTr;     // rgb = effective transport coefficient [1/m]
    vec4 alphaPrime;  // rgb = reduced albedo; w = relative index of refraction
};
KERNEL_BLOCK(DipoleParams, 64)

/// One source at depth z, blurred by moving it `delta` away from the surface (see dipole_rd).
KERNEL_FN float dipole_source(float z, float sigmaTr, float delta, float r2) {
    float zd = z + delta;
    float d2 = r2 + zd * zd;
    float d = sqrt(d2);
    return zd * (1.0f + sigmaTr * d) * exp(-sigmaTr * (d - delta)) / (d2 * d);
}

/// How far to move the sources for samples that stand for `area` [m²] each: the peak of the blur,
/// (1 + σtr δ)/(2π δ²), becomes 1/(2π area).
KERNEL_FN float dipole_blur(float sigmaTr, float area) {
    float b = 0.5f * sigmaTr * area;
    return b + sqrt(b * b + area);
}

/// Both sources of one channel.
KERNEL_FN float dipole_channel(float zr, float zv, float sigmaTr, float area, float r2) {
    float delta = dipole_blur(sigmaTr, area);
    return dipole_source(zr, sigmaTr, delta, r2) + dipole_source(zv, sigmaTr, delta, r2);
}

/// Diffuse reflectance profile R_d [1/m²] at squared distance r2 [m²].
///
/// Light that enters at one sample stands for the light on a patch around it. Samples farther apart than the real
/// source is deep would show as dots, so R_d is blurred to the distance between them (zr.w): in the plane one source's
/// profile is exp(−z sqrt(k² + σtr²)) in frequency space, so moving it δ away from the surface and multiplying with
/// exp(σtr δ) is an exact convolution, which keeps the reflectance. It vanishes as the samples grow denser.
KERNEL_FN vec3 dipole_rd(DipoleParams p, float r2) {
    return vec3(p.alphaPrime.x * dipole_channel(p.zr.x, p.zv.x, p.sigmaTr.x, p.zr.w, r2),
                p.alphaPrime.y * dipole_channel(p.zr.y, p.zv.y, p.sigmaTr.y, p.zr.w, r2),
                p.alphaPrime.z * dipole_channel(p.zr.z, p.zv.z, p.sigmaTr.z, p.zr.w, r2)) *
           (0.25f * kInvPi);
}

/// Fresnel transmission F_t through the boundary; 1 for an index-matched one.
KERNEL_FN float fresnel_transmission(float eta, float cosI) { return 1.0f - fresnel_dielectric(cosI, eta); }

KERNEL_END

#endif
