// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/step_context.h"
#include "core/base/directional_map.h"

namespace core::analysis {

/// Radiance of distant light seen through a lobe: one glossy segment's missed rays divided by its ρ, or, with α = 0,
/// the light itself.
struct LobeObservations {
    DirectionalMap map;      ///< radiance after the lobe; coverage = weight of the observations, 0 = none
    float alpha = 0;         ///< GGX width of the lobe
    Vector3f view{0, 0, 1};  ///< unit, from the camera to what shows it
    float confidence = 1;    ///< of this source against the others, (0, 1]

    /// Bit c: channel c of a texel was clipped.
    [[nodiscard]] unsigned clippedChannels(std::size_t texel) const {
        return map.clipped.empty() ? 0u : map.clipped[texel];
    }
};

/// Sharpens `light` until it explains all observations: Richardson-Lucy iterations on the sphere, with every source's
/// own lobe (half vectors about the normal that mirrors `view` into the texel) and its weights. Positive by
/// construction; few iterations, because more would sharpen the noise. A clipped observation only says "at least this".
///
/// Then every highlight (neighbouring texels whose observations were all clipped) is raised by what its tails need: a
/// lobe spreads it over unclipped observations around, and these tell how much energy it has. Only texels of `light`
/// with coverage change; maps of more than 512 rows are left as they are.
void deconvolve(DirectionalMap& light, std::span<const LobeObservations> sources, const StepContext& context);

}  // namespace core::analysis
