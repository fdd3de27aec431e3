// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/selection/selector_state.h"

namespace core {

/// What is known of each superpixel before the cut.
struct SuperpixelPrior {
    std::vector<std::uint8_t> object;  ///< first guess
    std::vector<std::uint8_t> fixed;   ///< keeps its guess: the user pointed at it
};

/// The first guess improved by a minimal cut between superpixels: along strong boundaries, with what looks like the
/// object inside. Colour models are learned from the first guess; they count little where depth is exact. Throws
/// Error(Cancelled).
[[nodiscard]] std::vector<std::uint8_t> cutSuperpixels(const Selector::State& state, const SuperpixelPrior& prior,
                                                       const Progress& progress);

}  // namespace core
