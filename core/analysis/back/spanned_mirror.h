// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/analysis/back/mirror_image.h"
#include "core/analysis/segment/support_planes.h"
#include "core/base/progress.h"

namespace core::analysis {

/// The front mirrored at a curved surface instead of a plane: each point along its own ray, in inverse depth, at a
/// surface spanned into the outline of the object. In inverse depth, an object seen from a point is symmetric to its
/// outline when it is an ellipsoid, a cylinder or a cone (the outline is then the polar plane of the eye), and nearly
/// so when it is round. Parts at different depths get a mirror each, and the back always meets the front at the
/// outline.
///
/// The surface is the plane that fits the outline best plus a membrane (Laplace's equation) through the remainder.
/// Nothing is prescribed where the end of the object is hidden or outside the picture. Where the object stands, it does
/// not end but is cut off by its support, or rounds off to its foot: there, and up to a fifth of its thickness above
/// the support, the outline is only a bound, and the mirror is no nearer.
struct SpannedMirror {
    BackSamples samples;  ///< no normals
    float error = 0;      ///< C: share of the front behind the surface, [0, 1]
    float outline = 0;    ///< share of the outline where the object is known to end, [0, 1]
};

/// `support`: the plane the object stands on, if known. `shift` [m] moves the surface away from the camera. `outline`
/// is 0, and there are no samples, if no part of the outline is known.
[[nodiscard]] SpannedMirror mirrorAtSpannedSurface(const SegmentPixels& segment,
                                                   const std::optional<SupportPlane>& support, float shift,
                                                   const Progress& progress);

}  // namespace core::analysis
