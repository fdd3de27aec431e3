// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/image.h"

namespace core {

/// A selection of pixels: 1 = selected, 0 = not.
using BinaryMask = Image<std::uint8_t>;

/// What a new selection does to an old one.
enum class MaskUse { Replace, Add, TakeFrom, Intersect };

/// `old` changed by `mask`, which has the same size; an empty `old` has nothing selected.
[[nodiscard]] BinaryMask combineMasks(const BinaryMask& old, const BinaryMask& mask, MaskUse use);

}  // namespace core
