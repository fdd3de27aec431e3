// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// One cell of a grid: outside the membrane, fixed, or free up to `most`.
struct MembraneCell {
    enum class Kind : std::uint8_t { Outside, Free, Fixed };
    float value = 0;
    Kind kind = Kind::Outside;
    float most = std::numeric_limits<float>::infinity();
};

/// Gives the free cells values that satisfy Laplace's equation, or the obstacle problem where `most` holds them down,
/// with no flux across its edge. Solved from coarse to fine, each level starting from the coarser one, so that the
/// cost depends on the number of cells and not on the width of a gap. The values of free cells are the initial guess;
/// parts without a fixed cell stay close to it. Cancellable.
void solveMembrane(Image<MembraneCell>& cells, const Progress& progress);

}  // namespace core::analysis
