// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>

namespace core {

// Weights of robust fits: 1 for a residual of 0, falling as it grows. `squared` is the squared residual in units of the
// estimator's scale.

/// Weight of Geman and McClure's estimator: 1/(1 + r²)². Never reaches 0.
template <std::floating_point T>
[[nodiscard]] T gemanMcClure(T squared) {
    return 1 / ((1 + squared) * (1 + squared));
}

/// Tukey's biweight: (1 − r²)², 0 from r = 1 on.
template <std::floating_point T>
[[nodiscard]] T biweight(T squared) {
    const T rest = std::max(1 - squared, T{0});
    return rest * rest;
}

}  // namespace core
