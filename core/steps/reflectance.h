// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/steps/fill_directions.h"
#include "core/steps/step.h"

namespace core::steps {

/// Whether the photo's colour at a pixel is what any viewer sees there and not a mixture of two objects: depth, and all
/// eight neighbours of the same label (at the border of the picture: those that exist).
[[nodiscard]] bool isInterior(const LabelImage& labels, const ImageF& depth, int x, int y);

/// The distant pixel that a ray leaving in direction `d` ends in: the vanishing point of `d`, when it lies in the
/// picture, has no depth and none beside it.
[[nodiscard]] std::optional<Vector3f> distantColor(const Photo& photo, const ImageF& depth, const Vector3f& d);

/// What one glossy segment shows of the world (DESIGN 3.3, cases A to D).
struct SegmentReflections {
    Reflectance estimate;
    DirectionalAccumulator missed;  ///< colours whose mirrored ray hits nothing: the environment times ρ
};

/// L_S, L_G and ρ of one segment.
///
/// ρ = mean(reflected)/mean(incident) per channel, over the directions both maps really know. Two sources, in this
/// order:
/// 1. Pairs: an interior pixel whose mirrored ray ends on the front of an interior pixel of a segment that is not
/// glossy,
///    or in a distant pixel, knows both its own colour and what it mirrors, at the right place: no parallax between the
///    segment's points and its centre. Binned by direction; every texel weighs its solid angle.
/// 2. Where the pairs cover less than `kMinCommonSolidAngle`: the texels covered in both L_S and L_G.
/// Texels whose ratio of luminance is among the lowest or highest tenth are left out. Clamped to [0.02, 1].
/// `reliable` is false when neither source covers `kMinCommonSolidAngle`; then ρ is the ratio of the filled maps'
/// means.
[[nodiscard]] SegmentReflections estimateReflectance(const Scene& scene, const Surface& front, const Surface& back,
                                                     const DepthLayers& layers, std::uint16_t label,
                                                     const StepContext& context, float from, float to);

inline constexpr float kMinCommonSolidAngle = 0.02f;  ///< [sr]

}  // namespace core::steps
