// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/light/lobe_system.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// Sharpens `light` until it explains all observations: Richardson-Lucy iterations on the sphere, with every source's
/// own lobe (half vectors about the normal that mirrors `view` into the texel) and its weights. Positive by
/// construction; few iterations, because more would sharpen the noise. A clipped observation is only a lower bound.
///
/// Then `recoverHighlights` raises what the camera clipped. Only texels of `light` with coverage change; maps of more
/// than 512 rows are left as they are.
void deconvolve(DirectionalMap& light, std::span<const LobeObservations> sources, const StepContext& context);

}  // namespace core::analysis
