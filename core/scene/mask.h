// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/image.h"

namespace core {

/// Numbers in [0, 1] for every pixel of a photograph, 16 bit each, in tiles that copies share: a copy with one more
/// brush stroke costs only the tiles that the stroke touched.
class Mask {
  public:
    static constexpr int kTileSize = 64;
    static constexpr float kSteps = 65535;

    Mask() = default;
    /// All zero.
    Mask(int width, int height);
    /// Values are clamped to [0, 1] and rounded to 16 bit; NaN becomes 0.
    explicit Mask(const ImageF& values);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// Path of its file; "" = not saved yet.
    [[nodiscard]] const std::string& path() const { return path_; }
    void setPath(std::string path) { path_ = std::move(path); }

    [[nodiscard]] float value(int x, int y) const {
        CORE_ASSERT(x >= 0 && y >= 0 && x < width_ && y < height_, "pixel outside the mask");
        const Tile* tile = tiles_[tileIndex(x, y)].get();
        return tile == nullptr ? 0.0f : static_cast<float>((*tile)[inTile(x, y)]) / kSteps;
    }
    [[nodiscard]] ImageF image() const;

    /// Replaces values in a rectangle, cut to the mask: `change(x, y, old)` returns the new one. Forgets the path.
    template <class Change>
    void change(int x0, int y0, int x1, int y1, const Change& change) {
        x0 = std::max(x0, 0);
        y0 = std::max(y0, 0);
        x1 = std::min(x1, width_ - 1);
        y1 = std::min(y1, height_ - 1);
        if (x0 > x1 || y0 > y1) return;
        path_.clear();
        for (int ty = y0 / kTileSize; ty <= y1 / kTileSize; ++ty)
            for (int tx = x0 / kTileSize; tx <= x1 / kTileSize; ++tx) {
                Tile& tile = ownTile(tx, ty);
                for (int y = std::max(y0, ty * kTileSize); y <= std::min(y1, ty * kTileSize + kTileSize - 1); ++y)
                    for (int x = std::max(x0, tx * kTileSize); x <= std::min(x1, tx * kTileSize + kTileSize - 1); ++x) {
                        std::uint16_t& stored = tile[inTile(x, y)];
                        stored = store(change(x, y, static_cast<float>(stored) / kSteps));
                    }
            }
    }

    /// First and one past the last row in which the tiles of two masks of one size differ; equal = none.
    [[nodiscard]] std::pair<int, int> changedRows(const Mask& other) const;
    /// Hash of size and values.
    [[nodiscard]] std::uint64_t hash() const;

  private:
    using Tile = std::array<std::uint16_t, std::size_t{kTileSize} * kTileSize>;
    [[nodiscard]] static std::uint16_t store(float value) {
        return value > 0 ? static_cast<std::uint16_t>(std::lround(std::min(value, 1.0f) * kSteps)) : std::uint16_t{0};
    }
    [[nodiscard]] std::size_t tileIndex(int x, int y) const {
        return static_cast<std::size_t>(y / kTileSize) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(x / kTileSize);
    }
    [[nodiscard]] static std::size_t inTile(int x, int y) {
        return static_cast<std::size_t>(y % kTileSize) * kTileSize + static_cast<std::size_t>(x % kTileSize);
    }
    [[nodiscard]] Tile& ownTile(int tx, int ty);

    int width_ = 0;
    int height_ = 0;
    int columns_ = 0;
    std::vector<std::shared_ptr<const Tile>> tiles_;  ///< nullptr = all zero
    std::string path_;
};

}  // namespace core
