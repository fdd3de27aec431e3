// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/pointing.h"

namespace core {

BinaryMask selectFrom(const Selector& selector, const BinaryMask& base, const SelectionSeeds& seeds,
                      const Progress& progress) {
    const BinaryMask object = selector.select(seeds, progress.part(0, 0.5f));
    if (base.empty()) return object;
    const BinaryMask removed = selector.select({.add = seeds.remove, .remove = seeds.add}, progress.part(0.5f, 1));
    return combineMasks(combineMasks(base, removed, MaskUse::TakeFrom), object, MaskUse::Add);
}

}  // namespace core
