// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/step_context.h"

namespace core::steps {

/// One cell of a membrane: outside it, held at its value, or free to hang between its neighbours.
struct MembraneCell {
    enum class Kind : std::uint8_t { Outside, Free, Fixed };
    float value = 0;
    Kind kind = Kind::Outside;
};

/// Gives the free cells values that satisfy Laplace's equation, without flow through the outside: coarse to fine, each
/// level started from the coarser one, so that the cost is that of the cells whatever the width of a gap. The values
/// of free cells are the start; parts without a fixed cell keep about that. Cancellable between levels; reports
/// `progress` of `step`.
void solveMembrane(Image<MembraneCell>& cells, const char* step, float progress, const StepContext& context);

}  // namespace core::steps
