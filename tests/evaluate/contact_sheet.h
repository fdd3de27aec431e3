// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/image.h"

namespace evaluate {

/// Rows of small pictures of one size with captions: an overview of many results.
class ContactSheet {
  public:
    struct Cell {
        std::string caption;
        core::ImageRgb picture;  ///< display-encoded, any size; empty = no picture
    };

    /// Size of a cell's picture [px], without its caption.
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

/// Draws one line of white text with its top left corner at (x, y): capitals of 5 × 7 pixels, 6 pixels apart. Small
/// letters are drawn as capitals, unknown characters as blanks.
void drawText(core::ImageRgb& picture, int x, int y, std::string_view text);

}  // namespace evaluate
