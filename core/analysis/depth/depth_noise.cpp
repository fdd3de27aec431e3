// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/depth_noise.h"

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/staged_progress.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Number of spacings at which noise is measured, normally and for smoothly enlarged maps. The latter are never exact
/// and may have been enlarged before storage as well.
constexpr std::size_t kScales = 5;
constexpr std::size_t kEnlargedScales = 6;
/// Relative deviation below which depth counts as exact: rounding of floats.
constexpr float kMaxExact = 2e-6f;

/// Factor from the median magnitude of differences to the σ of uncorrelated values: median |x| = 0.6745 σ, and the
/// squares of the weights add up to 6 and 70.
float deviationOfDifference(Differences order) {
    return 1 / (0.6745f * std::sqrt(order == Differences::Second ? 6.0f : 70.0f));
}

struct Block {
    float inverseDepth;
    float sigma;
};

/// Differences of inverse depth at one spacing.
struct DifferenceTap {
    const ImageF& w;
    const LabelImage& labels;
    int step;  ///< [px]
    Differences order;

    /// Magnitude of the difference about a valid pixel along an axis (0 = x, 1 = y), inside one segment.
    [[nodiscard]] std::optional<float> at(int x, int y, int axis) const {
        constexpr float kSecond[] = {-2, 1};
        constexpr float kFourth[] = {6, -4, 1};
        const int reach = order == Differences::Second ? 1 : 2;
        const float* const weights = order == Differences::Second ? kSecond : kFourth;
        const int dx = axis == 0 ? step : 0;
        const int dy = axis == 0 ? 0 : step;
        if (!w.contains(x - reach * dx, y - reach * dy) || !w.contains(x + reach * dx, y + reach * dy))
            return std::nullopt;
        float sum = weights[0] * w(x, y);
        bool valid = true;
        for (int k = 1; k <= reach; ++k) {
            for (const int side : {-k, k}) {
                const float value = w(x + side * dx, y + side * dy);
                valid = valid && value > 0 && labels(x + side * dx, y + side * dy) == labels(x, y);
                sum += weights[k] * value;
            }
        }
        return valid ? std::optional(std::abs(sum)) : std::nullopt;
    }
};

/// Median difference of one block.
std::optional<Block> measureBlock(const DifferenceTap& difference, int x0, int y0, int size) {
    constexpr int kGrid = 8;
    constexpr std::size_t kMinDifferences = 24;
    const ImageF& w = difference.w;
    std::array<float, 2 * kGrid * kGrid> differences;
    std::array<float, kGrid * kGrid> levels;
    std::size_t count = 0;
    std::size_t levelCount = 0;
    for (int j = 0; j < kGrid; ++j) {
        for (int i = 0; i < kGrid; ++i) {
            // Irregular offsets: a regular grid could be in phase with a pattern of quantisation.
            const int x = x0 + i * size / kGrid + (j * 5) % std::max(size / kGrid, 1);
            const int y = y0 + j * size / kGrid + (i * 3) % std::max(size / kGrid, 1);
            if (!w.contains(x, y) || w(x, y) <= 0) continue;
            const std::size_t before = count;
            for (int axis = 0; axis < 2; ++axis)
                if (const auto value = difference.at(x, y, axis)) differences[count++] = *value;
            if (count > before) levels[levelCount++] = w(x, y);
        }
    }
    if (count < kMinDifferences) return std::nullopt;
    return Block{median(std::span(levels).first(levelCount)),
                 median(std::span(differences).first(count)) * deviationOfDifference(difference.order)};
}

struct Range {
    float low = 0, high = 0;
};

Range rangeOf(const ImageF& w) {
    Range range{std::numeric_limits<float>::max(), 0};
    for (const float value : w.pixels()) {
        if (value <= 0) continue;
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    }
    return range;
}

NoiseCurve curveOver(const Range& range) {
    NoiseCurve curve;
    curve.first = range.low;
    curve.cellsPerUnit =
        static_cast<float>(NoiseCurve::kCells - 1) / std::max(range.high - range.low, 1e-6f * range.high + 1e-12f);
    return curve;
}

float cellCentre(const NoiseCurve& curve, std::size_t cell) {
    return curve.first + static_cast<float>(cell) / curve.cellsPerUnit;
}

/// Second differences of inverse depth [quanta] wherever it changes by more than `same` (relative).
std::vector<float> bendsOf(const ImageF& w, int step, const NoiseCurve& quantum, float same) {
    std::vector<float> bends;
    const int stride = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(w.size()) / 50000)));
    for (int y = step; y + step < w.height(); y += stride) {
        for (int x = step; x + step < w.width(); x += stride) {
            for (const auto& [before, after] :
                 {std::array{w(x - step, y), w(x + step, y)}, std::array{w(x, y - step), w(x, y + step)}}) {
                const float here = w(x, y);
                if (here <= 0 || before <= 0 || after <= 0) continue;
                if (std::abs(before - here) <= same * here && std::abs(after - here) <= same * here) continue;
                bends.push_back(std::abs(before - 2 * here + after) / quantum.at(here));
            }
        }
    }
    return bends;
}

