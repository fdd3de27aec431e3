// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/distant_pixels.h"

#include <array>
#include <vector>

namespace core::analysis {

Image<std::uint8_t> findDistantPixels(const ImageF& depth) {
    const int width = depth.width();
    const int height = depth.height();
    const std::size_t large = depth.size() / 50;
    Image<std::uint8_t> distant(width, height, 0);
    Image<std::uint8_t> visited(width, height, 0);
    std::vector<std::array<int, 2>> region;
    for (int startY = 0; startY < height; ++startY) {
        for (int startX = 0; startX < width; ++startX) {
            if (depth(startX, startY) > 0 || visited(startX, startY) != 0) continue;
            region.assign(1, {startX, startY});
            visited(startX, startY) = 1;
            bool open = false;
            for (std::size_t next = 0; next < region.size(); ++next) {
                const auto [x, y] = region[next];
                open = open || x == 0 || y == 0 || x == width - 1 || y == height - 1;
                for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    if (!depth.contains(x + dx, y + dy) || visited(x + dx, y + dy) != 0 || depth(x + dx, y + dy) > 0)
                        continue;
                    visited(x + dx, y + dy) = 1;
                    region.push_back({x + dx, y + dy});
                }
            }
            if (!open && region.size() < large) continue;
            for (const auto& [x, y] : region) {
                bool mixed = false;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        mixed = mixed || (depth.contains(x + dx, y + dy) && depth(x + dx, y + dy) > 0);
                if (!mixed) distant(x, y) = 1;
            }
        }
    }
    return distant;
}

std::optional<Vector3f> distantColor(const Photo& photo, const Image<std::uint8_t>& distant, const Vector3f& d) {
    if (d.z() <= 1e-4f) return std::nullopt;
    const Vector2f uv = photo.camera.project(d);
    if (!(uv.x() >= 0 && uv.y() >= 0 && uv.x() < static_cast<float>(distant.width()) &&
          uv.y() < static_cast<float>(distant.height())))
        return std::nullopt;
    const int x = static_cast<int>(uv.x());
    const int y = static_cast<int>(uv.y());
    if (distant(x, y) == 0) return std::nullopt;
    return photo.color(x, y);
}

}  // namespace core::analysis
