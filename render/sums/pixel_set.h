// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <vector>

#include "core/shading/silhouette.h"
#include "render/render_context.h"
#include "render/shaded_scene.h"

namespace render {

/// The pixels of one segment, and those at its outline that show it in part. Found on another thread; found again when
/// the key changes.
class PixelSet {
  public:
    struct Key {
        PictureLayers layers;
        std::uint16_t label = 0;
        bool glossy = false;
        std::vector<std::uint8_t> edited;  ///< by label: which segments border on others that stay as they are
        bool operator==(const Key&) const = default;
    };

    void follow(Key key) { wanted_ = std::move(key); }
    /// Continues to find the pixels, waiting for them for up to `seconds`; true when they are on the device.
    [[nodiscard]] bool ready(RenderContext& context, double seconds);

    /// False until the pixels were found for the first time.
    [[nodiscard]] bool found() const { return static_cast<bool>(pixels_.buffer); }
    /// The pixels in the order of a sweep.
    [[nodiscard]] const PixelList& pixels() const { return pixels_; }
    /// Pixels at the outline; the buffer holds kernel::MixedPixel.
    [[nodiscard]] const PixelList& silhouette() const { return silhouette_; }
    /// Those of the silhouette that belong to the segment itself.
    [[nodiscard]] const PixelList& mixedInside() const { return mixedInside_; }
    /// Number of outlines found so far.
    [[nodiscard]] std::uint64_t silhouetteVersion() const { return silhouetteVersion_; }

  private:
    struct Found {
        std::vector<std::uint32_t> list;  ///< x | y << 16
        core::PixelBox bounds;
        std::vector<core::SilhouettePixel> silhouette;
    };
    static Found find(const Key& key);
    void upload(RenderContext& context, const Found& found);

    Key wanted_, finding_, found_;
    std::future<Found> pending_;  ///< valid while pixels are being found
    PixelList pixels_, silhouette_, mixedInside_;
    std::uint64_t silhouetteVersion_ = 0;
};

}  // namespace render
