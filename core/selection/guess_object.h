// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/selection/cut_superpixels.h"
#include "core/selection/selector_state.h"

namespace core {

/// Seeds by the superpixels they lie on.
struct SeedLeaves {
    std::vector<std::uint32_t> add, remove;
};
[[nodiscard]] SeedLeaves leavesOf(const Selector::State& state, const SelectionSeeds& seeds);

/// What a seed near the outline says of the pixels around it.
struct CertainDisc {
    Pixel at;            ///< [working px]
    float radius;        ///< [working px]
    std::uint8_t value;  ///< 1 = on the object
};

/// What the seeds mean, before the photograph is asked for the exact outline.
struct ObjectGuess {
    SuperpixelPrior prior;
    std::vector<std::uint8_t> corrected;  ///< by superpixel: belongs to a region that a further seed chose
    std::vector<CertainDisc> discs;
};

/// The region that the first of the added seeds, of which there is at least one, chooses, corrected by the regions that
/// the others choose. A seed close to the outline corrects details only, and at least the disc around it that reaches
/// the outline.
[[nodiscard]] ObjectGuess guessObject(const Selector::State& state, const SelectionSeeds& seeds,
                                      const SeedLeaves& leaves);

}  // namespace core
