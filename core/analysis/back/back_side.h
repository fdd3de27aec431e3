// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/step.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// Invents the back of everything with valid depth: z_back ≥ z_front + minThickness in every pixel.
/// - Offset: the front, moved back by `offset` along the ray of its pixel.
/// - ParallelMirror: `parallelMirrorPlane`. PcaMirror: `mirrorAxis`, `fitMirrorPlane`. Both `drawMirrorImage`.
/// - SpannedMirror: `mirrorAtSpannedSurface`.
/// - FlatFaces: `continueFlatFaces`.
/// - Automatic: SpannedMirror or FlatFaces, whichever has the lower penalty: the part of the outline that contradicts
///   the method's idea of how the front ends there, or of the front that lies behind it. When nothing of the outline is
///   seen, the mirror plane with the lower E.
/// `planeShift` moves the mirror and `thicknessScale` stretches the result; then what would reach through the plane
/// that the segment stands on ends there (`fitSupportPlane`). Mirror images keep normals and colours of their
/// originals. A method that fails (a support, few points, no axis, E > 0.6, an image covering less than a fifth, no
/// flat face) falls back to Offset and says so. Pixels without a label are solids of a tenth of their distance.
/// `userDepth`, where given and positive, replaces all of this.
[[nodiscard]] BackLayer inventBackSide(const Camera& camera, const LabelImage& labels, const Surface& front,
                                       std::span<const Segment> segments, const ImageF* userDepth, float relativeNoise,
                                       const StepContext& context);

}  // namespace core::analysis
