// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/analysis.h"
#include "core/image.h"
#include "core/material.h"
#include "shaders/shared/dipole.h"

namespace core {

/// Measured scattering coefficients of one material.
struct TranslucencyPreset {
    const char* key;       ///< on the command line and in files, lower case
    const char* label;     ///< for people, untranslated (context "presets")
    float sigmaSPrime[3];  ///< reduced scattering [1/mm]
    float sigmaA[3];       ///< absorption [1/mm]
};

/// The materials of [JMLH01], figure 5. The index of refraction is not part of a preset (DESIGN section 5: 1.3).
[[nodiscard]] std::span<const TranslucencyPreset> translucencyPresets();

/// By key, ignoring case; nullptr when there is none.
[[nodiscard]] const TranslucencyPreset* findTranslucencyPreset(std::string_view key);

/// The preset as a material's translucency, index 1.3, scale and weight 1.
[[nodiscard]] Translucency toTranslucency(const TranslucencyPreset& preset);

/// Coefficients that give a thick slab the diffuse reflectance `color` (each channel in [0, 1], clamped to what the
/// dipole can reach) and the light a mean free path 1/σtr of `meanFreePathMm` [mm, > 0] (inverts `diffuseReflectance`).
[[nodiscard]] Translucency translucencyFromDiffuse(const Vector3f& color, const Vector3f& meanFreePathMm, float eta);

/// Dipole in 1/m for lengths in the photograph's metres; `scale` is applied here. Coefficients that no medium has
/// (negative, not finite) count as the nearest that one can have; scattering too weak for diffusion gives α' near 0.
[[nodiscard]] kernel::DipoleParams dipoleFromTranslucency(const Translucency& translucency);

/// Diffuse reflectance of a half space: the integral of R_d over the plane, (α'/2)(1 + e^(−4/3 A s)) e^(−s) with
/// s = sqrt(3(1−α')); per channel, in [0, 1].
[[nodiscard]] Vector3f diffuseReflectance(const Translucency& translucency);

/// Mean Fresnel reflectance of a boundary for diffuse light from inside a medium of relative index `eta`; 0 for 1.
[[nodiscard]] double internalDiffuseFresnel(double eta);

/// A point on a segment's surface, where light enters.
struct SurfaceSample {
    int x = 0, y = 0;   ///< pixel
    bool back = false;  ///< on the invented back side
    Vector3f position;  ///< [m]
    Vector3f normal;    ///< unit, outward
};

/// Points on front and back of a segment, each surface element equally likely.
struct SurfaceSamples {
    std::vector<SurfaceSample> samples;
    double area = 0;  ///< [m²], front and back together: the Ã of DESIGN 3.6
};

/// Draws `count` points from the pixels of `label`, front and back, exactly in proportion to patch area (inverse
/// distribution, stratified along the Z-order curve, so that they spread evenly over the surface). Deterministic by
/// `seed`. Empty when the segment has no area.
[[nodiscard]] SurfaceSamples sampleSurface(const Analysis& analysis, const LabelImage& labels, std::uint16_t label,
                                           int count, std::uint32_t seed);

/// The dipole blurred to what these samples can resolve (zr.w, see dipole_rd): the more samples, the sharper; the limit
/// is R_d itself.
[[nodiscard]] kernel::DipoleParams smoothedFor(const SurfaceSamples& samples, kernel::DipoleParams dipole);

}  // namespace core
