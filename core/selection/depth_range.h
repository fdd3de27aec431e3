// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/binary_mask.h"
#include "core/base/pixel.h"
#include "core/base/progress.h"

namespace core {

/// What `selectByDepth` looks for.
enum class DepthShape {
    Range,  ///< depth like that of the seed
    Plane,  ///< on the plane through the seed's surroundings
};

struct DepthSelection {
    DepthShape shape = DepthShape::Range;
    float tolerance = 0.02f;  ///< largest relative deviation |Δz|/z, > 0
    bool connected = true;    ///< only the 4-connected piece with the seed
};

/// The pixels whose depth [m, 0 = none] is that of `seed`, or that lie on its plane. Nothing is selected when the seed
/// has no depth, or no plane fits its surroundings. The plane is fitted to 1/z, which is linear in the picture, and
/// again to all that lies on it. Throws Error(Usage) for a seed outside the picture, and Error(Cancelled).
[[nodiscard]] BinaryMask selectByDepth(const ImageF& depth, Pixel seed, const DepthSelection& wanted,
                                       const Progress& progress = {});

}  // namespace core
