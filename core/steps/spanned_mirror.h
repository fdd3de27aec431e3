// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/step_context.h"
#include "core/steps/mirror_image.h"

namespace core::steps {

/// The front mirrored at a curved surface instead of a plane: each point along its own ray, in inverse depth, at a
/// surface spanned into the outline of the object. An object seen from a point is symmetric to its outline in inverse
/// depth when it is an ellipsoid, a cylinder or a cone (the outline is then the polar plane of the eye), and nearly so
/// when it is round; parts that lie at different depths get a mirror each, and the back always meets the front at the
/// outline. The surface is the plane that fits the outline best plus a membrane (Laplace's equation) through the rest;
/// where the end of the object is hidden or out of the picture, or it does not end but stands on its support, facing
/// the camera, nothing is prescribed.
struct SpannedMirror {
    BackSamples samples;  ///< no normals
    float error = 0;      ///< C: fraction of the front behind the surface
    float outline = 0;    ///< part of the outline where the object is known to end, [0, 1]
};

/// `shift` moves the surface away from the camera [m]. An outline of which nothing is known gives `outline` 0 and no
/// samples. Cancellable; reports `progress` of the step.
[[nodiscard]] SpannedMirror mirrorAtSpannedSurface(const SegmentPixels& segment, float shift, const char* step,
                                                   float progress, const StepContext& context);

}  // namespace core::steps
