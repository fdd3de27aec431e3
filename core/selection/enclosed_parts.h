// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/pixel.h"
#include "core/selection/selection_picture.h"

namespace core {

/// Adds to `mask` (working resolution) small areas that it encloses and that depth does not tell from it: highlights,
/// prints, collars. Where the depth map's edges lie on the photograph's, an area without depth is far away. Areas with
/// one of the pixels `excluded` stay.
void takeEnclosed(const SelectionPicture& picture, const std::vector<Pixel>& excluded, BinaryMask& mask);

}  // namespace core
