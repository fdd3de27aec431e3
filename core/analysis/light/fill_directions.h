// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/step_context.h"
#include "core/base/directional_map.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Fills texels without coverage; coverage is not changed, a map with no observation at all becomes `fallback`.
///
/// Shepard ([BRD14] 3.3): the mean of all observed texels weighted by solid angle · n/(n + 1) (n observations) and the
/// inverse cube of their ANGULAR distance, so that neither the seam at U = 0/1 nor the poles show (`DirectionTree`).
///
/// Membrane: Laplace's equation on the sphere for the logarithm of radiance, with the observed texels as its boundary
/// (`solveSphereMembrane`): as smooth as possible, and a sun at the edge of the observed region does not spread over
/// the rest.
void fillDirections(DirectionalMap& map, EnvironmentFill method, const Vector3f& fallback, const StepContext& context);

/// Fills texels without coverage by the user's map, drawn towards the observations beside it over about ten degrees,
/// so that no edge shows. Both maps have the same size. Coverage is not changed.
void completeDirections(DirectionalMap& map, const ImageRgb& user, const StepContext& context);

}  // namespace core::analysis
