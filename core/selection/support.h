// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/camera.h"
#include "core/base/progress.h"
#include "core/selection/superpixels.h"

namespace core {

inline constexpr int kNoSupport = -1;
inline constexpr int kDistant = -2;  ///< without depth because it is far behind everything

/// By superpixel: the number of the support it lies on, the largest 0, or kNoSupport or kDistant. Supports are large
/// planes that everything else stands in front of (a table, a floor, a wall): they hold at least a twelfth of the
/// picture's depth and have little behind them. Deterministic. Throws Error(Cancelled).
[[nodiscard]] std::vector<int> findSupports(const Superpixels& superpixels, const Camera& camera,
                                            const DepthQuality& quality, const Progress& progress);

}  // namespace core
