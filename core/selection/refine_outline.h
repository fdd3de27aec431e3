// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/pixel.h"
#include "core/base/progress.h"
#include "core/selection/selection_picture.h"

namespace core {

/// Moves the outline of a selection, by at most `radius` pixels, to where the colour changes: the
/// cheapest closed line within that band. Pixels of `fixed` keep their value.
/// Throws Error(Cancelled).
void refineOutline(BinaryMask& mask, const Image<PackedLab>& lab, int radius, const std::vector<Pixel>& fixed,
                   const Progress& progress);

}  // namespace core
