// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/back/mirror_plane.h"

namespace core::analysis {

/// An invented back in one pixel.
struct BackSample {
    float w = 0;               ///< 1/z [1/m]; 0 = not covered
    Vector3f normal{0, 0, 0};  ///< outward, any length; zero = to be computed from the depth
    Vector3f color{0, 0, 0};
};

/// Samples in the box of a segment: pixel (x, y) is at (x − box.x0, y − box.y0).
using BackSamples = Image<BackSample>;

/// The mirror image of a segment inside its own silhouette, with normals and colours of the originals. Where several
/// sheets of it cover a pixel, the farthest is kept: that is where the ray of the pixel leaves the object.
[[nodiscard]] BackSamples drawMirrorImage(const SegmentPixels& segment, const MirrorPlane& plane);

/// Number of pixels with a sample.
[[nodiscard]] std::size_t coveredCount(const BackSamples& samples);

/// Closes the gaps in depth and colour by pull-push: averages of ever coarser neighbourhoods. Normals stay zero in the
/// gaps.
void closeGaps(BackSamples& samples);

}  // namespace core::analysis
