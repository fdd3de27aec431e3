// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/refine_outline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/selection/mask_operations.h"
#include "core/selection/min_cut.h"

namespace core {

namespace {

/// Cost of a boundary where nothing changes, and the part of it that stays where the colour changes most.
constexpr float kBoundaryCost = 1000;
constexpr float kLeastCost = 0.04f;
/// Colour difference (OKLab) that is noise.
constexpr float kNoise = 0.015f;
constexpr std::uint32_t kOutside = 0xffffffffU;
/// Side of the tiles in which colours on both sides are sampled, in radii of the band, and samples along each side.
constexpr int kTileRadii = 2;
constexpr int kTileSamples = 4;
/// Colour difference (OKLab) at which two colours no longer resemble each other.
constexpr float kResemblance = 0.03f;
/// Density that is added to both sides, so that unseen colours tell nothing.
constexpr float kLeastResemblance = 0.02f;
/// Cost per unit of the log-likelihood ratio of a pixel's colour.
constexpr float kColorCost = 60;

/// Directions in which a boundary is measured, and the part of the cost in each: a line costs about its length whatever
/// its direction ([BK03]).
struct OutlineStep {
    int dx, dy;
    float share;
};
constexpr std::array<OutlineStep, 4> kOutlineSteps{{{1, 0, 0.393f}, {0, 1, 0.393f}, {1, 1, 0.278f}, {-1, 1, 0.278f}}};

/// Pixels of the photograph in which the outline may move. Those of one cell of the mask follow each other.
struct Band {
    PixelBox box;  ///< around it, in the photograph
    int factor = 1;
    std::vector<Pixel> pixels;
    Image<std::uint32_t> first;  ///< by cell, relative to the box: number of its first pixel; kOutside beside the band
    int width = 0;               ///< of the photograph
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        if (x < box.x0 || y < box.y0 || x > box.x1 || y > box.y1) return kOutside;
        const int column = (x - box.x0) / factor, row = (y - box.y0) / factor;
        const std::uint32_t number = first(column, row);
        if (number == kOutside) return kOutside;
        const int x0 = box.x0 + column * factor, y0 = box.y0 + row * factor;
        const int across = std::min(factor, width - x0);
        return number + static_cast<std::uint32_t>((y - y0) * across + x - x0);
    }
};

/// Part of the picture in which an outline may move, as an image of its own.
struct Crop {
    PixelBox box;
    BinaryMask mask;
};

Crop cropAround(const BinaryMask& mask, int margin) {
    Crop crop;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (mask(x, y) != 0) crop.box.add({x, y});
    if (crop.box.empty()) return crop;
    crop.box = {std::max(0, crop.box.x0 - margin), std::max(0, crop.box.y0 - margin),
                std::min(mask.width() - 1, crop.box.x1 + margin), std::min(mask.height() - 1, crop.box.y1 + margin)};
    crop.mask = BinaryMask(crop.box.width(), crop.box.height());
    for (int y = 0; y < crop.mask.height(); ++y)
        for (int x = 0; x < crop.mask.width(); ++x) crop.mask(x, y) = mask(crop.box.x0 + x, crop.box.y0 + y);
    return crop;
}

/// Pixels of `mask` that its outline cannot reach: deeper than `radius`, or in parts too narrow to have such a depth.
BinaryMask coreOf(const BinaryMask& mask, int radius) {
    BinaryMask core = shrinkMask(mask, radius);
    const BinaryMask wide = growMask(core, radius + 1);
    for (std::size_t i = 0; i < core.size(); ++i)
        if (mask[i] != 0 && wide[i] == 0) core[i] = 1;
    return core;
}

/// `fixed`: as in refineOutline.
Band bandOf(const Crop& crop, int radius, int factor, const Image<PackedLab>& lab, const BinaryMask& fixed) {
    const BinaryMask inside = coreOf(crop.mask, radius);
    const BinaryMask outside = coreOf(invertMask(crop.mask), radius);
    Band band;
    band.factor = factor;
    band.width = lab.width();
    band.box = {crop.box.x0 * factor, crop.box.y0 * factor, std::min((crop.box.x1 + 1) * factor, lab.width()) - 1,
                std::min((crop.box.y1 + 1) * factor, lab.height()) - 1};
    band.first = Image<std::uint32_t>(crop.mask.width(), crop.mask.height(), kOutside);
    for (int row = 0; row < crop.mask.height(); ++row)
        for (int column = 0; column < crop.mask.width(); ++column) {
            if (inside(column, row) != 0 || outside(column, row) != 0) continue;
            if (!fixed.empty() && fixed(crop.box.x0 + column, crop.box.y0 + row) != 0) continue;
            band.first(column, row) = static_cast<std::uint32_t>(band.pixels.size());
            const int x0 = band.box.x0 + column * factor, y0 = band.box.y0 + row * factor;
            for (int y = y0; y < std::min(y0 + factor, lab.height()); ++y)
                for (int x = x0; x < std::min(x0 + factor, lab.width()); ++x) band.pixels.push_back({x, y});
        }
    return band;
}

BinaryMask enlarged(const BinaryMask& mask, const Image<PackedLab>& lab, int factor) {
    if (factor == 1) return mask;
    BinaryMask large(lab.width(), lab.height());
    for (int y = 0; y < large.height(); ++y) {
        if (y % factor != 0) {
            std::copy_n(&large(0, y - 1), large.width(), &large(0, y));
            continue;
        }
        for (int column = 0; column * factor < large.width(); ++column)
            std::fill_n(&large(column * factor, y), std::min(factor, large.width() - column * factor),
                        mask(column, y / factor));
    }
    return large;
}

/// Cost of a boundary between two neighbours.
float boundaryCost(const Vector3f& a, const Vector3f& b, float scale) {
    return kBoundaryCost * (kLeastCost + std::exp(-(a - b).squaredNorm() * scale));
}

/// 1 / (2 · squared mean contrast) of neighbours in the band. The mean of the squares would be that of a few strong
/// edges, beside which others vanish.
float contrastScale(const Band& band, const Image<PackedLab>& lab) {
    double sum = 0;
    for (const Pixel& p : band.pixels)
        if (p.x + 1 < lab.width())
            sum += static_cast<double>((unpackLab(lab(p.x, p.y)) - unpackLab(lab(p.x + 1, p.y))).norm());
    const double mean = sum / static_cast<double>(band.pixels.size());
    return static_cast<float>(1 / (2 * mean * mean + 2 * static_cast<double>(kNoise * kNoise)));
}

/// Colours beside the band, on both sides of the outline, by tiles.
class SideColors {
  public:
    SideColors(const Band& band, const BinaryMask& mask, const Image<PackedLab>& lab, int tileSize)
        : box_(band.box), size_(tileSize) {
        columns_ = (box_.width() + size_ - 1) / size_;
        rows_ = (box_.height() + size_ - 1) / size_;
        const auto tiles = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
        for (auto& side : samples_) side.resize(tiles);
        const int step = std::max(1, size_ / kTileSamples);
        for (int y = box_.y0 + step / 2; y <= box_.y1; y += step)
            for (int x = box_.x0 + step / 2; x <= box_.x1; x += step)
                if (band.at(x, y) == kOutside)
                    samples_[mask(x, y)][tileOf((x - box_.x0) / size_, (y - box_.y0) / size_)].push_back(
                        unpackLab(lab(x, y)));
    }

