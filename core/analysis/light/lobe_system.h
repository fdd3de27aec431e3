// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/directional_map.h"

namespace core::analysis {

/// Radiance of distant light seen through a lobe: the missed rays of one glossy segment divided by its ρ, or, with
/// α = 0, the light itself.
struct LobeObservations {
    DirectionalMap map;      ///< radiance after the lobe; coverage = weight of the observations, 0 = none
    float alpha = 0;         ///< GGX width of the lobe
    Vector3f view{0, 0, 1};  ///< unit, from the camera to what shows the light
    float confidence = 1;    ///< of this source relative to the others, (0, 1]
    /// 1 = the observations of a texel show a support instead of distant light (`SegmentReflections::overSupport`).
    /// Empty = nowhere.
    Image<std::uint8_t> overSupport = {};

    /// Bit c: channel c of a texel was clipped.
    [[nodiscard]] unsigned clippedChannels(std::size_t texel) const {
        return map.clipped.empty() ? 0u : map.clipped[texel];
    }
    [[nodiscard]] bool isOverSupport(std::size_t texel) const {
        return !overSupport.empty() && overSupport[texel] != 0;
    }
    /// True if the lobe is wider than a texel of the map, so that light has to be separated from it.
    [[nodiscard]] bool isBlurred() const;
};

/// Observations of one source as a sparse linear system: each is a weighted mean of texels of the light.
struct LobeSystem {
    struct Row {
        std::size_t end;  ///< end of its entries; they begin where those of the row before end
        float weight;
        Vector3f observed;
        unsigned clipped;  ///< bit c: channel c is a lower bound
    };
    struct Entry {
        std::uint32_t texel;
        float weight;
    };
    std::vector<Row> rows;
    std::vector<Entry> entries;

    /// One row for each texel of `wanted` (an index into the map), from `samples` half vectors of the lobe.
    LobeSystem(const LobeObservations& source, std::span<const std::uint32_t> wanted, int samples);

    [[nodiscard]] std::span<const Entry> entriesOf(std::size_t row) const {
        const std::size_t begin = row == 0 ? 0 : rows[row - 1].end;
        return {entries.data() + begin, rows[row].end - begin};
    }
};

}  // namespace core::analysis
