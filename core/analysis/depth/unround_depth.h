// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// Rounding of a stored depth map: a constant step of inverse depth (disparity) or of depth itself.
struct DepthRounding {
    float step = 0;          ///< [1/m] of inverse depth or [m] of depth, > 0
    bool ofInverse = false;  ///< the step is one of inverse depth

    /// Step [1/m] of inverse depth at inverse depth `w` [1/m].
    [[nodiscard]] float inverseStep(float w) const { return ofInverse ? step : step * w * w; }
};

/// Finds the rounding of a map [m], 0 = invalid, at its own resolution, from its values: few different ones, nearly all
/// of whose distances are whole multiples of one. nullopt when there are more than 1024 or nearly as many as pixels,
/// as in exact, computed and finely rounded maps.
[[nodiscard]] std::optional<DepthRounding> findDepthRounding(const ImageF& depth);

/// Replaces coarsely rounded depth [m] by a smooth surface that rounds to the same values: inverse depth bends as
/// little as possible, while each pixel stays within half a step of what is stored. Second differences beyond a few
/// steps are edges and folds, and lose their weight (Geman and McClure). Planes stay planes, invalid pixels (0)
/// invalid. A map without coarse rounding (`findDepthRounding`) is returned unchanged. Cancellable.
[[nodiscard]] ImageF unroundDepth(const ImageF& depth, const Progress& progress = {});

}  // namespace core::analysis
