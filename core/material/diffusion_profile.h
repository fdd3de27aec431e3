// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/image.h"
#include "core/material/material.h"

namespace core {

/// Mean Fresnel reflectance of a boundary for diffuse light from inside a medium of relative index `eta`; 0 for 1.
[[nodiscard]] double internalDiffuseFresnel(double eta);

/// Effect of a boundary on diffuse light inside a medium of relative index `eta`, clamped to [0.1, 10].
struct DiffuseBoundary {
    double a = 1;        ///< A: the light vanishes at the extrapolated boundary, 2AD outside
    double fluence = 0;  ///< exitance per fluence; 0 in the dipole
    double flux = 1;     ///< exitance per net flux
};
/// Dipole: A = (1 + F_dr)/(1 − F_dr). Better dipole ([dEon12]): with C_n = ∫ F(μ) μⁿ dμ over directions that meet the
/// boundary from inside, A = (1 + 3 C₂)/(1 − 2 C₁), (1 − 2 C₁)/4 and (1 − 3 C₂)/2.
[[nodiscard]] DiffuseBoundary diffuseBoundary(ScatteringModel model, double eta);

/// Spread of light below a surface: the radially symmetric reflectance profile R_d [1/m²] per colour channel, a sum
/// of point sources in a medium. Double precision: the kernels' oracle.
struct DiffusionProfile {
    /// With d² = r² + z²: flux · z (1 + σd) e^(−σ(d−δ))/d³ + fluence · e^(−σ(d−δ))/d. δ = `shift` belongs to the blur.
    struct Term {
        double z = 0;        ///< distance of the source from the surface, shift included [m]
        double sigma = 0;    ///< effective transport coefficient σtr [1/m]
        double flux = 0;     ///< [1]
        double fluence = 0;  ///< [1/m]
        double shift = 0;    ///< [m]
    };
    std::array<std::vector<Term>, 3> terms;  ///< per colour channel
    float eta = 1;                           ///< relative index of refraction of the boundary
    double sampleArea = 0;                   ///< area per sample that it is blurred for [m²]; 0 = not blurred

    /// R_d [1/m²] at squared distance `r2` [m²].
    [[nodiscard]] double evaluate(int channel, double r2) const;
    /// Integral of R_d over the plane, in closed form.
    [[nodiscard]] double integral(int channel) const;
    /// Three standard deviations of the integral when it is summed over samples of `sampleArea` each, whose density
    /// varies. The deviation is 1.5 A ∫R_d² / ∫R_d (measured on photographs with marble and
    /// cream at 10k to 131k samples: 1.4 to 1.7); it vanishes as samples become denser.
    [[nodiscard]] double tolerance(int channel) const;
};

/// σtr [1/length] of a medium with reduced scattering σs' and absorption σa: sqrt(σa/D), where D = 1/(3σt') for the
/// dipole and Grosjean's (2σa + σs')/(3σt'²) for the better one ([dEon12]).
[[nodiscard]] double transportCoefficient(double sigmaSPrime, double sigmaA, ScatteringModel model);

/// Profile of a half space with these coefficients [1/m], the same in every channel.
[[nodiscard]] DiffusionProfile halfSpaceProfile(double sigmaSPrime, double sigmaA, ScatteringModel model,
                                                const DiffuseBoundary& boundary);

/// The translucency's profile for lengths in the photograph's metres; `scale` is applied here. The dipole is
/// derived again because eq. 4 of [JMLH01] has misprints: with σt' = σa + σs', α' = σs'/σt', D = 1/(3σt'), σtr =
/// sqrt(σa/D), a real source at depth z_r = 1/σt' and a virtual one z_v = z_r + 4AD above the surface, the exitance per
/// incident power is −D ∂φ/∂z at z = 0:
///   R_d(r) = α'/(4π) Σ_{z_r, z_v} z (1 + σtr d) e^(−σtr d)/d³.
/// The better dipole weights that net flux and the fluence α'/(4πD) (e^(−σtr d_r)/d_r − e^(−σtr d_v)/d_v) with what the
/// boundary transmits of each, and counts only light scattered at least twice: another factor α'.
/// Invalid coefficients (negative, not finite) are replaced by the nearest valid ones; scattering too weak for
/// diffusion gives α' near 0.
[[nodiscard]] DiffusionProfile profileFromTranslucency(const Translucency& translucency);

/// The profile for light that enters at samples of `area` [m²] each.
///
/// Samples farther apart than the depth of the real source would be visible as dots, so R_d is blurred to the distance
/// between them: in the plane a source's profile is exp(−z sqrt(k² + σtr²)) in frequency space, so moving it δ away
/// from the surface and multiplying with exp(σtr δ) is an exact convolution, which keeps the reflectance. δ is such
/// that the blur's peak, (1 + σtr δ)/(2π δ²), is 1/(2π area). The blur vanishes as samples become denser; 0 leaves R_d
/// unchanged. Free paths 1/σtr shorter than the distance between samples, sqrt(area), are lengthened to it, at the same
/// reflectance.
[[nodiscard]] DiffusionProfile blurred(DiffusionProfile profile, double area);

}  // namespace core
