// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/material/diffusion_profile.h"
#include "core/scene/scene.h"
#include "shaders/shared/diffusion.h"

namespace core {

// The sum of R_d over all surface samples by sparse grids in space, after multilevel summation ([HWPS15]).
//
// Level l has cubic cells of width h_l = 2^l h_0. Each sample spreads its light over the cells around it with the
// quadratic B-spline of that width, and each pixel reads them with the same spline. Without smoothing, a sample thus
// reaches a pixel through the convolution of the splines, nearly a Gaussian of variance h_l²/2. Smoothing the cells n
// times with [1 4 1]/6, whose fourth cumulant is zero, adds n h_l²/3 and removes the dependence on the grid's position.
// R_d is a sum of such Gaussians, two for each level (fitDiffusionKernel). Since coarse B-splines are exact sums of
// fine ones, samples and pixels use the finest grid only, connected by a pyramid:
//
//   light_0 = samples;  light_{l+1} = restrict light_l                       (once for each light)
//   narrow_l = S² light_l,  wide_l = S⁴ light_l
//   sum_l = a_l narrow_l + b_l wide_l + prolong sum_{l+1}                    (again for each profile)
//   pixel = sum_f read at its point,  f = the finest level the profile needs
//
// The areas of the samples are summed in the same way. A pixel's sum of area is the result for an irradiance of 1
// everywhere; light is divided by it (diffusion_exitance), so that the uneven density of the samples is invisible and
// no body reflects more than it receives.
//
// The work is proportional to samples + pixels, independent of how far light spreads.

/// Width of the finest cells relative to the distance between samples; determines accuracy and cost.
[[nodiscard]] double cellsPerSpacing(DiffusionQuality quality);

// Smoothing steps of the narrow and the wide Gaussian.
inline constexpr int kNarrowSteps = 2;
inline constexpr int kWideSteps = 4;

/// Bricks of all levels, and which of them samples and pixels use.
struct DiffusionGrid {
    struct Level {
        std::uint32_t first = 0;   ///< brick
        std::uint32_t count = 0;   ///< bricks
        std::uint32_t wanted = 0;  ///< leading bricks that pixels read, directly or from finer levels
        std::uint32_t near = 0;    ///< leading bricks: `wanted` and those that smoothing reads around them
    };
    std::array<double, 3> corner{};          ///< [m], in the grids' axes; origin of cell (0, 0, 0) of every level
    double cell = 0;                         ///< width of the finest level's cells [m]
    double spacing = 0;                      ///< distance between samples the grid was made for [m]
    double diameter = 0;                     ///< largest distance between points, at most [m]
    std::vector<Level> levels;               ///< finest first; at least one
    std::vector<kernel::uint> words;         ///< all bricks, see DIFFUSION_BRICK_*; the first brick is empty
    std::vector<kernel::vec4> places;        ///< per sample: place in finest cells; w is left 0
    std::vector<kernel::uint> sampleStarts;  ///< per brick of the finest level, and one more: range of `samples`
    std::vector<kernel::uint> samples;       ///< indices of the samples that reach into a brick
    std::vector<kernel::uvec2> pixels;       ///< x | y << 16, and the brick of the finest level it is in

    [[nodiscard]] std::uint32_t brickCount() const {
        return static_cast<std::uint32_t>(words.size() / DIFFUSION_BRICK_WORDS);
    }
    [[nodiscard]] double cellOf(std::size_t level) const { return cell * static_cast<double>(1U << level); }
};

/// Grids for samples at `positions`, which stand for squares of side `spacing` [m] each, and the pixels of `label` with
/// valid depth. Cells become wider than `quality` requests when there would be more than kMaxDiffusionBricks.
[[nodiscard]] DiffusionGrid buildDiffusionGrid(std::span<const Vector3f> positions, double spacing,
                                               const LabelImage& labels, const ImageF& depth, const ImageV3& position,
                                               std::uint16_t label, DiffusionQuality quality,
                                               const Progress& progress = {});

inline constexpr std::uint32_t kMaxDiffusionBricks = 60000;

/// Exitance of a flat surface for an irradiance of 1, per channel.
struct FlatSurface {
    Vector3f integral = Vector3f::Zero();   ///< of the profile
    Vector3f tolerance = Vector3f::Zero();  ///< deviation explained by the spread of samples (DiffusionProfile)

    /// Exitance from the samples' sum and from their sum for an irradiance of 1 (kernel::diffusion_exitance).
    [[nodiscard]] Vector3f exitance(const Eigen::Vector3d& sum, const Eigen::Vector3d& whole) const;
};
[[nodiscard]] FlatSurface flatSurface(const DiffusionProfile& profile);

/// Contribution of each level to R_d.
struct DiffusionKernel {
    std::vector<Vector3f> narrow, wide;  ///< per level [1/m²]: weight of the light smoothed twice, four times
    FlatSurface flat;
    std::size_t finest = 0;  ///< first level that is needed; weights of finer ones are zero
};

/// Weights for which the grids' Gaussians approximate `profile`, by least squares over the light of rings around a
/// point.
[[nodiscard]] DiffusionKernel fitDiffusionKernel(const DiffusionProfile& profile, const DiffusionGrid& grid);

/// R_d of the kernel at squared distance `r2` [m²], the mean over all places of the grid.
[[nodiscard]] std::array<double, 3> evaluateKernel(const DiffusionKernel& kernel, const DiffusionGrid& grid, double r2);

}  // namespace core
