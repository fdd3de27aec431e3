// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/analysis.h"

const core::Reflectance* core::Analysis::findReflectance(std::uint16_t label) const {
    for (const auto& reflectance : reflectances)
        if (reflectance->label == label) return reflectance.get();
    return nullptr;
}
