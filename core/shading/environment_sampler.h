// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/directional_map.h"

namespace core {

/// How paths choose their next direction: by the BRDF alone, or combined with sampling of the environment where useful.
enum class LightSampling { Both, BrdfOnly };

/// Draws directions in proportion to the environment's excess over its mean, to find small bright lights; everything
/// else is left to BRDF sampling ("MIS compensation", [KSVK19]). A two-dimensional inverse distribution over cells of
/// the map, uniform in solid angle inside a cell.
class EnvironmentSampler {
  public:
    /// Longest side of the table; larger maps are sampled in cells of several texels.
    static constexpr int kMaxColumns = 1024;
    /// Minimum share of all light that must exceed the mean for the sampler to pay for its cost.
    static constexpr double kMinShare = 0.1;

    /// Nothing to sample.
    EnvironmentSampler() = default;
    explicit EnvironmentSampler(const DirectionalMap& map);

    /// True for an environment that is dark, or smooth enough for BRDF sampling alone.
    [[nodiscard]] bool empty() const { return table_.empty(); }

    struct Sample {
        Vector3f direction;  ///< unit
        float pdf = 0;       ///< [1/sr]
    };
    /// From two uniform numbers in [0, 1). Not for an empty sampler.
    [[nodiscard]] Sample sample(float u, float v) const;
    /// Density of `sample` at a unit direction [1/sr]; 0 for an empty sampler.
    [[nodiscard]] float pdf(const Vector3f& d) const;

    /// Density per texel of the map [1/sr]; empty for an empty sampler.
    [[nodiscard]] const ImageF& density() const { return density_; }
    /// rows() + 1 cumulative probabilities of rows, then columns() + 1 of the cells of each row.
    [[nodiscard]] std::span<const float> table() const { return table_; }
    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    /// Texels of the map along a cell's side; the last cells may be smaller.
    [[nodiscard]] int cellSize() const { return cellSize_; }
    /// Mean luminance of the map, weighted by solid angle: an estimate of the light from surfaces that paths meet.
    [[nodiscard]] float meanLuminance() const { return meanLuminance_; }

  private:
    ImageF density_;
    std::vector<float> table_;
    int columns_ = 0;
    int rows_ = 0;
    int cellSize_ = 1;
    float meanLuminance_ = 0;
};

}  // namespace core
