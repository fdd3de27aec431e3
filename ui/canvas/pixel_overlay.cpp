// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/pixel_overlay.h"

#include <algorithm>

#include "shaders/shared/canvas_block.h"

namespace ui {

void PixelOverlay::reset(int width, int height) {
    codes_ = core::Image<std::uint8_t>(width, height);
    bounds_ = {};
    firstChanged_ = 0;
    lastChanged_ = height;
}

void PixelOverlay::show(const core::BinaryMask* selected, const core::BinaryMask* preview) {
    const bool nothing = selected == nullptr && preview == nullptr;
    // What was marked and is not any longer has to be cleared, the rest is clear.
    const core::PixelBox before = bounds_;
    bounds_ = {};
    mark(selected, preview, nothing ? before : core::PixelBox{0, 0, codes_.width() - 1, codes_.height() - 1});
}

void PixelOverlay::showPart(const core::BinaryMask* selected, const core::BinaryMask* preview,
                            const core::PixelBox& box) {
    mark(selected, preview, box);
}

void PixelOverlay::mark(const core::BinaryMask* selected, const core::BinaryMask* preview, const core::PixelBox& box) {
    CORE_ASSERT(selected == nullptr || selected->sameSize(codes_), "a selection of the picture's size");
    CORE_ASSERT(preview == nullptr || preview->sameSize(codes_), "a selection of the picture's size");
    for (int y = box.y0; y <= box.y1; ++y) {
        int first = codes_.width(), last = -1;
        bool changed = false;
        for (int x = box.x0; x <= box.x1; ++x) {
            const std::size_t i = codes_.index(x, y);
            const bool is = selected != nullptr && (*selected)[i] != 0;
            const bool becomes = preview == nullptr ? is : (*preview)[i] != 0;
            const auto code =
                static_cast<std::uint8_t>((is ? SELECTION_IS : 0U) | (is && !becomes ? SELECTION_LEAVES : 0U) |
                                          (!is && becomes ? SELECTION_JOINS : 0U));
            if (code != 0) {
                first = std::min(first, x);
                last = x;
            }
            if (codes_[i] == code) continue;
            codes_[i] = code;
            changed = true;
        }
        if (last >= 0) bounds_.unite({first, y, last, y});
        if (!changed) continue;
        firstChanged_ = std::min(firstChanged_, y);
        lastChanged_ = std::max(lastChanged_, y + 1);
    }
}

std::pair<int, int> PixelOverlay::takeChangedRows() {
    const std::pair<int, int> rows(firstChanged_, std::max(firstChanged_, lastChanged_));
    firstChanged_ = codes_.height();
    lastChanged_ = 0;
    return rows;
}

}  // namespace ui
