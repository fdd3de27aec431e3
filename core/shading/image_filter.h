// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/geometry/surface.h"

namespace core {

/// Running sums of the re-shaded radiance. The filter estimates the noise from the second moment.
struct Accumulation {
    ImageRgb sum;
    ImageF sumSquaredLuminance;
    int samples = 0;
    std::uint64_t dropped = 0;  ///< samples that were not finite; 0 unless something is wrong
};

/// Edge-aware filter of the re-shaded radiance ([DSHL10], guided by the noise as in [SKW+17]).
///
/// An à-trous B3-spline pyramid: level i mixes 5 × 5 pixels 2^i apart. A neighbour q of p has the weight
///   w = h(Δx) h(Δy) · [label q = label p, both with a surface] · max(0, n_p·n_q)^normalPower
///       · exp(−|n_p·(P_q − P_p)| / (depthSigma · footprint_p · 2^i · distance))
///       · exp(−|l_q − l_p| / (luminanceSigma · sqrt(g(v))_p + ε)),
/// h = (1, 4, 6, 4, 1)/16, footprint = z/fx [m], distance = max(|Δx|, |Δy|) in steps (1 at the centre), l = luminance
/// of this level's input, v = variance of the pixel's mean, g(v) its 3 × 3 binomial mean inside the segment (weights 1,
/// 2, 4), ε = 1e-6; at p itself w = h(0)². Then colour = Σ w c / Σ w and variance = Σ w² v / (Σ w)². Because v falls
/// with the number of samples, the filter fades out: the limit is the unfiltered picture.
///
/// Initial v: from the second moment, (Σ l²/N − l̄²)/(N − 1) and at least 0, for N >= kTemporalSamples; with fewer
/// samples the variance of l̄ over the 7 × 7 neighbourhood inside the segment. Pixels of unedited segments stay
/// zero and are never used.
struct ImageFilterParams {
    int levels = 5;
    float normalPower = 64;
    float depthSigma = 1;
    float luminanceSigma = 4;
};
inline constexpr int kTemporalSamples = 4;

/// Mean radiance of an accumulation, filtered. `edited` marks (non-zero) the labels that were re-shaded: a pixel takes
/// part when its label is marked and its depth is valid.
[[nodiscard]] ImageRgb filterReshaded(const Accumulation& accumulation, const Camera& camera, const Surface& front,
                                      const LabelImage& labels, const std::vector<std::uint8_t>& edited,
                                      const ImageFilterParams& params = {}, const Progress& progress = {});

/// Mean radiance of an accumulation: sum / samples.
[[nodiscard]] ImageRgb meanRadiance(const Accumulation& accumulation);

}  // namespace core
