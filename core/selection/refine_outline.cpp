// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/refine_outline.h"

#include <algorithm>
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

/// Pixels of the band in the box around it, numbered; kOutside elsewhere.
struct Band {
    PixelBox box;
    std::vector<Pixel> pixels;
    Image<std::uint32_t> number;  ///< relative to the box
    [[nodiscard]] std::uint32_t at(int x, int y) const { return number(x - box.x0, y - box.y0); }
    [[nodiscard]] bool contains(int x, int y) const { return x >= box.x0 && y >= box.y0 && x <= box.x1 && y <= box.y1; }
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

Band bandOf(const Crop& crop, int radius) {
    const BinaryMask inside = coreOf(crop.mask, radius);
    const BinaryMask outside = coreOf(invertMask(crop.mask), radius);
    Band band;
    band.box = crop.box;
    band.number = Image<std::uint32_t>(crop.mask.width(), crop.mask.height(), kOutside);
    for (int y = 0; y < crop.mask.height(); ++y)
        for (int x = 0; x < crop.mask.width(); ++x) {
            if (inside(x, y) != 0 || outside(x, y) != 0) continue;
            band.number(x, y) = static_cast<std::uint32_t>(band.pixels.size());
            band.pixels.push_back({crop.box.x0 + x, crop.box.y0 + y});
        }
    return band;
}

/// Cost of a boundary between two neighbours.
MinCut::Capacity boundaryCost(const PackedLab& a, const PackedLab& b, float scale) {
    const float difference = (unpackLab(a) - unpackLab(b)).squaredNorm();
    return static_cast<MinCut::Capacity>(kBoundaryCost * (kLeastCost + std::exp(-difference * scale)));
}

/// 1 / (2 · mean square contrast) of neighbours in the band.
float contrastScale(const Band& band, const Image<PackedLab>& lab) {
    double sum = 0;
    for (const Pixel& p : band.pixels)
        if (p.x + 1 < lab.width())
            sum += static_cast<double>((unpackLab(lab(p.x, p.y)) - unpackLab(lab(p.x + 1, p.y))).squaredNorm());
    const double mean = sum / static_cast<double>(band.pixels.size());
    return static_cast<float>(1 / (2 * mean + 2 * static_cast<double>(kNoise * kNoise)));
}

}  // namespace

void refineOutline(BinaryMask& mask, const Image<PackedLab>& lab, int radius, const std::vector<Pixel>& fixed,
                   const Progress& progress) {
    if (radius < 1) return;
    const Crop crop = cropAround(mask, 3 * radius + 2);
    if (crop.box.empty()) return;
    const Band band = bandOf(crop, radius);
    if (band.pixels.empty()) return;
    progress.checkpoint(0.2f);
    MinCut cut(band.pixels.size());
    const float scale = contrastScale(band, lab);
    for (std::uint32_t i = 0; i < band.pixels.size(); ++i) {
        const Pixel p = band.pixels[i];
        for (const Pixel& step : kNeighbors) {
            const int x = p.x + step.x, y = p.y + step.y;
            if (!lab.contains(x, y)) continue;
            const MinCut::Capacity cost = boundaryCost(lab(p.x, p.y), lab(x, y), scale);
            const std::uint32_t other = band.contains(x, y) ? band.at(x, y) : kOutside;
            if (other == kOutside)
                cut.addNode(i, mask(x, y) != 0 ? cost : 0, mask(x, y) != 0 ? 0 : cost);
            else if (step.x + step.y > 0)
                cut.addEdge(i, other, cost);
        }
    }
    for (const Pixel& p : fixed)
        if (band.contains(p.x, p.y) && band.at(p.x, p.y) != kOutside)
            cut.addNode(band.at(p.x, p.y), mask(p.x, p.y) != 0 ? MinCut::kMaxCapacity : 0,
                        mask(p.x, p.y) != 0 ? 0 : MinCut::kMaxCapacity);
    const std::vector<std::uint8_t> object = cut.solve(progress.part(0.5f, 1.0f));
    for (std::size_t i = 0; i < band.pixels.size(); ++i) mask(band.pixels[i].x, band.pixels[i].y) = object[i];
}

}  // namespace core
