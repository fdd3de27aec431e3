// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/distant_pixels.h"

#include <vector>

#include "core/base/pixel.h"

namespace core::analysis {

namespace {

/// Pixels without depth that are connected by their sides.
struct EmptyRegion {
    std::vector<Pixel> pixels;
    bool reachesBorder = false;
};

/// The region around `start`, whose pixels are marked as visited.
EmptyRegion floodEmpty(const ImageF& depth, Pixel start, Image<std::uint8_t>& visited) {
    EmptyRegion region{.pixels = {start}};
    visited(start.x, start.y) = 1;
    for (std::size_t next = 0; next < region.pixels.size(); ++next) {
        const auto [x, y] = region.pixels[next];
        region.reachesBorder =
            region.reachesBorder || x == 0 || y == 0 || x == depth.width() - 1 || y == depth.height() - 1;
        for (const Pixel& step : kNeighbors) {
            const int u = x + step.x;
            const int v = y + step.y;
            if (!depth.contains(u, v) || visited(u, v) != 0 || depth(u, v) > 0) continue;
            visited(u, v) = 1;
            region.pixels.push_back({u, v});
        }
    }
    return region;
}

bool hasDepthAround(const ImageF& depth, Pixel p) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (depth.contains(p.x + dx, p.y + dy) && depth(p.x + dx, p.y + dy) > 0) return true;
    return false;
}

}  // namespace

Image<std::uint8_t> findDistantPixels(const ImageF& depth) {
    const std::size_t large = depth.size() / 50;
    Image<std::uint8_t> distant(depth.width(), depth.height(), 0);
    Image<std::uint8_t> visited(depth.width(), depth.height(), 0);
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (depth(x, y) > 0 || visited(x, y) != 0) continue;
            const EmptyRegion region = floodEmpty(depth, {x, y}, visited);
            if (!region.reachesBorder && region.pixels.size() < large) continue;
            for (const Pixel& p : region.pixels)
                if (!hasDepthAround(depth, p)) distant(p.x, p.y) = 1;
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
