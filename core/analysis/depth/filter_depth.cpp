// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/filter_depth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/kernels.h"
#include "core/base/parallel.h"
#include "core/base/robust.h"
#include "shaders/shared/depth_filter_block.h"

namespace core::analysis {
namespace {

/// Squared distance of two encoded colours, [0, 3].
float squaredDistance(std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const int difference = static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255);
        sum += difference * difference;
    }
    return static_cast<float>(sum) * (1.0f / (255 * 255));
}

/// 5×5 Gaussian with taps `step` apart, `sigma` in units of `step`; the centre's weight is 1.
FilterPass makePass(int step, float sigma, const NoiseCurve& range, float colorFactor) {
    FilterPass pass;
    std::size_t count = 0;
    for (int dy = 0; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            if (dy > 0 || dx > 0)
                pass.pairs[count++] = {dx * step, dy * step,
                                       2 * std::exp(static_cast<float>(-dx * dx - dy * dy) / (2 * sigma * sigma))};
    pass.reach = 2 * step;
    pass.range = range;
    pass.colorFactor = colorFactor;
    return pass;
}

/// Limit of a biweight over the σ of the Gaussian that it resembles.
constexpr float kBiweightLimit = 2.18f;
/// Range of a Geman-McClure weight over the σ of the Gaussian that it stands for.
constexpr float kGemanMcClureRange = 1.7f;
constexpr int kMaxPasses = 5;

/// A pass and the images that it reads.
struct PassOverImage {
    const FilterPass& pass;
    const ImageF& inverseDepth;
    const Image<std::uint32_t>& color;
    const LabelImage& labels;

    [[nodiscard]] float filtered(int x, int y) const {
        const float w = inverseDepth(x, y);
        const float limit = pass.range.at(w);
        if (w <= 0 || limit <= 0) return w;
        const float factor = 1 / (limit * limit);
        const std::uint16_t label = labels(x, y);
        const std::uint32_t center = color(x, y);
        float sum = 0;
        float weight = 1;
        const std::ptrdiff_t width = inverseDepth.width();
        const int reach = pass.reach;
        const bool inside =
            x >= reach && y >= reach && x + reach < inverseDepth.width() && y + reach < inverseDepth.height();
        const std::size_t here = inverseDepth.index(x, y);
        const float* const values = inverseDepth.data() + here;
        const std::uint16_t* const segments = labels.data() + here;
        const std::uint32_t* const colors = color.data() + here;
        for (const FilterPass::Pair& pair : pass.pairs) {
            if (!inside &&
                (!inverseDepth.contains(x + pair.dx, y + pair.dy) || !inverseDepth.contains(x - pair.dx, y - pair.dy)))
                continue;
            const std::ptrdiff_t a = pair.dy * width + pair.dx;
            const float wa = values[a];
            const float wb = values[-a];
            const float residual = 0.5f * (wa + wb) - w;
            const float squared = residual * residual * factor;
            if (squared >= kernel::kMaxSquaredResidual || wa <= 0 || wb <= 0 || segments[a] != label ||
                segments[-a] != label)
                continue;
            const float k =
                pair.weight * gemanMcClure(squared) *
                biweight((squaredDistance(colors[a], center) + squaredDistance(colors[-a], center)) * pass.colorFactor);
            sum += k * residual;
            weight += k;
        }
        return w + sum / weight;
    }
};

NoiseCurve scaled(NoiseCurve curve, float factor) {
    for (float& sigma : curve.sigma) sigma *= factor;
    return curve;
}

/// Progress of pass `k`.
Progress partOf(int k, const Progress& progress) {
    const float from = 0.1f + 0.18f * static_cast<float>(k);
    return progress.part(from, from + 0.18f);
}

/// Noise that remains in `w` between pixels `step` apart.
NoiseCurve remainingNoiseAt(int step, const ImageF& w, const LabelImage& labels, const DepthNoise& noise,
                            const Progress& progress) {
    if (noise.quantised) return noise.deviation;
    // Uncorrelated noise at least halves with every pass; correlated noise only once taps are farther apart.
    NoiseCurve left = scaled(noise.deviation, std::min(1.0f, 2 * noise.correlationLength / static_cast<float>(step)));
    const NoiseCurve measured = measureNoise(w, labels, step, Differences::Second, progress);
    for (std::size_t i = 0; i < left.sigma.size(); ++i)
        if (measured.sigma[i] > 0) left.sigma[i] = std::min(left.sigma[i], measured.sigma[i]);
    return left;
}

/// Greatest angle [rad] by which noise tilts a surface between pixels `step` apart.
float tiltBy(const NoiseCurve& noise, int step, const Camera& camera) {
    float tilt = 0;
    for (std::size_t i = 0; i < noise.sigma.size(); ++i) {
        const float inverseDepth = noise.first + static_cast<float>(i) / noise.cellsPerUnit;
        tilt = std::max(tilt, noise.sigma[i] / inverseDepth);
    }
    return tilt * std::max(camera.fx, camera.fy) / static_cast<float>(step);
}

ImageF filterAutomatically(ImageF w, AnalysisKernels::DepthFilter& filter, const Photo& photo, const DepthNoise& noise,
                           const Progress& progress) {
    constexpr float kColorSigma = 0.25f;
    /// [rad] about a degree.
    constexpr float kMinTilt = 0.02f;
    /// Range of a pass in σ of the remaining noise: keeps most of it in range.
    constexpr float kAllowance = 4.0f;
    // It is unknown where depth changes between two steps of rounding: colours would keep the terraces in place.
    const float colorFactor =
        noise.quantised ? 0.0f : 1 / (kBiweightLimit * kBiweightLimit * kColorSigma * kColorSigma);
    const int spacing = wholeSpacing(photo.depthSampleSpacing);
    // An enlarged map is smooth between its own samples already.
    const int passes = spacing > 1 && !noise.quantised ? 3 : kMaxPasses;
    for (int k = 0; k < passes; ++k) {
        const int step = spacing << k;
        const Progress part = partOf(k, progress);
        const NoiseCurve left = remainingNoiseAt(step, w, photo.labels, noise, part.part(0, 0));
        if (tiltBy(left, step, photo.camera) < kMinTilt && step > static_cast<int>(noise.correlationLength)) break;
        w = filter.run(makePass(step, 1.0f, scaled(left, kAllowance), colorFactor), w, part);
    }
    return w;
}

ImageF filterAsAsked(ImageF w, AnalysisKernels::DepthFilter& filter, const DepthFilterParams& params,
                     const Progress& progress) {
    constexpr float kMaxKernelSigma = 1.5f;
    const float colorSigma = std::max(params.colorSigma, 1e-4f);
    NoiseCurve range;
    range.cellsPerUnit = 1;  // σ(1/z) = σ(z)/z · 1/z
    for (std::size_t i = 0; i < range.sigma.size(); ++i)
        range.sigma[i] = kGemanMcClureRange * params.depthSigma * static_cast<float>(i);
    // Variances add up: passes with a σ of t, 2t, 4t, ... pixels.
    int passes = 1;
    float variance = 1;
    while (variance < params.spatialSigma * params.spatialSigma && passes < kMaxPasses)
        variance += static_cast<float>(1 << (2 * passes++));
    const float sigma = std::min(params.spatialSigma / std::sqrt(variance), kMaxKernelSigma);
    const float colorFactor = 1 / (kBiweightLimit * kBiweightLimit * colorSigma * colorSigma);
    for (int k = 0; k < passes; ++k)
        w = filter.run(makePass(1 << k, sigma, range, colorFactor), w, partOf(k, progress));
    return w;
}

}  // namespace

