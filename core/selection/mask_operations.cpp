// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/mask_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

/// Vertical distance of each pixel to the next one with `value` in its column, at most `limit` + 1.
Image<int> columnDistance(const BinaryMask& mask, std::uint8_t value, int limit) {
    Image<int> distance(mask.width(), mask.height(), limit + 1);
    const auto relax = [&](int y, int from) {
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == value)
                distance(x, y) = 0;
            else if (from >= 0 && from < mask.height())
                distance(x, y) = std::min(distance(x, y), distance(x, from) + 1);
        }
    };
    for (int y = 0; y < mask.height(); ++y) relax(y, y - 1);
    for (int y = mask.height() - 1; y >= 0; --y) relax(y, y + 1);
    return distance;
}

/// Sets to `value` all pixels within `radius` of one that has it: each column reaches sideways as far as the circle.
BinaryMask spread(const BinaryMask& mask, std::uint8_t value, int radius) {
    if (radius <= 0 || mask.empty()) return mask;
    const int limit = std::min(radius, std::max(mask.width(), mask.height()));
    const Image<int> distance = columnDistance(mask, value, limit);
    std::vector<int> reach(static_cast<std::size_t>(limit) + 1);
    for (int d = 0; d <= limit; ++d)
        reach[static_cast<std::size_t>(d)] =
            static_cast<int>(std::sqrt(static_cast<double>(limit) * limit - static_cast<double>(d) * d));
    BinaryMask result = mask;
    std::vector<int> covered(static_cast<std::size_t>(mask.width()) + 1);
    for (int y = 0; y < mask.height(); ++y) {
        std::ranges::fill(covered, 0);
        for (int x = 0; x < mask.width(); ++x) {
            const int d = distance(x, y);
            if (d > limit) continue;
            ++covered[static_cast<std::size_t>(std::max(0, x - reach[static_cast<std::size_t>(d)]))];
            --covered[static_cast<std::size_t>(std::min(mask.width(), x + reach[static_cast<std::size_t>(d)] + 1))];
        }
        int count = 0;
        for (int x = 0; x < mask.width(); ++x) {
            count += covered[static_cast<std::size_t>(x)];
            if (count > 0) result(x, y) = value;
        }
    }
    return result;
}

/// Marks with 2 the pixels of value `from` that are connected with one of `open`.
void floodFrom(BinaryMask& mask, std::uint8_t from, std::vector<Pixel> open) {
    for (const Pixel& p : open) mask(p.x, p.y) = 2;
    while (!open.empty()) {
        const Pixel p = open.back();
        open.pop_back();
        for (const Pixel& step : kNeighbors) {
            const int x = p.x + step.x, y = p.y + step.y;
            if (!mask.contains(x, y) || mask(x, y) != from) continue;
            mask(x, y) = 2;
            open.push_back({x, y});
        }
    }
}

}  // namespace

BinaryMask growMask(const BinaryMask& mask, int radius) { return spread(mask, 1, radius); }

BinaryMask shrinkMask(const BinaryMask& mask, int radius) { return spread(mask, 0, radius); }

BinaryMask invertMask(const BinaryMask& mask) {
    BinaryMask result = mask;
    for (std::uint8_t& value : result.pixels()) value = value == 0 ? 1 : 0;
    return result;
}

BinaryMask fillHoles(const BinaryMask& mask) {
    BinaryMask result = mask;
    std::vector<Pixel> open;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            const bool edge = x == 0 || y == 0 || x + 1 == mask.width() || y + 1 == mask.height();
            if (edge && mask(x, y) == 0) open.push_back({x, y});
        }
    floodFrom(result, 0, std::move(open));
    for (std::uint8_t& value : result.pixels()) value = value == 2 ? 0 : 1;
    return result;
}

BinaryMask smoothMask(const BinaryMask& mask, int radius) {
    if (radius <= 0 || mask.empty()) return mask;
    // Sums along rows, so that a disc costs its height only.
    Image<int> sums(mask.width() + 1, mask.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) sums(x + 1, y) = sums(x, y) + mask(x, y);
    BinaryMask result(mask.width(), mask.height());
    const int limit = std::min(radius, std::max(mask.width(), mask.height()));
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            int selected = 0, count = 0;
            for (int d = -limit; d <= limit; ++d) {
                if (y + d < 0 || y + d >= mask.height()) continue;
                const int half =
                    static_cast<int>(std::sqrt(static_cast<double>(limit) * limit - static_cast<double>(d) * d));
                const int x0 = std::max(0, x - half), x1 = std::min(mask.width(), x + half + 1);
                selected += sums(x1, y + d) - sums(x0, y + d);
                count += x1 - x0;
            }
            result(x, y) = 2 * selected > count || (2 * selected == count && mask(x, y) != 0) ? 1 : 0;
        }
    return result;
}

BinaryMask piecesUnder(const BinaryMask& mask, const std::vector<Pixel>& pixels) {
    BinaryMask result = mask;
    std::vector<Pixel> open;
    for (const Pixel& p : pixels)
        if (mask.contains(p.x, p.y) && mask(p.x, p.y) == 1) open.push_back(p);
    floodFrom(result, 1, std::move(open));
    for (std::uint8_t& value : result.pixels()) value = value == 2 ? 1 : 0;
    return result;
}

}  // namespace core