/// Whether depth changes in steps of about `quantum` where it changes. An exact floor also has one value per row, but
/// changes evenly from row to row. `same`: relative difference of values that count as equal.
bool hasStairs(const ImageF& w, int step, bool resampled, const NoiseCurve& quantum, float same) {
    std::vector<float> bends = bendsOf(w, step, quantum, same);
    if (bends.empty()) return false;
    // Splines that resample a map bend by a sixth of a step where it begins.
    if (quantile(bends, 0.5) > (resampled ? 0.1f : 0.2f)) return true;
    // Where depth is steep most steps follow each other evenly; the others deviate by whole steps.
    constexpr float kMinBend = 0.05f;
    constexpr float kMaxBend = 4.5f;
    std::size_t bent = 0, whole = 0;
    for (const float bend : bends) {
        if (bend < kMinBend || bend > kMaxBend) continue;
        ++bent;
        if (bend > 0.5f && std::abs(bend - std::round(bend)) < 0.15f) ++whole;
    }
    return !resampled && bent * 10 > bends.size() && whole * 10 > bent * 7;
}

struct StoredValue {
    float value;
    std::size_t count;
};

/// The distinct values of a sorted list and their counts; `same`: relative difference of those that count as equal.
std::vector<StoredValue> countValues(std::span<const float> sorted, float same) {
    std::vector<StoredValue> result;
    for (std::size_t i = 0, next = 0; i < sorted.size(); i = next) {
        while (next < sorted.size() && sorted[next] <= sorted[i] * (1 + same)) ++next;
        result.push_back({sorted[i], next - i});
    }
    return result;
}

/// Values of an earlier, coarser rounding, to which smoothing or stretching later added those in between: every k-th
/// value, each more than twice as frequent as its neighbours, and together most of the pixels. Empty when there was no
/// such rounding.
std::vector<StoredValue> coarseValues(std::span<const StoredValue> all) {
    constexpr std::size_t kMinPeaks = 8;
    std::vector<std::size_t> peaks;
    std::size_t held = 0, total = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        total += all[i].count;
        if (all[i].count < 4 || (i > 0 && all[i].count <= 2 * all[i - 1].count) ||
            (i + 1 < all.size() && all[i].count <= 2 * all[i + 1].count))
            continue;
        peaks.push_back(i);
        held += all[i].count;
    }
    if (peaks.size() < kMinPeaks || held * 2 < total) return {};
    std::vector<std::size_t> apart;
    for (std::size_t k = 1; k < peaks.size(); ++k) apart.push_back(peaks[k] - peaks[k - 1]);
    const std::size_t usual = median(apart);
    if (static_cast<std::size_t>(std::ranges::count(apart, usual)) * 3 < apart.size() * 2) return {};
    std::vector<StoredValue> result;
    for (const std::size_t i : peaks) result.push_back(all[i]);
    return result;
}

/// Gives cells where relief hid the noise the value of the nearest known cell, relative to inverse depth.
void extendToUnknown(NoiseCurve& curve) {
    const NoiseCurve known = curve;
    for (std::size_t cell = 0; cell < known.sigma.size(); ++cell) {
        for (std::size_t away = 1; away < known.sigma.size() && curve.sigma[cell] <= 0; ++away) {
            for (const std::size_t other : {cell - away, cell + away})
                if (other < known.sigma.size() && known.sigma[other] > 0)
                    curve.sigma[cell] = known.sigma[other] * cellCentre(known, cell) / cellCentre(known, other);
        }
    }
}

/// Some of the valid inverse depths, in increasing order.
std::vector<float> sortedSubset(const ImageF& w) {
    std::vector<float> values;
    const std::size_t stride = w.size() / 200000 + 1;
    for (std::size_t i = 0; i < w.size(); i += stride)
        if (w[i] > 0) values.push_back(w[i]);
    std::ranges::sort(values);
    return values;
}

/// Median distance between neighbouring values of a sorted list, by inverse depth. Where cells hold too few of them,
/// and in `relative`, the median over all of the distance relative to inverse depth.
struct Quantum {
    NoiseCurve curve;
    float relative = 0;
};

