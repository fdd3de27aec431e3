// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/light/lobe_system.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// Raises every highlight of `light` (neighbouring texels whose observations were all clipped) by the light its tails
/// indicate: a lobe spreads it over unclipped observations around, whose excess over their surroundings gives its
/// energy. The largest highlights only.
void recoverHighlights(DirectionalMap& light, std::span<const LobeObservations> sources, const StepContext& context);

}  // namespace core::analysis