    /// Log-likelihood ratio of a colour at a pixel of the band: positive where it looks like the selected side.
    [[nodiscard]] float ratio(const Pixel& p, const Vector3f& color) const {
        const float inside = density(1, p, color), outside = density(0, p, color);
        if (inside < 0 || outside < 0) return 0;
        return std::log((inside + kLeastResemblance) / (outside + kLeastResemblance));
    }

  private:
    [[nodiscard]] std::size_t tileOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    /// Mean resemblance to the samples of one side around a pixel; negative without samples.
    [[nodiscard]] float density(std::size_t side, const Pixel& p, const Vector3f& color) const {
        const int column = (p.x - box_.x0) / size_, row = (p.y - box_.y0) / size_;
        float sum = 0;
        std::size_t count = 0;
        for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
            for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
                for (const Vector3f& sample : samples_[side][tileOf(c, r)]) {
                    const float near = 1 / (1 + (sample - color).squaredNorm() / (kResemblance * kResemblance));
                    sum += near * near;
                    ++count;
                }
        return count == 0 ? -1.0f : sum / static_cast<float>(count);
    }

    PixelBox box_;
    int size_, columns_ = 0, rows_ = 0;
    std::array<std::vector<std::vector<Vector3f>>, 2> samples_;  ///< by side and tile
};

void addPixels(const Band& band, const SideColors& colors, const Image<PackedLab>& lab, MinCut& cut) {
    for (std::uint32_t i = 0; i < band.pixels.size(); ++i) {
        const Pixel& p = band.pixels[i];
        const float cost = kColorCost * colors.ratio(p, unpackLab(lab(p.x, p.y)));
        const auto size = static_cast<MinCut::Capacity>(std::abs(cost));
        cut.addNode(i, cost > 0 ? size : 0, cost > 0 ? 0 : size);
    }
}

void addBoundaries(const Band& band, const BinaryMask& mask, const Image<PackedLab>& lab, MinCut& cut) {
    const float scale = contrastScale(band, lab);
    for (std::uint32_t i = 0; i < band.pixels.size(); ++i) {
        const Pixel p = band.pixels[i];
        const Vector3f color = unpackLab(lab(p.x, p.y));
        for (const OutlineStep& step : kOutlineSteps)
            for (const int sign : {1, -1}) {
                const int x = p.x + sign * step.dx, y = p.y + sign * step.dy;
                if (!lab.contains(x, y)) continue;
                const std::uint32_t other = band.at(x, y);
                if (other != kOutside && sign < 0) continue;
                const auto cost =
                    static_cast<MinCut::Capacity>(step.share * boundaryCost(color, unpackLab(lab(x, y)), scale));
                if (other != kOutside) {
                    cut.addEdge(i, other, cost);
                    continue;
                }
                const bool selected = mask(x, y) != 0;
                cut.addNode(i, selected ? cost : 0, selected ? 0 : cost);
            }
    }
}

}  // namespace

BinaryMask refineOutline(const BinaryMask& mask, const Image<PackedLab>& lab, int factor, int radius,
                         const BinaryMask& fixed, const Progress& progress) {
    BinaryMask result = enlarged(mask, lab, factor);
    const Crop crop = cropAround(mask, 3 * radius + 2);
    if (radius < 1 || crop.box.empty()) return result;
    const Band band = bandOf(crop, radius, factor, lab, fixed);
    if (band.pixels.empty()) return result;
    progress.checkpoint(0.3f);
    MinCut cut(band.pixels.size());
    // In reduced photographs the outline is at the right place already, to a pixel of the reduced one.
    if (factor == 1) addPixels(band, SideColors(band, result, lab, kTileRadii * radius), lab, cut);
    addBoundaries(band, result, lab, cut);
    const std::vector<std::uint8_t> object = cut.solve(progress.part(0.5f, 1.0f));
    for (std::size_t i = 0; i < band.pixels.size(); ++i) result(band.pixels[i].x, band.pixels[i].y) = object[i];
    return result;
}

}  // namespace core
