// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/bound.h"
#include "render/render_context.h"
#include "render/sums/path_key.h"
#include "render/sums/pixel_set.h"

namespace render {

/// How a material mixes what was rendered with the photograph.
struct Blend {
    float blendNew = 0;
    float blendOriginal = 0;
    bool translucent = false;
    float translucentWeight = 0;
    float eta = 0;                 ///< relative index of a translucent body's boundary
    std::vector<DriveKey> drives;  ///< weights that vary over the segment
    bool operator==(const Blend&) const = default;
};
[[nodiscard]] Blend blendOf(const ShadedScene& shaded, const core::Segment& segment);

/// One segment in the result: its sums blended with the photograph, and the pixels at its outline. All of it is stale
/// exactly when its key has changed; otherwise the pixels that advanced are.
class Composite {
  public:
    struct Key {
        Blend blend;
        bool filterEnabled = false;
        std::uint64_t backdrop = 0, silhouette = 0, filteredPicture = 0, diffusion = 0;  ///< versions
        bool operator==(const Key&) const = default;
    };

    /// The sum of these pixels has changed.
    void add(const PixelRange& advanced) { advanced_.push_back(advanced); }
    [[nodiscard]] bool current(const Key& key) const { return shown_ == key; }
    [[nodiscard]] bool due(const Key& key) const { return !current(key) || !advanced_.empty(); }
    /// Device time of a complete composite over `pixels` [s].
    [[nodiscard]] static double cost(const RenderContext& context, std::uint32_t pixels);
    struct Source {
        std::uint32_t reached = 0;  ///< pixels of the list that have ever had a sum
        bool filtered = false;      ///< take the filtered picture instead of the sum
        kernel::uvec4 drives;       ///< SegmentShading::drives
    };
    /// Composites what is stale of the reached pixels; the others keep the photograph, as does the outline until all
    /// are reached.
    void record(const Slice& slice, const Key& key, const PixelSet& set, const Source& source);

  private:
    std::optional<Key> shown_;
    std::vector<PixelRange> advanced_;  ///< since the last composite
    Bound<gpu::BindGroup, PathInputs, PixelList, Targets> group_, mixedGroup_, silhouetteGroup_;
};

}  // namespace render
