// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/selection/selector.h"

namespace core {

/// `base` changed by pointing: what lies under seeds that remove is taken out, then the object under the others is put
/// in. `base` has the photograph's size, or is empty: nothing was selected before. Errors as in Selector::select.
[[nodiscard]] BinaryMask selectFrom(const Selector& selector, const BinaryMask& base, const SelectionSeeds& seeds,
                                    const Progress& progress = {});

}  // namespace core
