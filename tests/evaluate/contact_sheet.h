// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/image.h"

namespace evaluate {

/// Rows of small pictures of one size with captions, for looking at many results at once.
class ContactSheet {
  public:
    struct Cell {
        std::string caption;
        core::ImageRgb picture;  ///< display-encoded, any size; an empty one leaves the cell free
    };

    /// Size of a cell's picture [px]; its caption comes on top of that.
    ContactSheet(int cellWidth, int cellHeight) : cellWidth_(cellWidth), cellHeight_(cellHeight) {}
    void addRow(std::vector<Cell> cells);
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    /// 8-bit PNG. Throws core::Error(Output).
    void save(const std::string& path) const;

  private:
    int cellWidth_;
    int cellHeight_;
    std::vector<std::vector<Cell>> rows_;
};

/// Draws one line of text, white on what is there, top left corner at (x, y): capitals 5 × 7 pixels, 6 apart. Small
/// letters are drawn as capitals, characters without a shape as blanks.
void drawText(core::ImageRgb& picture, int x, int y, std::string_view text);

}  // namespace evaluate
