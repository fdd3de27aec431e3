// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/base/binary_mask.h"
#include "core/base/pixel.h"

namespace ui {

/// Marks over the picture: what is selected, and what a selection in progress would change. Codes a pixel
/// (SELECTION_* of shaders/shared/canvas_block.h), kept here so that they survive the loss of the device.
class PixelOverlay {
  public:
    /// Nothing is marked in a picture of this size.
    void reset(int width, int height);
    /// `selected` is selected and would become `preview`. Both have the picture's size; nullptr: nothing is selected,
    /// nothing is previewed.
    void show(const core::BinaryMask* selected, const core::BinaryMask* preview);
    /// The same where both are as they were shown last outside `box`.
    void showPart(const core::BinaryMask* selected, const core::BinaryMask* preview, const core::PixelBox& box);

    [[nodiscard]] const core::Image<std::uint8_t>& codes() const { return codes_; }
    /// A box around all marks; empty if there are none.
    [[nodiscard]] const core::PixelBox& bounds() const { return bounds_; }
    /// Rows [first, last) that have changed since the last call.
    [[nodiscard]] std::pair<int, int> takeChangedRows();

  private:
    void mark(const core::BinaryMask* selected, const core::BinaryMask* preview, const core::PixelBox& box);

    core::Image<std::uint8_t> codes_;
    core::PixelBox bounds_;
    int firstChanged_ = 0;
    int lastChanged_ = 0;  ///< one past the last
};

}  // namespace ui
