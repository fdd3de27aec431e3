// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/pixel.h"
#include "core/base/progress.h"
#include "core/selection/selection_picture.h"

namespace core {

/// A selection enlarged to the size of `lab`, with its outline moved to where the colour changes: the cheapest closed
/// line within `radius` pixels of `mask`, each of which covers `factor`² pixels of `lab`, between colours that resemble
/// what is beside it on both sides. Parts of the selection and gaps in it that are narrower than this band, and the
/// pixels `fixed` of `mask` (none where empty), stay. Throws Error(Cancelled).
[[nodiscard]] BinaryMask refineOutline(const BinaryMask& mask, const Image<PackedLab>& lab, int factor, int radius,
                                       const BinaryMask& fixed, const Progress& progress);

}  // namespace core
