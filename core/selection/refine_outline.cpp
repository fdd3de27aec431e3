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

/// Pixels of the photograph in which the outline may move, numbered, and the box around them.
struct Band {
    PixelBox box;
    std::vector<Pixel> pixels;
    Image<std::uint32_t> number;  ///< relative to the box; kOutside beside the band
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        const bool inside = x >= box.x0 && y >= box.y0 && x <= box.x1 && y <= box.y1;
        return inside ? number(x - box.x0, y - box.y0) : kOutside;
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

Band bandOf(const Crop& crop, int radius, int factor, const Image<PackedLab>& lab) {
    const BinaryMask inside = coreOf(crop.mask, radius);
    const BinaryMask outside = coreOf(invertMask(crop.mask), radius);
    Band band;
    band.box = {crop.box.x0 * factor, crop.box.y0 * factor, std::min((crop.box.x1 + 1) * factor, lab.width()) - 1,
                std::min((crop.box.y1 + 1) * factor, lab.height()) - 1};
    band.number = Image<std::uint32_t>(band.box.width(), band.box.height(), kOutside);
    for (int y = 0; y < band.box.height(); ++y)
        for (int x = 0; x < band.box.width(); ++x) {
            if (inside(x / factor, y / factor) != 0 || outside(x / factor, y / factor) != 0) continue;
            band.number(x, y) = static_cast<std::uint32_t>(band.pixels.size());
            band.pixels.push_back({band.box.x0 + x, band.box.y0 + y});
        }
    return band;
}

BinaryMask enlarged(const BinaryMask& mask, const Image<PackedLab>& lab, int factor) {
    if (factor == 1) return mask;
    BinaryMask large(lab.width(), lab.height());
    for (int y = 0; y < large.height(); ++y)
        for (int x = 0; x < large.width(); ++x) large(x, y) = mask(x / factor, y / factor);
    return large;
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

BinaryMask refineOutline(const BinaryMask& mask, const Image<PackedLab>& lab, int factor, int radius,
                         const std::vector<Pixel>& fixed, const Progress& progress) {
    BinaryMask result = enlarged(mask, lab, factor);
    const Crop crop = cropAround(mask, 3 * radius + 2);
    if (radius < 1 || crop.box.empty()) return result;
    const Band band = bandOf(crop, radius, factor, lab);
    if (band.pixels.empty()) return result;
    progress.checkpoint(0.3f);
    MinCut cut(band.pixels.size());
    const float scale = contrastScale(band, lab);
    for (std::uint32_t i = 0; i < band.pixels.size(); ++i) {
        const Pixel p = band.pixels[i];
        for (const Pixel& step : kNeighbors) {
            const int x = p.x + step.x, y = p.y + step.y;
            if (!lab.contains(x, y)) continue;
            const MinCut::Capacity cost = boundaryCost(lab(p.x, p.y), lab(x, y), scale);
            const std::uint32_t other = band.at(x, y);
            const bool selected = result(x, y) != 0;
            if (other == kOutside)
                cut.addNode(i, selected ? cost : 0, selected ? 0 : cost);
            else if (step.x + step.y > 0)
                cut.addEdge(i, other, cost);
        }
    }
    for (const Pixel& p : fixed) {
        if (band.at(p.x, p.y) == kOutside) continue;
        const bool selected = result(p.x, p.y) != 0;
        cut.addNode(band.at(p.x, p.y), selected ? MinCut::kMaxCapacity : 0, selected ? 0 : MinCut::kMaxCapacity);
    }
    const std::vector<std::uint8_t> object = cut.solve(progress.part(0.5f, 1.0f));
    for (std::size_t i = 0; i < band.pixels.size(); ++i) result(band.pixels[i].x, band.pixels[i].y) = object[i];
    return result;
}

}  // namespace core
