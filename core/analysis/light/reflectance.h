// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/light/reflected_maps.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// What one glossy segment shows of the world (docs/method.md#reflectance, cases A to D).
struct SegmentReflections {
    Reflectance estimate;
    /// Colours whose mirrored ray hits nothing seen: ρ times the environment as the lobe blurs it. Pixels on strongly
    /// curved surfaces mirror more than a texel, so they weigh less; the directions between them and their neighbours
    /// are interpolated. Where two halves of the segment's pixels are inconsistent, smoothed until they are consistent
    /// (`agreementWidth`).
    DirectionalMap missed;
    /// 1 = everything `missed` knows about the texel comes from rays that meet a support where it is not seen
    /// (`ContinuedSupports`): what lies there, but not the environment. Empty = nowhere.
    Image<std::uint8_t> overSupport;
    Vector3f view{0, 0, 1};  ///< unit, from the camera to the segment
};

/// Minimum solid angle [sr] known on both sides for ρ to be reliable.
inline constexpr float kMinCommonSolidAngle = 0.02f;

/// L_S, L_G, ρ and lobe width of one segment.
///
/// ρ = mean(reflected)/mean(incident) per channel, over the directions that both maps really know. Sources, in this
/// order:
/// 1. Lobes: interior pixels whose mirrored ray meets a front whose colour is true for every viewer, with what their
///    whole lobe meets there (`probeLobes`). These also give the width, if what is reflected has enough detail.
/// 2. Pairs: what such a pixel shows against what its mirrored ray alone meets, binned by direction; every texel weighs
///    its solid angle. No parallax between the segment's points and its centre.
/// 3. Where the pairs cover less than `kMinCommonSolidAngle`: the texels covered in both L_S and L_G.
/// Sources 2 and 3 leave out texels whose ratio of luminance is among the lowest or highest tenth. Clamped to [0.02,
/// 1]. `reliable` is false when no source covers `kMinCommonSolidAngle` (ρ is then the ratio of the filled maps'
/// means, or 1 where that exceeds 1), and when the segment shows clearly more light than it mirrors, so that it is not
/// a pure mirror.
[[nodiscard]] SegmentReflections estimateReflectance(const ReflectanceInput& in, const StepContext& context);

/// True if what is known of the light contradicts a pure mirror: the segment has diffuse colour of its own. A segment
/// that mirrors nothing known, such as a chrome ball alone (a light probe), contradicts nothing.
[[nodiscard]] inline bool showsMoreThanItMirrors(const Reflectance& estimate) {
    return !estimate.reliable && estimate.commonSolidAngle >= kMinCommonSolidAngle && estimate.rho.maxCoeff() >= 1;
}

}  // namespace core::analysis
