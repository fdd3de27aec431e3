// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/analysis/back/mirror_image.h"
#include "core/analysis/segment/support_planes.h"
#include "core/base/progress.h"

namespace core::analysis {

/// The front mirrored at a curved surface instead of a plane: each point along its own ray, in inverse depth, at a
/// surface spanned into the outline of the object. An object seen from a point is symmetric to its outline in inverse
/// depth when it is an ellipsoid, a cylinder or a cone (the outline is then the polar plane of the eye), and nearly so
/// when it is round; parts that lie at different depths get a mirror each, and the back always meets the front at the
/// outline. The surface is the plane that fits the outline best plus a membrane (Laplace's equation) through the rest;
/// where the end of the object is hidden or out of the picture, nothing is prescribed. Where it stands it does not end
/// but is cut off by its support, or rounds off to its foot: there, and up to a fifth of its thickness above the
/// support, the outline is a bound, and the mirror no nearer.
struct SpannedMirror {
    BackSamples samples;  ///< no normals
    float error = 0;      ///< C: fraction of the front behind the surface
    float outline = 0;    ///< part of the outline where the object is known to end, [0, 1]
};

/// `support` is the plane the object stands on, if that is known. `shift` moves the surface away from the camera [m].
/// An outline of which nothing is known gives `outline` 0 and no samples. Cancellable; reports `progress` of the step.
[[nodiscard]] SpannedMirror mirrorAtSpannedSurface(const SegmentPixels& segment,
                                                   const std::optional<SupportPlane>& support, float shift,
                                                   const Progress& progress);

}  // namespace core::analysis