Quantum quantumOf(std::span<const float> stored, const NoiseCurve& cells) {
    std::array<std::vector<float>, NoiseCurve::kCells> steps;
    std::vector<float> relative;
    for (std::size_t i = 1; i < stored.size(); ++i) {
        const auto cell = static_cast<std::size_t>(
            std::clamp((stored[i] - cells.first) * cells.cellsPerUnit + 0.5f, 0.0f, NoiseCurve::kCells - 1.0f));
        steps[cell].push_back(stored[i] - stored[i - 1]);
        relative.push_back((stored[i] - stored[i - 1]) / stored[i]);
    }
    Quantum quantum{cells, quantile(relative, 0.5)};
    for (std::size_t cell = 0; cell < steps.size(); ++cell)
        quantum.curve.sigma[cell] =
            steps[cell].size() < 3 ? quantum.relative * cellCentre(cells, cell) : quantile(steps[cell], 0.5);
    return quantum;
}

/// Distance between neighbouring stored values over inverse depth. In an enlarged map these are the values that occur
/// often, since interpolation adds others in between; the same holds when rounded values were resampled before. Zero
/// when nearly every pixel has a value of its own, and when the values are so far apart that they are separate
/// surfaces.
NoiseCurve quantisation(const ImageF& w, bool enlarged, int spacing, const Range& range) {
    const float same = enlarged ? 1e-5f : 0;  // relative; rounding of floats
    const NoiseCurve none = curveOver(range);
    const std::vector<float> values = sortedSubset(w);
    const std::size_t often = enlarged ? std::max<std::size_t>(4, values.size() / 4000) : 1;
    const std::vector<StoredValue> all = countValues(values, same);
    const auto coarse = coarseValues(all);
    const bool resampled = enlarged || !coarse.empty();
    const float maxRelative = coarse.empty() ? 0.02f : 0.1f;
    std::vector<float> stored;
    std::size_t held = 0;
    for (const auto& [value, count] : coarse.empty() ? all : coarse) {
        if (count < often) continue;
        stored.push_back(value);
        held += count;
    }
    if (stored.size() < 3 || stored.size() * 4 > held || held * 5 < values.size() * 2) return none;
    const Quantum quantum = quantumOf(stored, none);
    if (quantum.relative > maxRelative) return none;
    return hasStairs(w, spacing, resampled, quantum.curve, same) ? quantum.curve : none;
}

/// Noise of blocks sorted by inverse depth: in each bin, that of the smoothest fifth.
std::vector<Block> noiseByDepth(std::span<const Block> blocks) {
    const std::size_t bins = std::clamp<std::size_t>(blocks.size() / 24, 1, 8);
    std::vector<Block> knots;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const std::size_t from = bin * blocks.size() / bins;
        const std::size_t to = (bin + 1) * blocks.size() / bins;
        std::vector<float> sigmas;
        for (std::size_t i = from; i < to; ++i) sigmas.push_back(blocks[i].sigma);
        knots.push_back({blocks[(from + to) / 2].inverseDepth, quantile(sigmas, 0.2)});
    }
    // Noise changes slowly with depth: a bin with nothing smooth in it follows its neighbours.
    constexpr float kMaxGrowth = 1.6f;
    for (std::size_t i = 1; i < knots.size(); ++i)
        knots[i].sigma = std::min(knots[i].sigma, kMaxGrowth * knots[i - 1].sigma);
    for (std::size_t i = knots.size() - 1; i-- > 0;)
        knots[i].sigma = std::min(knots[i].sigma, kMaxGrowth * knots[i + 1].sigma);
    return knots;
}

/// Interpolates linearly between knots, which are sorted.
void interpolate(std::span<const Block> knots, NoiseCurve& curve) {
    std::size_t next = 0;
    for (std::size_t cell = 0; cell < curve.sigma.size(); ++cell) {
        const float x = cellCentre(curve, cell);
        while (next < knots.size() && knots[next].inverseDepth <= x) ++next;
        if (next == 0) {
            curve.sigma[cell] = knots.front().sigma;
        } else if (next == knots.size()) {
            curve.sigma[cell] = knots.back().sigma;
        } else {
            const Block& a = knots[next - 1];
            const Block& b = knots[next];
            const float t = (x - a.inverseDepth) / std::max(b.inverseDepth - a.inverseDepth, 1e-12f);
            curve.sigma[cell] = (1 - t) * a.sigma + t * b.sigma;
        }
    }
}

NoiseCurve measureNoise(const DifferenceTap& difference, const Range& range, const Progress& progress) {
    const ImageF& w = difference.w;
    NoiseCurve curve = curveOver(range);
    const int size = 32 * std::max(1, difference.step / 16);
    const int columns = (w.width() + size - 1) / size;
    const int rows = (w.height() + size - 1) / size;
    const int skip = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(columns) * rows / 2500)));
    std::vector<std::optional<Block>> found(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    parallelFor(progress, (rows + skip - 1) / skip, [&](int j) {
        for (int i = 0; i < columns; i += skip)
            found[static_cast<std::size_t>(j * skip) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(i)] = measureBlock(difference, i * size, j * skip * size, size);
    });
    std::vector<Block> blocks;
    for (const auto& block : found)
        if (block) blocks.push_back(*block);
    if (blocks.empty()) return curve;
    std::ranges::sort(blocks, {}, &Block::inverseDepth);
    interpolate(noiseByDepth(blocks), curve);
    return curve;
}

