// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mask_labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace core {

namespace {

/// Fewer in-between values may as well be thin objects.
constexpr std::size_t kMinSoftValues = 3;
/// Share of the in-between pixels that must lie between two of their neighbours; the rest are the ridges of thin lines.
constexpr double kMinBetween = 0.7;
/// Share of the in-between pixels that may lie in an area of one value.
constexpr double kMaxFlat = 0.05;

struct Neighbourhood {
    bool between = false;  ///< a neighbour is less, another one is more
    bool flat = true;      ///< all neighbours are equal
};

Neighbourhood neighbourhoodOf(const ImageF& values, int x, int y) {
    const int left = std::max(x - 1, 0);
    const int right = std::min(x + 1, values.width() - 1);
    const float own = values(x, y);
    bool less = false, more = false;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, values.height() - 1); ++v)
        for (const float* near = &values(left, v); near <= &values(right, v); ++near) {
            less = less || *near < own;
            more = more || *near > own;
        }
    return {.between = less && more, .flat = !less && !more};
}

/// Pixels of one value.
struct ValueCount {
    std::size_t pixels = 0;
    std::size_t between = 0;
    std::size_t flat = 0;
    ValueCount& operator+=(const ValueCount& other) {
        pixels += other.pixels;
        between += other.between;
        flat += other.flat;
        return *this;
    }
    [[nodiscard]] bool isSoft() const {
        const auto all = static_cast<double>(pixels);
        return static_cast<double>(between) >= kMinBetween * all && static_cast<double>(flat) <= kMaxFlat * all;
    }
};

/// nullopt where the values are no labels: negative, not finite or too many. The neighbours of 0 and `maximum` are not
/// looked at.
std::optional<std::map<float, ValueCount>> valueCounts(const ImageF& values, float maximum) {
    constexpr std::size_t kMaxValues = 65536;
    std::map<float, ValueCount> counts;
    // One search per run, because neighbours are mostly equal.
    float last = 0;
    ValueCount* count = &counts[last];
    for (int y = 0; y < values.height(); ++y)
        for (int x = 0; x < values.width(); ++x) {
            const float value = values(x, y);
            if (!(value >= 0) || !std::isfinite(value) || counts.size() > kMaxValues) return std::nullopt;
            if (value != last) count = &counts[last = value];
            ++count->pixels;
            if (value == 0 || value == maximum) continue;
            const Neighbourhood found = neighbourhoodOf(values, x, y);
            if (found.between) ++count->between;
            if (found.flat) ++count->flat;
        }
    return counts;
}

}  // namespace

std::optional<Message> takeObjectFromAlpha(ImageF& values, const ImageF& alpha, float opaque, const std::string& path) {
    const auto [least, most] = std::ranges::minmax(alpha.pixels());
    const float label = std::ranges::max(values.pixels());
    const auto other = [&](float value) { return value != 0 && value != label; };
    if (least == most || !(least < 0.5f * opaque && most >= 0.5f * opaque) ||
        std::ranges::any_of(values.pixels(), other))
        return std::nullopt;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (label == 0) values[i] = std::min(opaque, 65535.0f);
        if (alpha[i] < 0.5f * opaque) values[i] = 0;
    }
    return Message("messages",
                   "The one object in \"%1\" is taken from the alpha channel: its pixels are those that are at least "
                   "half opaque.")
        .with(path);
}

std::optional<Message> hardenMask(ImageF& values, float maximum, const std::string& path) {
    const auto counts = valueCounts(values, maximum);
    if (!counts) return std::nullopt;
    ValueCount middle;
    std::size_t middleValues = 0, softLabels = 0;
    for (const auto& [value, count] : *counts) {
        if (!(value > 0) || value == maximum) continue;
        middle += count;
        ++middleValues;
        if (count.isSoft()) ++softLabels;
    }
    if (middleValues < kMinSoftValues) return std::nullopt;
    const bool toMaximum = counts->rbegin()->first == maximum;
    if (toMaximum && 2 * middle.pixels < values.size() && middle.isSoft()) {
        for (float& value : values.pixels()) value = value >= 0.5f * maximum ? maximum : 0;
        return Message("messages",
                       "\"%1\" is a mask with soft edges, not a label map: its pixels from half of the maximum up are "
                       "one segment.")
            .with(path);
    }
    if (softLabels < kMinSoftValues || 2 * softLabels < counts->size()) return std::nullopt;
    return Message("messages",
                   "%1 of the labels in \"%2\" lie only between others, as soft edges do. Each of them is a segment: "
                   "save the label map without antialiasing.")
        .with(softLabels, path);
}

}  // namespace core
