// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/analysis/analysis.h"
#include "core/analysis/step.h"
#include "core/base/camera.h"
#include "core/base/progress.h"

namespace core::analysis {

/// Which side of a solid a depth map shows: decides the sign of its normals.
enum class Side { Front, Back };

/// Everything besides depth that the normals of a surface depend on.
struct SurfaceInput {
    const Camera& camera;
    const LabelImage& labels;
    Side side = Side::Front;
    float relativeNoise = 0;         ///< standard deviation of the depth divided by it; 0 = exact
    const ImageV3* known = nullptr;  ///< normals that are used as they are where not zero; nullptr = none
};

/// Computes normals, positions and patch areas of a surface from its depth. Zero where there is no depth.
///
/// Normals come from a robust fit of a plane in inverse depth, w = a + gu·Δu + gv·Δv, around every pixel. Neighbours of
/// other segments have no weight, and neither have those that deviate from the slope on the pixel's smoother side by
/// more than the noise and, in proportion to their distance, a pixel's footprint explain: fits stop at discontinuities
/// and are one-sided beside them. The window is 3×3 on exact depth and 5×5 otherwise.
void computeSurface(const SurfaceInput& input, Surface& surface, const Progress& progress);

/// One neighbour of the fit.
struct NormalTap {
    int dx, dy;          ///< [px]
    float weight;        ///< by distance
    float inverseLimit;  ///< 1 / (smallest residual without weight), relative to the centre
};
/// The window of the fit: 9 or 25 taps.
[[nodiscard]] std::vector<NormalTap> normalTaps(const Camera& camera, float relativeNoise);

/// Area [m²] of a pixel's quad back-projected on the tangent plane: A = z³/(fx·fy·|n·p|) (docs/method.md#depth). The
/// angle of view is limited to about 89 degrees, so that one grazing pixel cannot outweigh a segment.
[[nodiscard]] float patchArea(const Camera& camera, const Vector3f& position, const Vector3f& normal);

}  // namespace core::analysis
