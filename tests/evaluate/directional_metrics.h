// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/directional_map.h"

namespace evaluate {

/// Error of the luminance of recovered light over a set of directions. Every mean is weighted by solid angle. NaN for
/// an empty set.
struct DirectionalError {
    double share = 0;        ///< solid angle of the set relative to the sphere
    double medianError = 0;  ///< median of |L/L_true − 1|
    double blurredRmse = 0;  ///< RMSE relative to the true mean, both maps blurred by a Gaussian, σ = 10°
    double meanRatio = 0;    ///< mean relative to the true mean
};

struct EnvironmentError {
    DirectionalError observed;  ///< directions with coverage
    DirectionalError filled;    ///< directions without
};

/// Area averages of a latitude-longitude map on a grid of `height` rows, solid-angle weighted.
[[nodiscard]] core::ImageRgb resampledMap(const core::ImageRgb& map, int height);

/// Convolution on the sphere with a Gaussian of the angular distance, `sigma` in radians. Visits all pairs of texels:
/// for maps of a few dozen rows.
[[nodiscard]] core::ImageRgb blurredMap(const core::ImageRgb& map, double sigma);

/// `truth`: latitude-longitude radiance of any size, camera frame.
[[nodiscard]] EnvironmentError compareEnvironment(const core::DirectionalMap& map, const core::ImageRgb& truth);

}  // namespace evaluate
