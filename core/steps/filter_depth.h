// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene.h"
#include "core/steps/step.h"

namespace core::steps {

/// Relative standard deviation of the depth noise, σ(z)/z: from second differences of inverse depth (which vanish on
/// planes; median, so that edges and curvature do not count) and from the depth's quantisation step, whichever is
/// larger.
[[nodiscard]] float estimateRelativeNoise(const ImageF& depth, const LabelImage& labels);

/// Joint bilateral filter in inverse depth over pairs of pixels that lie opposite each other about the centre: planes
/// are linear in inverse depth, so a plane of any tilt stays the plane it is. A pair counts by its distance, by its
/// colours' similarity to the centre, and by how far its mean is from the centre's depth; both pixels must be valid and
/// carry the centre's label. The depth range is min(depthSigma, 3·relativeNoise): exact depth keeps its detail.
[[nodiscard]] ImageF filterDepth(const ImageF& depth, const ImageRgb& color, const LabelImage& labels,
                                 const DepthFilterParams& params, float relativeNoise, const StepContext& context);

/// Fills holes inside labelled segments whose every pixel has a valid pixel of the segment within `radius` [px], by a
/// plane through the neighbours. Holes without a label stay distant: they are the background.
void fillSmallHoles(ImageF& depth, const LabelImage& labels, int radius);

/// Gives every labelled pixel a depth when its segment has any: a membrane (Laplace's equation in inverse depth) over
/// the segment's valid pixels. Sensors miss glossy, dark and thin parts and the strip beside an outline; a pixel that
/// the user marked belongs to its object all the same, and would keep its old material otherwise. Unlabelled pixels
/// stay distant.
void completeSegments(ImageF& depth, const LabelImage& labels, const StepContext& context = StepContext());

}  // namespace core::steps
