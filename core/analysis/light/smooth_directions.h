// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/directional_map.h"

namespace core::analysis {

/// Averages observed radiance over about a Gaussian of standard deviation `sigma` [rad] (two box filters along either
/// axis of the map, widened towards the poles), weighted by coverage and solid angle. Only texels with coverage change,
/// coverage does not. What the camera clipped is no longer told apart.
void smoothDirections(DirectionalMap& map, float sigma);

/// How far apart [rad] observations have to be averaged before they agree with each other. `one` and `other` are made
/// of different pixels of one segment: where both know a direction, a mirror with true normals shows the same light in
/// both, and smoothing can only worsen how one predicts the other; wrong normals or a texture make them disagree. The
/// least width whose error of prediction, mean |a − b|/(a + b), is within 1 % of the best; 0 = as they are, also where
/// they have less than `kMinSharedSolidAngle` in common.
[[nodiscard]] float agreementWidth(const DirectionalMap& one, const DirectionalMap& other);

inline constexpr double kMinSharedSolidAngle = 0.05;  ///< [sr]

}  // namespace core::analysis
