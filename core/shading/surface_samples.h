// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/image.h"

namespace core {

/// A point on a segment's surface, where light enters.
struct SurfaceSample {
    int x = 0, y = 0;   ///< pixel
    bool back = false;  ///< on the invented back side
    Vector3f position;  ///< [m]
    Vector3f normal;    ///< unit, outward
    double curve = 0;   ///< position on the sampling curve, in [0, 1); equal lengths are equal areas
};

/// Points on front and back of a segment, each surface element equally likely.
struct SurfaceSamples {
    std::vector<SurfaceSample> samples;
    std::vector<std::uint32_t> order;  ///< samples along the curve
    double area = 0;                   ///< [m²], front and back together: the Ã of docs/method.md#translucency
    /// Mean area per sample [m²]; 0 without samples.
    [[nodiscard]] double areaPerSample() const {
        return samples.empty() ? 0.0 : area / static_cast<double>(samples.size());
    }
};

/// Draws `count` points from the pixels of `label`, front and back, exactly in proportion to patch area: an
/// Owen-scrambled van der Corput sequence through the inverse distribution along a Hilbert curve over the picture.
/// Progressive: the first n of a larger set equal the set of n and cover the surface evenly. Deterministic by
/// `seed`. Empty when the segment has no area.
[[nodiscard]] SurfaceSamples sampleSurface(const Analysis& analysis, const LabelImage& labels, std::uint16_t label,
                                           int count, std::uint32_t seed);

/// Area of each of the first `count` samples [m²]: the part of the curve that is nearer to it than to the others. The
/// sum is `samples.area`; gives less noise than equal parts, above all where count is not a power of two.
[[nodiscard]] std::vector<float> sampleAreas(const SurfaceSamples& samples, std::size_t count);

}  // namespace core
