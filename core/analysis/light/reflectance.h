// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/analysis/kernels.h"
#include "core/analysis/light/fill_directions.h"
#include "core/analysis/segment/continued_supports.h"
#include "core/analysis/step.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// Bit c: the camera clipped channel c of a pixel (`Photo::clipLevel`).
[[nodiscard]] unsigned clippedChannels(const Photo& photo, int x, int y);

/// Whether the photo's colour at a pixel is what any viewer sees there and not a mixture of two objects: depth, and all
/// eight neighbours of the same label (at the border of the picture: those that exist).
[[nodiscard]] bool isInterior(const LabelImage& labels, const ImageF& depth, int x, int y);

/// What one glossy segment shows of the world (docs/method.md#reflectance, cases A to D).
struct SegmentReflections {
    Reflectance estimate;
    /// Colours whose mirrored ray hits nothing seen: ρ times the environment as the lobe blurs it. Weighted: where the
    /// surface is curved so much that a pixel mirrors more than a texel, it knows less of each, and what lies
    /// between it and its neighbours is interpolated. Where the segment's
    /// pixels contradict each other, smoothed until they agree (`agreementWidth`).
    DirectionalMap missed;
    /// 1 = all that `missed` knows there comes from rays that meet a support where it is not seen
    /// (`ContinuedSupports`): what lies there, but not the environment. Empty = nowhere.
    Image<std::uint8_t> overSupport;
    Vector3f view{0, 0, 1};  ///< unit, from the camera to the segment
};

/// L_S, L_G, ρ and lobe width of one segment.
///
/// ρ = mean(reflected)/mean(incident) per channel, over the directions both maps really know. Sources, in this order:
/// 1. Lobes: interior pixels whose mirrored ray meets a front whose colour is true for every viewer, with what their
///    whole lobe meets there (`fitLobe`). This also tells the width; it needs detail in what is reflected.
/// 2. Pairs: what such a pixel shows against what its mirrored ray alone meets, binned by direction; every texel weighs
///    its solid angle. No parallax between the segment's points and its centre.
/// 3. Where the pairs cover less than `kMinCommonSolidAngle`: the texels covered in both L_S and L_G.
/// In 2 and 3 texels whose ratio of luminance is among the lowest or highest tenth are left out. Clamped to [0.02, 1].
/// `reliable` is false when no source covers `kMinCommonSolidAngle`, then ρ is the ratio of the filled maps' means; and
/// when the segment shows clearly more light than it mirrors: then it is not (only) a mirror.
[[nodiscard]] SegmentReflections estimateReflectance(const Scene& scene, const Surface& front, const Surface& back,
                                                     AnalysisKernels::RayMarcher& marcher,
                                                     const Image<std::uint8_t>& distant,
                                                     const ContinuedSupports& continued, std::uint16_t label,
                                                     const StepContext& context);

/// The estimate contradicts itself: the segment has colours of its own beside what it mirrors.
[[nodiscard]] inline bool showsMoreThanItMirrors(const Reflectance& estimate) {
    return !estimate.reliable && estimate.rho.maxCoeff() >= 1;
}

inline constexpr float kMinCommonSolidAngle = 0.02f;  ///< [sr]

}  // namespace core::analysis
