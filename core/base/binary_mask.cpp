// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/binary_mask.h"

namespace core {

BinaryMask combineMasks(const BinaryMask& old, const BinaryMask& mask, MaskUse use) {
    CORE_ASSERT(old.empty() || old.sameSize(mask), "selections of one photograph");
    if (use == MaskUse::Replace || (old.empty() && use == MaskUse::Add)) return mask;
    BinaryMask result = old.empty() ? BinaryMask(mask.width(), mask.height()) : old;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const bool before = result[i] != 0, chosen = mask[i] != 0;
        const bool after = use == MaskUse::Add        ? before || chosen
                           : use == MaskUse::TakeFrom ? before && !chosen
                                                      : before && chosen;
        result[i] = after ? 1 : 0;
    }
    return result;
}

}  // namespace core
