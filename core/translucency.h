// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/analysis.h"
#include "core/image.h"
#include "core/material.h"

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

/// What a boundary makes of diffuse light inside a medium of relative index `eta` [0.1, 10], else clamped.
struct DiffuseBoundary {
    double a = 1;        ///< light at the boundary behaves as if it were 2AD farther out
    double fluence = 0;  ///< exitance per fluence; 0 in the dipole
    double flux = 1;     ///< exitance per net flux
};
/// Dipole: A = (1 + F_dr)/(1 − F_dr). Better dipole ([dEon12]): with C_n = ∫ F(μ) μⁿ dμ over directions that meet the
/// boundary from inside, A = (1 + 3 C₂)/(1 − 2 C₁), (1 − 2 C₁)/4 and (1 − 3 C₂)/2.
[[nodiscard]] DiffuseBoundary diffuseBoundary(ScatteringModel model, double eta);

/// Coefficients that give a thick slab the diffuse reflectance `color` (each channel in [0, 1], clamped to what the
/// model can reach) and the light a mean free path 1/σtr of `meanFreePathMm` [mm, > 0] (inverts `diffuseReflectance`).
[[nodiscard]] Translucency translucencyFromDiffuse(const Vector3f& color, const Vector3f& meanFreePathMm, float eta,
                                                   ScatteringModel model = ScatteringModel::Dipole);

/// Mean free path 1/σtr per channel [mm]; where nothing is absorbed it has no end and `kLongestFreePath` stands for it.
[[nodiscard]] Vector3f diffuseMeanFreePath(const Translucency& translucency);
inline constexpr float kLongestFreePath = 1000;  // [mm]

/// Diffuse reflectance of a half space: the integral of R_d over the plane, for the dipole (α'/2)(1 + e^(−4/3 A s))
/// e^(−s) with s = sqrt(3(1−α')); per channel, in [0, 1].
[[nodiscard]] Vector3f diffuseReflectance(const Translucency& translucency);

/// Mean Fresnel reflectance of a boundary for diffuse light from inside a medium of relative index `eta`; 0 for 1.
[[nodiscard]] double internalDiffuseFresnel(double eta);

/// A point on a segment's surface, where light enters.
struct SurfaceSample {
    int x = 0, y = 0;   ///< pixel
    bool back = false;  ///< on the invented back side
    Vector3f position;  ///< [m]
    Vector3f normal;    ///< unit, outward
    double curve = 0;   ///< place on the curve that sampling follows, in [0, 1); equal lengths are equal areas
};

/// Points on front and back of a segment, each surface element equally likely.
struct SurfaceSamples {
    std::vector<SurfaceSample> samples;
    std::vector<std::uint32_t> order;  ///< samples along the curve
    double area = 0;                   ///< [m²], front and back together: the Ã of DESIGN 3.6
    /// What one sample stands for on average [m²]; 0 when there is none.
    [[nodiscard]] double areaPerSample() const {
        return samples.empty() ? 0.0 : area / static_cast<double>(samples.size());
    }
};

/// Draws `count` points from the pixels of `label`, front and back, exactly in proportion to patch area: an
/// Owen-scrambled van der Corput sequence through the inverse distribution along a Hilbert curve over the picture.
/// Progressive: the first n of any larger set are the set of n, and spread evenly over the surface. Deterministic by
/// `seed`. Empty when the segment has no area.
[[nodiscard]] SurfaceSamples sampleSurface(const Analysis& analysis, const LabelImage& labels, std::uint16_t label,
                                           int count, std::uint32_t seed);

/// What each of the first `count` samples stands for [m²]: the part of the curve that is nearer to it than to any other
/// of them. The sum is `samples.area`; less noise than equal parts, above all where count is no power of two.
[[nodiscard]] std::vector<float> sampleAreas(const SurfaceSamples& samples, std::size_t count);

}  // namespace core
