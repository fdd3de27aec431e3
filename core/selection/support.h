// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/camera.h"
#include "core/base/progress.h"
#include "core/selection/superpixels.h"

namespace core {

/// A large plane that everything else stands in front of: a table, a floor, a wall.
struct SupportPlane {
    Vector3f normal;  ///< unit length, facing the camera
    float offset;     ///< normal · p for its points [m]
};

inline constexpr int kNoSupport = -1;
inline constexpr int kDistant = -2;  ///< without depth because it is far behind everything

struct Supports {
    std::vector<SupportPlane> planes;  ///< the largest first
    std::vector<int> planeOf;          ///< by superpixel: index of its plane, kNoSupport or kDistant
};

/// Planes that hold at least a twelfth of the picture's depth and have little behind them. Deterministic. Throws
/// Error(Cancelled).
[[nodiscard]] Supports findSupports(const Superpixels& superpixels, const Camera& camera, const DepthQuality& quality,
                                    const Progress& progress);

}  // namespace core
