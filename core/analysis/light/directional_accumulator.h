// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "core/base/directional_map.h"

namespace core::analysis {

/// Angle [rad] between the centres of neighbouring texels of one column.
[[nodiscard]] inline float texelAngle(int rows) { return std::numbers::pi_v<float> / static_cast<float>(rows); }

/// Sums observations of radiance by direction; the weighted mean of each texel becomes a DirectionalMap.
class DirectionalAccumulator {
  public:
    /// A map of `rows` rows and twice as many columns.
    explicit DirectionalAccumulator(int rows);
    /// `weight` in (0, 1]: confidence in the direction. Bit c of `clipped`: the camera clipped channel c; such an
    /// observation only counts where no other observation of that channel is unclipped.
    void add(const Vector3f& direction, const Vector3f& radiance, float weight = 1, unsigned clipped = 0);
    /// Means where something was observed, zero elsewhere; coverage = sum of weights.
    [[nodiscard]] DirectionalMap map() const;

  private:
    ImageRgb sum_;
    ImageRgb weight_;  ///< per channel
    ImageF total_;
    Image<std::uint8_t> clipped_;  ///< as in DirectionalMap; 7 where nothing was observed
};

}  // namespace core::analysis
