// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace core {

struct Pixel {
    int x, y;
};

/// The four neighbours of a pixel: left, right, above, below.
inline constexpr std::array<Pixel, 4> kNeighbors{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Smallest rectangle around pixels, both corners included; empty until a pixel is added.
struct PixelBox {
    int x0 = std::numeric_limits<int>::max(), y0 = std::numeric_limits<int>::max(), x1 = -1, y1 = -1;
    void add(Pixel p) {
        x0 = std::min(x0, p.x);
        y0 = std::min(y0, p.y);
        x1 = std::max(x1, p.x);
        y1 = std::max(y1, p.y);
    }
    void unite(const PixelBox& other) {
        x0 = std::min(x0, other.x0);
        y0 = std::min(y0, other.y0);
        x1 = std::max(x1, other.x1);
        y1 = std::max(y1, other.y1);
    }
    [[nodiscard]] bool empty() const { return x1 < x0 || y1 < y0; }
    [[nodiscard]] int width() const { return x1 - x0 + 1; }
    [[nodiscard]] int height() const { return y1 - y0 + 1; }
    bool operator==(const PixelBox&) const = default;
};

}  // namespace core