/// Noise in one cell of a curve: the level at which its differences stop growing with the spacing, and rounding.
struct CellLevel {
    float plateau = 0;      ///< [1/m] 0 = none
    float rounding = 0;     ///< [1/m] 0 = none
    bool terraced = false;  ///< terraces are wider than the spacing: differences show only where they end
};

CellLevel levelOf(std::span<const NoiseCurve> scales, std::size_t cell, float quantum, float exact) {
    CellLevel level;
    float highest = scales[0].sigma[cell];
    for (std::size_t k = 1; k < scales.size(); ++k) {
        const float before = scales[k - 1].sigma[cell];
        const float here = scales[k].sigma[cell];
        if (here <= 0) break;
        highest = std::max(highest, here);
        if (here < 2 * before) level.plateau = highest;
    }
    if (scales[1].sigma[cell] <= 0) level.plateau = highest;  // too small a picture to compare scales
    if (level.plateau < exact) level.plateau = 0;
    level.rounding = quantum / std::sqrt(12.0f);
    if (level.rounding < exact) level.rounding = 0;
    level.terraced = scales[0].sigma[cell] < 0.5f * level.rounding;
    return level;
}

}  // namespace

int wholeSpacing(float depthSampleSpacing) { return std::max(1, static_cast<int>(std::lround(depthSampleSpacing))); }

ImageF inverseOf(const ImageF& depth) {
    ImageF inverse(depth.width(), depth.height());
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (depth[i] > 0) inverse[i] = 1 / depth[i];
    return inverse;
}

NoiseCurve measureNoise(const ImageF& inverseDepth, const LabelImage& labels, int step, Differences order,
                        const Progress& progress) {
    return measureNoise({inverseDepth, labels, step, order}, rangeOf(inverseDepth), progress);
}

float relativeNoise(const NoiseCurve& deviation, const ImageF& inverseDepth) {
    std::vector<float> values;
    const std::size_t stride = inverseDepth.size() / 20000 + 1;
    for (std::size_t i = 0; i < inverseDepth.size(); i += stride)
        if (inverseDepth[i] > 0) values.push_back(inverseDepth[i]);
    if (values.empty()) return 0;
    const float middle = quantile(values, 0.5);
    return deviation.at(middle) / middle;
}

DepthNoise estimateDepthNoise(const ImageF& inverseDepth, const LabelImage& labels, float depthSampleSpacing,
                              const Progress& progress) {
    DepthNoise noise;
    const Range range = rangeOf(inverseDepth);
    if (range.high <= 0) return noise;
    const int spacing = wholeSpacing(depthSampleSpacing);
    const NoiseCurve quanta = quantisation(inverseDepth, depthSampleSpacing > 1, spacing, range);
    const bool smooth = spacing > 1 && std::ranges::all_of(quanta.sigma, [](float quantum) { return quantum <= 0; });
    std::vector<NoiseCurve> scales(smooth ? kEnlargedScales : kScales);
    StagedProgress stages(progress, static_cast<double>(scales.size()));
    for (std::size_t k = 0; k < scales.size(); ++k)
        scales[k] = measureNoise({inverseDepth, labels, spacing << k, Differences::Fourth}, range, stages.next(1));

    noise.deviation = curveOver(range);
    std::vector<float> total(scales.size(), 0.0f);
    float plateaus = 0;
    float quantised = 0;
    for (std::size_t cell = 0; cell < noise.deviation.sigma.size(); ++cell) {
        const auto [plateau, rounding, terraced] =
            levelOf(scales, cell, quanta.sigma[cell], kMaxExact * cellCentre(noise.deviation, cell));
        for (std::size_t k = 0; k < scales.size(); ++k) total[k] += std::min(scales[k].sigma[cell], plateau);
        plateaus += terraced ? std::min(plateau, rounding) : plateau;
        quantised += terraced || rounding > plateau ? rounding : 0;
        noise.deviation.sigma[cell] = terraced ? rounding : std::max(plateau, rounding);
    }
    if (smooth) extendToUnknown(noise.deviation);
    noise.quantised = quantised > 0 && quantised >= plateaus;
    noise.correlationLength = static_cast<float>(spacing);
    for (std::size_t k = 0; k < scales.size() && total[k] < 0.7f * plateaus; ++k)
        noise.correlationLength = static_cast<float>(spacing << std::min(k + 1, scales.size() - 1));

    noise.relative = relativeNoise(noise.deviation, inverseDepth);
    return noise;
}

}  // namespace core::analysis
