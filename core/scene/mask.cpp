// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/mask.h"

#include <algorithm>

namespace core {

Mask::Mask(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + kTileSize - 1) / kTileSize),
      tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((height + kTileSize - 1) / kTileSize)) {}

Mask::Mask(const ImageF& values) : Mask(values.width(), values.height()) {
    change(0, 0, width_ - 1, height_ - 1, [&](int x, int y, float) { return values(x, y); });
    const Tile zero{};
    for (std::shared_ptr<const Tile>& tile : tiles_)
        if (tile != nullptr && *tile == zero) tile.reset();
}

ImageF Mask::image() const {
    ImageF result(width_, height_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) result(x, y) = value(x, y);
    return result;
}

Mask::Tile& Mask::ownTile(int tx, int ty) {
    std::shared_ptr<const Tile>& slot =
        tiles_[static_cast<std::size_t>(ty) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(tx)];
    // Other masks may share the tile.
    auto own = slot == nullptr ? std::make_shared<Tile>() : std::make_shared<Tile>(*slot);
    Tile& result = *own;
    slot = std::move(own);
    return result;
}

std::pair<int, int> Mask::changedRows(const Mask& other) const {
    CORE_ASSERT(width_ == other.width_ && height_ == other.height_, "masks of one size");
    int first = height_;
    int last = 0;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        if (tiles_[i] == other.tiles_[i]) continue;
        const int top = static_cast<int>(i / static_cast<std::size_t>(columns_)) * kTileSize;
        first = std::min(first, top);
        last = std::max(last, std::min(top + kTileSize, height_));
    }
    return {std::min(first, last), last};
}

std::uint64_t Mask::hash() const {
    std::uint64_t state = 0xCBF29CE484222325ull;  // FNV-1a
    const auto add = [&](std::uint32_t word) { state = (state ^ word) * 0x100000001B3ull; };
    add(static_cast<std::uint32_t>(width_));
    add(static_cast<std::uint32_t>(height_));
    for (const std::shared_ptr<const Tile>& tile : tiles_) {
        const bool zero = tile == nullptr || std::ranges::all_of(*tile, [](std::uint16_t v) { return v == 0; });
        add(zero ? 0 : 1);
        if (zero) continue;
        for (const std::uint16_t v : *tile) add(v);
    }
    return state;
}

}  // namespace core
