// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/step_context.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Colours on a roughly perceptual scale: 8 bits per channel with a square root for the display's curve, red lowest.
[[nodiscard]] Image<std::uint32_t> encodeColor(const ImageRgb& color, const Progress& progress);

/// One pass of `filterDepth`.
struct FilterPass {
    /// One pair of taps, (dx, dy) and (−dx, −dy) [px].
    struct Pair {
        int dx, dy;
        float weight;  ///< relative to the centre's
    };
    std::array<Pair, 12> pairs{};
    int reach = 0;          ///< [px] half-width of the kernel
    NoiseCurve range;       ///< [1/m] residual of a pair at which its weight is a quarter
    float colorFactor = 0;  ///< 1 / (limit of colour differences)²
};

/// The filtered image of inverse depth [1/m], 0 = none, on the CPU.
[[nodiscard]] ImageF runFilterPass(const FilterPass& pass, const ImageF& inverseDepth,
                                   const Image<std::uint32_t>& color, const LabelImage& labels,
                                   const Progress& progress);

/// Edge-avoiding à-trous filter of inverse depth ([DSHL10]): passes of a 5×5 kernel whose taps lie 1, 2, 4, ... pixels
/// apart, so that wide kernels cost little. Taps come in pairs on opposite sides of the centre: planes are linear in
/// inverse depth, so a plane of any tilt is preserved. The weight of a pair depends on its distance, on the similarity
/// of its colours to the centre's and on the difference of its mean from the centre. Both of its pixels must be valid
/// and carry the centre's label.
///
/// Automatic: the range of each pass follows the noise that remains at its scale, measured before it. Passes stop once
/// the remaining noise tilts a surface by hardly more than a degree at a spacing beyond its correlation, after five
/// passes (three for an enlarged map) at the latest. Colours are ignored where the noise is mostly rounding.
/// Exact depth is returned unchanged. Custom: the passes add up to `spatialSigma`, and `colorSigma` and `depthSigma`
/// are the ranges. Invalid pixels (0) stay invalid. `params.enabled` is the caller's business.
[[nodiscard]] ImageF filterDepth(const ImageF& depth, const Photo& photo, const DepthFilterParams& params,
                                 const DepthNoise& noise, const StepContext& context);

}  // namespace core::analysis
