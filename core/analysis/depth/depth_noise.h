// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// A standard deviation of inverse depth [1/m] as a function of inverse depth, linear between cells. Plain data:
/// kernels read it as it is.
struct NoiseCurve {
    static constexpr int kCells = 16;
    float first = 0;         ///< inverse depth of cell 0 [1/m]
    float cellsPerUnit = 0;  ///< cells per 1/m
    std::array<float, kCells> sigma{};

    [[nodiscard]] float at(float inverseDepth) const {
        const float cell = std::clamp((inverseDepth - first) * cellsPerUnit, 0.0f, static_cast<float>(kCells - 1));
        const int i = std::min(static_cast<int>(cell), kCells - 2);
        const float t = cell - static_cast<float>(i);
        return (1 - t) * sigma[static_cast<std::size_t>(i)] + t * sigma[static_cast<std::size_t>(i) + 1];
    }
};

/// Errors of a measured depth map.
struct DepthNoise {
    NoiseCurve deviation;         ///< σ of inverse depth, all scales together
    bool quantised = false;       ///< the noise is mostly steps between neighbouring stored values
    float correlationLength = 1;  ///< [px] pixels farther apart than this err independently
    float relative = 0;           ///< σ(z)/z at the median depth; 0 = exact
};

/// Which differences of inverse depth w along rows and columns: w(−s) − 2w(0) + w(s), which vanish on planes, or
/// w(−2s) − 4w(−s) + 6w(0) − 4w(s) + w(2s), which also vanish where curvature changes little.
enum class Differences { Second, Fourth };

/// Noise visible in differences at a spacing of `step` pixels inside one segment, as the σ of uncorrelated values with
/// such differences. Takes the median over small blocks, and among blocks at similar depth the smoothest fifth, so
/// that edges and relief do not count as long as something in the picture is smooth. 0 where there were too few
/// differences.
[[nodiscard]] NoiseCurve measureNoise(const ImageF& inverseDepth, const LabelImage& labels, int step, Differences order,
                                      const Progress& progress);

/// Noise in fourth differences at steps of 1, 2, 4, 8 and 16 times the spacing of depth samples (`Photo`); enlarged
/// maps without rounding at 32 times, too. Uncorrelated noise is the same at all of them, correlated noise grows until
/// the step passes its correlation length, and relief grows without end: what levels off is noise. Quantisation, which
/// may be invisible in differences, counts as a deviation of step/√12.
[[nodiscard]] DepthNoise estimateDepthNoise(const ImageF& inverseDepth, const LabelImage& labels,
                                            float depthSampleSpacing, const Progress& progress);

/// σ(z)/z at the median depth; 0 without valid depth.
[[nodiscard]] float relativeNoise(const NoiseCurve& deviation, const ImageF& inverseDepth);

/// `Photo::depthSampleSpacing` in whole pixels, at least 1.
[[nodiscard]] int wholeSpacing(float depthSampleSpacing);

/// 1/z of every valid pixel, 0 elsewhere.
[[nodiscard]] ImageF inverseOf(const ImageF& depth);

}  // namespace core::analysis
