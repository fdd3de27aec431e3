// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/step.h"
#include "core/analysis/step_context.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Colours as the eye compares them: 8-bit with a square root for the display's curve, red lowest.
[[nodiscard]] Image<std::uint32_t> encodeColor(const ImageRgb& color, const Progress& progress);

/// One pass of `filterDepth`.
struct FilterPass {
    /// One pair of taps, (dx, dy) and (−dx, −dy) [px].
    struct Pair {
        int dx, dy;
        float weight;  ///< relative to the centre's
    };
    std::array<Pair, 12> pairs{};
    int reach = 0;          ///< of the kernel [px]
    NoiseCurve range;       ///< of a pair's residual [1/m]: at this one its weight is a quarter
    float colorFactor = 0;  ///< 1 / (limit of colour differences)²
};

/// The filtered image of inverse depth [1/m], 0 = none, on the CPU.
[[nodiscard]] ImageF runFilterPass(const FilterPass& pass, const ImageF& inverseDepth,
                                   const Image<std::uint32_t>& color, const LabelImage& labels,
                                   const Progress& progress);

/// Edge-avoiding à-trous filter of inverse depth ([DSHL10]): passes of a 5×5 kernel whose taps lie 1, 2, 4, ... pixels
/// apart, so that wide kernels cost little. Taps come in pairs opposite each other about the centre: planes are linear
/// in inverse depth, so a plane of any tilt stays the plane it is. A pair counts by its distance, by its colours'
/// similarity to the centre, and by how far its mean is from the centre; both pixels must be valid and carry the
/// centre's label.
///
/// Automatic: each pass allows for the noise that is left at its scale, measured before it, and the last one is that
/// after which noise tilts a surface by less than a degree; colours do not count where rounding is most of it. Exact
/// depth is returned as it is. Otherwise the passes
/// add up to `spatialSigma`, and colorSigma and depthSigma are the ranges. Invalid pixels (0) stay invalid.
[[nodiscard]] ImageF filterDepth(const ImageF& depth, const ImageRgb& color, const LabelImage& labels,
                                 const Camera& camera, const DepthFilterParams& params, const DepthNoise& noise,
                                 float pixelsPerSample, const StepContext& context);

/// Fills holes inside labelled segments whose every pixel has a valid pixel of the segment within `radius` [px], by a
/// plane through the neighbours. Holes without a label stay distant: they are the background.
void fillSmallHoles(ImageF& depth, const LabelImage& labels, int radius);

/// Gives every labelled pixel a depth when its segment has any: a membrane (Laplace's equation in inverse depth) over
/// the segment's valid pixels, for what `continueDepth` leaves. Sensors miss glossy, dark and thin parts and the strip
/// beside an outline; a pixel that the user marked belongs to its object all the same, and would keep its old material
/// otherwise. Unlabelled pixels stay distant.
void completeSegments(ImageF& depth, const LabelImage& labels, const Progress& progress = {});

}  // namespace core::analysis
