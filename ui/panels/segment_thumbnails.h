// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCache>
#include <QIcon>
#include <QImage>
#include <cstdint>

#include "core/scene/scene.h"
#include "core/scene/segment_areas.h"

namespace ui {

/// A segment as it is in the photograph, display-encoded, with its surroundings dimmed. Transparent where the
/// photograph ends. Takes about as long whatever the photograph's size is.
[[nodiscard]] QImage segmentThumbnail(const core::Photo& photo, std::uint16_t label, const core::SegmentExtent& extent,
                                      const QSize& size);

/// Thumbnails of one photograph, made when they are asked for and again when the segment's pixels have changed.
class SegmentThumbnails {
  public:
    static constexpr int kWidth = 40, kHeight = 30;  ///< in logical pixels, without the swatch
    static constexpr int kSwatchWidth = 5;           ///< bar of the segment's colour to the left

    /// The same picture in selected rows.
    [[nodiscard]] QIcon find(const core::Photo& photo, std::uint16_t label, const core::SegmentExtent& extent,
                             double devicePixelRatio);

  private:
    struct Entry {
        std::uint64_t hash = 0;
        double ratio = 1;
        QIcon icon;
    };
    core::SharedImage<core::Vector3f> color_;  ///< of the photograph that they show
    QCache<std::uint16_t, Entry> entries_{1000};
};

}  // namespace ui
