// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis.h"
#include "core/camera.h"
#include "core/steps/step.h"

namespace core::steps {

/// Which side of a solid a depth map shows: decides the sign of its normals.
enum class Side { Front, Back };

/// Normals by a robust fit of a plane in inverse depth, w = a + gu·Δu + gv·Δv, around every pixel. Neighbours of other
/// segments do not count, nor do those that depart from the slope on the pixel's smoother side by more than a pixel's
/// footprint: fits stop at discontinuities and are one-sided beside them. The window is 3×3 on exact depth
/// (`relativeNoise` = 0), else 5×5. Zero where there is no depth.
[[nodiscard]] ImageV3 computeNormals(const Camera& camera, const ImageF& depth, const LabelImage& labels, Side side,
                                     float relativeNoise, const char* stepName, const StepContext& context,
                                     float from = 0, float to = 1);

/// Area [m²] of a pixel's quad back-projected on the tangent plane: A = z³/(fx·fy·|n·p|) (DESIGN 3.1). The angle of
/// view is limited to about 89 degrees, so that one grazing pixel cannot outweigh a segment.
[[nodiscard]] float patchArea(const Camera& camera, const Vector3f& position, const Vector3f& normal);

/// Fills positions and areas from depth and normals.
void completeSurface(const Camera& camera, Surface& surface);

}  // namespace core::steps