Image<std::uint32_t> encodeColor(const ImageRgb& color, const Progress& progress) {
    Image<std::uint32_t> encoded(color.width(), color.height());
    parallelFor(progress, color.height(), [&](int y) {
        for (int x = 0; x < color.width(); ++x) {
            const Vector3f& c = color(x, y);
            std::uint32_t packed = 0;
            for (int k = 2; k >= 0; --k)
                packed = packed << 8 | static_cast<std::uint32_t>(255 * std::sqrt(std::clamp(c[k], 0.0f, 1.0f)) + 0.5f);
            encoded(x, y) = packed;
        }
    });
    return encoded;
}

ImageF runFilterPass(const FilterPass& pass, const ImageF& inverseDepth, const Image<std::uint32_t>& color,
                     const LabelImage& labels, const Progress& progress) {
    ImageF result(inverseDepth.width(), inverseDepth.height());
    const PassOverImage filter{pass, inverseDepth, color, labels};
    parallelFor(progress, result.height(), [&](int y) {
        for (int x = 0; x < result.width(); ++x) result(x, y) = filter.filtered(x, y);
    });
    return result;
}

ImageF filterDepth(const ImageF& depth, const Photo& photo, const DepthFilterParams& params, const DepthNoise& noise,
                   const StepContext& context) {
    const bool nothing = params.automatic ? noise.relative <= 0 : params.spatialSigma <= 0 || params.depthSigma <= 0;
    if (nothing) return depth;
    const Image<std::uint32_t> encoded = encodeColor(photo.color, context.progress.part(0, 0.1f));
    const auto filter = context.kernels.depthFilter(encoded, photo.labels);
    ImageF w = inverseOf(depth);
    w = params.automatic ? filterAutomatically(std::move(w), *filter, photo, noise, context.progress)
                         : filterAsAsked(std::move(w), *filter, params, context.progress);
    ImageF result(depth.width(), depth.height(), 0.0f);
    for (std::size_t i = 0; i < w.size(); ++i)
        if (depth[i] > 0) result[i] = 1 / w[i];
    return result;
}

}  // namespace core::analysis
