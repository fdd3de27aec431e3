// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/step_context.h"
#include "core/base/directional_map.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Sums observations of radiance by direction; the weighted mean of each texel becomes a DirectionalMap.
class DirectionalAccumulator {
  public:
    explicit DirectionalAccumulator(int height);
    /// `weight` in (0, 1]: how much is known of the direction. `clipped`: bit c = the camera clipped channel c, which
    /// then only counts where no observation of it is unclipped.
    void add(const Vector3f& direction, const Vector3f& radiance, float weight = 1, unsigned clipped = 0);
    /// Means where something was observed, zero elsewhere; coverage = sum of weights.
    [[nodiscard]] DirectionalMap map() const;

  private:
    ImageRgb sum_;
    ImageRgb weight_;  ///< per channel
    ImageF total_;
    Image<std::uint8_t> clipped_;  ///< as in DirectionalMap; 7 where nothing was observed
};

/// Fills texels without coverage; coverage is not changed, a map with no observation at all becomes `fallback`.
///
/// Shepard ([BRD14] 3.3): the mean of all observed texels weighted by solid angle · n/(n + 1) (n observations) and the
/// inverse cube of their ANGULAR distance, so that neither the seam at U = 0/1 nor the poles show. Far texels are taken
/// in groups (a group is one when it is smaller than a fifth of its distance), which makes it O(n log n).
///
/// Membrane: Laplace's equation on the sphere for the logarithm of radiance, with the observed texels as its boundary:
/// as smooth as can be, and a sun at the edge of what was observed does not spread over what was not.
void fillDirections(DirectionalMap& map, EnvironmentFill method, const Vector3f& fallback, const StepContext& context);

/// Fills texels without coverage by the user's map, drawn towards what was observed beside it over about
/// ten degrees, so that no edge shows. Same size. Coverage is not changed;
/// progress stays at `fraction`.
void completeDirections(DirectionalMap& map, const ImageRgb& user, const StepContext& context);

}  // namespace core::analysis
