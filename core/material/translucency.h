// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "core/base/image.h"
#include "core/material/material.h"

namespace core {

/// Measured scattering coefficients of one material.
struct TranslucencyPreset {
    const char* key;       ///< on the command line and in files, lower case
    const char* label;     ///< for people, untranslated (context "presets")
    float sigmaSPrime[3];  ///< reduced scattering [1/mm]
    float sigmaA[3];       ///< absorption [1/mm]
    float eta;             ///< index of refraction
};

/// The materials of [JMLH01], figure 5.
[[nodiscard]] std::span<const TranslucencyPreset> translucencyPresets();

/// By key, ignoring case; nullptr when there is none.
[[nodiscard]] const TranslucencyPreset* findTranslucencyPreset(std::string_view key);

/// The preset as a material's translucency, scale and weight 1.
[[nodiscard]] Translucency toTranslucency(const TranslucencyPreset& preset);

/// Coefficients for which a thick slab has the diffuse reflectance `color` (each channel in [0, 1], clamped to the
/// range of the model) and the mean free path 1/σtr `meanFreePathMm` [mm, > 0]. Inverts `diffuseReflectance`.
[[nodiscard]] Translucency translucencyFromDiffuse(const Vector3f& color, const Vector3f& meanFreePathMm, float eta,
                                                   ScatteringModel model = ScatteringModel::Dipole);

/// Mean free path 1/σtr per channel [mm], at most kMaxMeanFreePath: without absorption it is infinite.
[[nodiscard]] Vector3f diffuseMeanFreePath(const Translucency& translucency);
inline constexpr float kMaxMeanFreePath = 1000;  // [mm]

/// Diffuse reflectance of a half space: the integral of R_d over the plane, for the dipole (α'/2)(1 + e^(−4/3 A s))
/// e^(−s) with s = sqrt(3(1−α')); per channel, in [0, 1].
[[nodiscard]] Vector3f diffuseReflectance(const Translucency& translucency);

}  // namespace core
