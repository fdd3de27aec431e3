// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/directional_map.h"
#include "core/step_context.h"

namespace core::steps {

/// Sums observations of radiance by direction; the mean of each texel becomes a DirectionalMap.
class DirectionalAccumulator {
  public:
    explicit DirectionalAccumulator(int height)
        : sum_(2 * height, height, Vector3f::Zero()), count_(2 * height, height) {}
    void add(const Vector3f& direction, const Vector3f& radiance);
    /// Adds another accumulator's sums times `scale`, its counts as they are.
    void add(const DirectionalAccumulator& other, const Vector3f& scale);
    [[nodiscard]] const ImageF& count() const { return count_; }
    [[nodiscard]] const ImageRgb& sum() const { return sum_; }
    /// Means where something was observed, zero elsewhere; coverage = number of observations.
    [[nodiscard]] DirectionalMap map() const;

  private:
    ImageRgb sum_;
    ImageF count_;
};

/// Fills texels without coverage by Shepard interpolation on the sphere: the mean of all observed texels weighted by
/// solid angle · n/(n + 1) (n observations) and the inverse cube of their ANGULAR distance, so that neither the seam at
/// U = 0/1 nor the poles show. Far texels are taken in groups (a group is one when it is smaller than 0.35 of its
/// distance), which makes it O(n log n). A map with no observation at all becomes `fallback`. Coverage is not changed.
void fillDirections(DirectionalMap& map, const Vector3f& fallback, const char* stepName, const StepContext& context,
                    float from = 0, float to = 1);

}  // namespace core::steps
