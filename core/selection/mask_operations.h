// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/pixel.h"
#include "core/selection/selection_picture.h"

namespace core {

// Operations on selections. Distances are in pixels between centres, exact; what lies outside the picture is neither
// inside nor outside a selection, so an object that touches the picture's edge is not shrunk there.

/// Adds all pixels within `radius` of the selection.
[[nodiscard]] BinaryMask growMask(const BinaryMask& mask, int radius);
/// Removes all pixels within `radius` of what is not selected.
[[nodiscard]] BinaryMask shrinkMask(const BinaryMask& mask, int radius);
/// Adds the areas that the selection encloses.
[[nodiscard]] BinaryMask fillHoles(const BinaryMask& mask);
/// Rounds off corners and removes specks narrower than about `radius`: a pixel becomes what most of the disc around it
/// is.
[[nodiscard]] BinaryMask smoothMask(const BinaryMask& mask, int radius);
[[nodiscard]] BinaryMask invertMask(const BinaryMask& mask);
/// The 4-connected pieces that contain one of `pixels`.
[[nodiscard]] BinaryMask piecesUnder(const BinaryMask& mask, const std::vector<Pixel>& pixels);

}  // namespace core
