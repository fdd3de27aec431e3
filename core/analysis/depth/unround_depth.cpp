// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/unround_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/depth/depth_noise.h"
#include "core/base/parallel.h"
#include "core/base/robust.h"
#include "core/base/staged_progress.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Fewest and most different values of a map that is rounded coarsely, and fewest pixels for each.
constexpr std::size_t kMinValues = 8;
constexpr std::size_t kMostLevels = 1024;
constexpr std::size_t kMinPixelsPerValue = 4;
/// Relative difference of values that count as equal: rounding of floats.
constexpr float kSameValue = 2e-6f;
/// Largest distance from a whole number of steps [steps] between neighbouring values, and the smallest fraction of them
/// that keeps it.
constexpr float kWholeTolerance = 0.05f;
constexpr float kMinWholeFraction = 0.95f;
/// Distances of the pixels [px] between which inverse depth is straightened, and rounds at each.
constexpr std::array kSpacings{8, 4, 2, 1};
constexpr int kRounds = 16;
/// Second difference [steps] at which its weight is a quarter. Rounding alone makes up to two.
constexpr float kBendLimit = 2;
/// Step of the descent: the inverse of a bound of the bending energy's second derivative.
constexpr float kDescent = 1.0f / 22;

/// A straight line through a pixel along which inverse depth is to bend little.
struct BendLine {
    int dx, dy;  ///< in units of the spacing
    float weight;
};
constexpr std::array<BendLine, 4> kLines{{{1, 0, 1}, {0, 1, 1}, {1, 1, 0.25f}, {1, -1, 0.25f}}};

/// Step that nearly all distances between neighbours of a sorted list are multiples of; 0 if there is none.
float commonStep(const std::vector<float>& sorted) {
    std::vector<float> distances;
    for (std::size_t i = 1; i < sorted.size(); ++i) distances.push_back(sorted[i] - sorted[i - 1]);
    const float step = quantile(distances, 0.25);
    const auto whole = std::ranges::count_if(distances, [&](float distance) {
        const float steps = distance / step;
        return steps > 0.5f && std::abs(steps - std::round(steps)) < kWholeTolerance * std::round(steps);
    });
    return static_cast<float>(whole) >= kMinWholeFraction * static_cast<float>(distances.size()) ? step : 0.0f;
}

/// The different valid values of a map in increasing order; as many as count as coarse, and one more.
std::vector<float> differentValues(const ImageF& depth, std::size_t& valid) {
    std::vector<float> values;
    for (const float z : depth.pixels())
        if (z > 0 && std::isfinite(z)) values.push_back(z);
    valid = values.size();
    std::ranges::sort(values);
    std::vector<float> different;
    for (const float value : values) {
        if (!different.empty() && value <= different.back() * (1 + kSameValue)) continue;
        different.push_back(value);
        if (different.size() > kMostLevels) break;
    }
    return different;
}

/// Inverse depth between its bounds, straightened by projected descent.
class RoundedSurface {
  public:
    RoundedSurface(const ImageF& depth, const DepthRounding& rounding)
        : stored_(inverseOf(depth)), values_(stored_), bends_(), steps_(depth.width(), depth.height(), 0.0f) {
        for (std::size_t i = 0; i < stored_.size(); ++i)
            if (stored_[i] > 0) steps_[i] = rounding.inverseStep(stored_[i]);
        for (ImageF& bends : bends_) bends = ImageF(depth.width(), depth.height(), 0.0f);
    }

    /// One round at one distance of the pixels.
    void straighten(int spacing, const Progress& progress) {
        parallelFor(progress.part(0, 0.5f), values_.height(), [&](int y) { findBends(y, spacing); });
        parallelFor(progress.part(0.5f, 1), values_.height(), [&](int y) { descend(y, spacing); });
    }

    /// 0 where nothing was changed.
    [[nodiscard]] float changedInverseDepth(std::size_t i) const { return values_[i] == stored_[i] ? 0 : values_[i]; }

  private:
    [[nodiscard]] bool hasRow(int y) const { return y >= 0 && y < values_.height(); }

    /// Weighted second differences along all lines about the pixels of a row; 0 beside invalid pixels.
    void findBends(int y, int spacing) {
        const int width = values_.width();
        for (std::size_t k = 0; k < kLines.size(); ++k) {
            const int dx = kLines[k].dx * spacing;
            const int dy = kLines[k].dy * spacing;
            if (!hasRow(y - std::abs(dy)) || !hasRow(y + std::abs(dy))) continue;
            const float* const before = &values_(0, y - dy);
            const float* const here = &values_(0, y);
            const float* const after = &values_(0, y + dy);
            const float* const step = &steps_(0, y);
            float* const bend = &bends_[k](0, y);
            for (int x = dx; x + dx < width; ++x) {
                const float difference = before[x - dx] - 2 * here[x] + after[x + dx];
                const float ratio = difference / (kBendLimit * step[x]);
                const bool valid = std::min({before[x - dx], here[x], after[x + dx]}) > 0;
                bend[x] = valid ? kLines[k].weight * gemanMcClure(ratio * ratio) * difference : 0.0f;
            }
        }
    }

    void descend(int y, int spacing) {
        const int width = values_.width();
        std::vector<float> slope(static_cast<std::size_t>(width), 0.0f);
        const auto add = [&](const ImageF& bends, int dx, int dy, float factor) {
            if (!hasRow(y + dy)) return;
            for (int x = std::max(0, -dx); x < std::min(width, width - dx); ++x)
                slope[static_cast<std::size_t>(x)] += factor * bends(x + dx, y + dy);
        };
        for (std::size_t k = 0; k < kLines.size(); ++k) {
            const int dx = kLines[k].dx * spacing;
            const int dy = kLines[k].dy * spacing;
            add(bends_[k], 0, 0, -2);
            add(bends_[k], dx, dy, 1);
            add(bends_[k], -dx, -dy, 1);
        }
        for (int x = 0; x < width; ++x) {
            const float stored = stored_(x, y);
            const float half = 0.5f * std::min(steps_(x, y), stored);
            const float moved = values_(x, y) - kDescent * slope[static_cast<std::size_t>(x)];
            values_(x, y) = std::clamp(moved, stored - half, stored + half);
        }
    }

    ImageF stored_, values_;                   ///< [1/m], 0 = invalid
    std::array<ImageF, kLines.size()> bends_;  ///< [1/m]
    ImageF steps_;                             ///< [1/m] step of the rounding
};

}  // namespace

std::optional<DepthRounding> findDepthRounding(const ImageF& depth) {
    std::size_t valid = 0;
    std::vector<float> values = differentValues(depth, valid);
    if (values.size() < kMinValues || values.size() > kMostLevels || valid < kMinPixelsPerValue * values.size())
        return std::nullopt;
    if (const float step = commonStep(values); step > 0) return DepthRounding{step, false};
    std::ranges::reverse(values);
    for (float& value : values) value = 1 / value;
    if (const float step = commonStep(values); step > 0) return DepthRounding{step, true};
    return std::nullopt;
}

ImageF unroundDepth(const ImageF& depth, const Progress& progress) {
    const auto rounding = findDepthRounding(depth);
    if (!rounding) return depth;
    RoundedSurface surface(depth, *rounding);
    StagedProgress stages(progress, static_cast<double>(kSpacings.size()) * kRounds);
    for (const int spacing : kSpacings)
        for (int round = 0; round < kRounds; ++round) surface.straighten(spacing, stages.next(1));
    ImageF result = depth;
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (const float w = surface.changedInverseDepth(i); w > 0) result[i] = 1 / w;
    return result;
}

}  // namespace core::analysis
