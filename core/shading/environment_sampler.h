// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/directional_map.h"

namespace core {

/// Where paths go on: by the surface's BRDF alone, or combined with the environment's own sampling where that pays.
enum class LightSampling { Both, BrdfOnly };

/// Draws directions in proportion to how much brighter than the mean an environment is there, so that small bright
/// lights are found by more than chance; everything else is left to the sampling of the surface's BRDF ("MIS
/// compensation", [KSVK19]). A two-dimensional inverse distribution over cells of the map, uniform in solid angle
/// inside a cell.
class EnvironmentSampler {
  public:
    /// Longest side of the table; larger maps are sampled in cells of several texels.
    static constexpr int kMaxColumns = 1024;
    /// Least share of all light that has to be brighter than the mean for the sampler to be worth its cost.
    static constexpr double kLeastShare = 0.1;

    /// Nothing to sample.
    EnvironmentSampler() = default;
    explicit EnvironmentSampler(const DirectionalMap& map);

    /// True for an environment that is dark, or smooth enough to be met by chance.
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
    /// Mean luminance of the map, weighted by solid angle: what light may be expected from things that are met.
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
