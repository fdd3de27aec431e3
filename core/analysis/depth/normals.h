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

/// What a surface's normals are fitted to, besides its depth.
struct SurfaceInput {
    const Camera& camera;
    const LabelImage& labels;
    Side side = Side::Front;
    float relativeNoise = 0;         ///< of the depth, standard deviation divided by depth; 0 = exact
    const ImageV3* known = nullptr;  ///< normals that are taken as they are where not zero; nullptr = none
};

/// Fills normals, positions and patch areas of a surface that has its depth. Zero where there is no depth.
///
/// Normals by a robust fit of a plane in inverse depth, w = a + gu·Δu + gv·Δv, around every pixel. Neighbours of other
/// segments do not count, nor do those that depart from the slope on the pixel's smoother side by more than a pixel's
/// footprint: fits stop at discontinuities and are one-sided beside them. The window is 3×3 on exact depth, else 5×5.
void computeSurface(const SurfaceInput& input, Surface& surface, const Progress& progress);

/// One neighbour of the fit.
struct NormalTap {
    int dx, dy;          ///< [px]
    float weight;        ///< by distance
    float inverseLimit;  ///< 1 / residual relative to the centre that no longer counts
};
/// The fit's window: 9 or 25 taps.
[[nodiscard]] std::vector<NormalTap> normalTaps(const Camera& camera, float relativeNoise);

/// Area [m²] of a pixel's quad back-projected on the tangent plane: A = z³/(fx·fy·|n·p|) (docs/method.md#depth). The
/// angle of view is limited to about 89 degrees, so that one grazing pixel cannot outweigh a segment.
[[nodiscard]] float patchArea(const Camera& camera, const Vector3f& position, const Vector3f& normal);

}  // namespace core::analysis
