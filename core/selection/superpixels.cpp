// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/superpixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/pixel.h"

namespace core {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
/// Rows, or queue entries, between two checkpoints.
constexpr int kRowsPerCheckpoint = 16;
constexpr std::size_t kEntriesPerCheckpoint = 1U << 14U;
/// Longest gap of farther pixels that is bridged [px], and largest relative difference of 1/z across it.
constexpr int kMaxGap = 24;
constexpr float kGapStep = 0.03f;
/// Strength of a bridged gap.
constexpr float kGapStrength = 0.3f;

/// Boundary strength between a pixel and its neighbour `direction` of kNeighbors.
std::uint8_t strengthTowards(const BoundaryStrength& boundary, int x, int y, std::size_t direction) {
    switch (direction) {
        case 0:
            return boundary.right(x - 1, y);
        case 1:
            return boundary.right(x, y);
        case 2:
            return boundary.down(x, y - 1);
        default:
            return boundary.down(x, y);
    }
}

int strongestAround(const BoundaryStrength& boundary, int x, int y) {
    int strongest = 0;
    for (std::size_t k = 0; k < kNeighbors.size(); ++k)
        if (boundary.right.contains(x + kNeighbors[k].x, y + kNeighbors[k].y))
            strongest = std::max(strongest, static_cast<int>(strengthTowards(boundary, x, y, k)));
    return strongest;
}

/// The calmest pixel of a grid cell, near its middle where several are equally calm.
Pixel basinOf(const BoundaryStrength& boundary, int x0, int y0, int cellSize) {
    Pixel best{x0, y0};
    float least = std::numeric_limits<float>::max();
    const float middle = 0.5f * static_cast<float>(cellSize - 1);
    for (int y = y0; y < std::min(y0 + cellSize, boundary.right.height()); ++y)
        for (int x = x0; x < std::min(x0 + cellSize, boundary.right.width()); ++x) {
            const float dx = static_cast<float>(x - x0) - middle;
            const float dy = static_cast<float>(y - y0) - middle;
            const float cost = static_cast<float>(strongestAround(boundary, x, y)) + 0.2f * (dx * dx + dy * dy);
            if (cost >= least) continue;
            least = cost;
            best = {x, y};
        }
    return best;
}

/// Grows the basins over ever stronger boundaries (a watershed cut, [CBNC09]).
void flood(const BoundaryStrength& boundary, Image<std::uint32_t>& index, const Progress& progress) {
    struct Entry {
        std::uint32_t pixel, basin;
    };
    std::array<std::vector<Entry>, 256> queues;
    std::array<std::size_t, 256> heads{};
    const int width = index.width();
    const auto push = [&](std::size_t pixel, std::uint32_t basin, int level) {
        const int x = static_cast<int>(pixel % static_cast<std::size_t>(width));
        const int y = static_cast<int>(pixel / static_cast<std::size_t>(width));
        int lowest = 256;
        for (std::size_t k = 0; k < kNeighbors.size(); ++k) {
            const int nx = x + kNeighbors[k].x, ny = y + kNeighbors[k].y;
            if (!index.contains(nx, ny) || index(nx, ny) != kNone) continue;
            const int to = std::max(level, static_cast<int>(strengthTowards(boundary, x, y, k)));
            queues[static_cast<std::size_t>(to)].push_back({static_cast<std::uint32_t>(index.index(nx, ny)), basin});
            lowest = std::min(lowest, to);
        }
        return lowest;
    };
    for (std::size_t i = 0; i < index.size(); ++i)
        if (index[i] != kNone) push(i, index[i], 0);
    std::size_t handled = 0;
    for (int level = 0; level < 256; ++level) {
        auto& queue = queues[static_cast<std::size_t>(level)];
        for (std::size_t& head = heads[static_cast<std::size_t>(level)]; head < queue.size(); ++head) {
            if (++handled % kEntriesPerCheckpoint == 0)
                progress.checkpoint(
                    std::min(1.0f, static_cast<float>(handled) / (3 * static_cast<float>(index.size()))));
            const Entry entry = queue[head];
            if (index[entry.pixel] != kNone) continue;
            index[entry.pixel] = entry.basin;
            push(entry.pixel, entry.basin, level);
        }
        queue = {};
    }
}

void describeSuperpixels(const SelectionPicture& picture, Superpixels& result) {
    const auto& index = result.index;
    for (int y = 0; y < index.height(); ++y)
        for (int x = 0; x < index.width(); ++x) {
            Superpixel& s = result.superpixels[index(x, y)];
            s.area += 1;
            s.x += static_cast<float>(x) + 0.5f;
            s.y += static_cast<float>(y) + 0.5f;
            s.border += static_cast<float>((x == 0) + (y == 0) + (x + 1 == index.width()) + (y + 1 == index.height()));
            s.lab += picture.lab(x, y);
            if (!(picture.inverseDepth(x, y) > 0)) continue;
            s.depthArea += 1;
            s.inverseDepth += picture.inverseDepth(x, y);
            s.normal += picture.normal(x, y);
        }
    for (Superpixel& s : result.superpixels) {
        s.lab /= s.area;
        s.x /= s.area;
        s.y /= s.area;
        if (s.depthArea > 0) s.inverseDepth /= s.depthArea, s.normal /= s.depthArea;
    }
}

/// A piece of border, before equal pairs are added up.
struct BorderPiece {
    std::uint32_t a, b;
    float length, strength, firmness;
};

/// Share of a boundary in which it is clearly one.
float firmnessOf(float strength) {
    const float t = std::clamp((strength - 0.10f) / 0.40f, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

void addPiece(std::vector<BorderPiece>& pieces, std::uint32_t a, std::uint32_t b, float length, float strength) {
    if (a == b) return;
    pieces.push_back({std::min(a, b), std::max(a, b), length, length * strength, length * firmnessOf(strength)});
}

/// Links superpixels of one surface on both sides of a narrow gap through which something farther is seen, or of a thin
/// thing in front, along one line of pixels.
void bridgeGaps(const SelectionPicture& picture, const Superpixels& result, int line, bool vertical,
                std::vector<BorderPiece>& pieces) {
    const ImageF& w = picture.inverseDepth;
    const int length = vertical ? w.height() : w.width();
    const auto depthAt = [&](int i) { return vertical ? w(line, i) : w(i, line); };
    const auto indexAt = [&](int i) { return vertical ? result.index(line, i) : result.index(i, line); };
    const float step = kGapStep + 4 * picture.quality.noise;
    for (int i = 0; i + 2 < length; ++i) {
        const float here = depthAt(i);
        if (!(here > 0) || !(depthAt(i + 1) < here * (1 - step))) continue;
        for (int k = 2; k <= kMaxGap && i + k < length; ++k) {
            const float there = depthAt(i + k);
            if (there < here * (1 - step)) continue;
            if (there < here * (1 + step)) addPiece(pieces, indexAt(i), indexAt(i + k), 1, kGapStrength);
            break;
        }
    }
}

void findBorders(const SelectionPicture& picture, const BoundaryStrength& boundary, Superpixels& result) {
    const auto& index = result.index;
    std::vector<BorderPiece> pieces;
    for (int y = 0; y < index.height(); ++y)
        for (int x = 0; x < index.width(); ++x) {
            if (x + 1 < index.width())
                addPiece(pieces, index(x, y), index(x + 1, y), 1, static_cast<float>(boundary.right(x, y)) / 255);
            if (y + 1 < index.height())
                addPiece(pieces, index(x, y), index(x, y + 1), 1, static_cast<float>(boundary.down(x, y)) / 255);
        }
    if (picture.quality.present) {
        for (int y = 0; y < index.height(); ++y) bridgeGaps(picture, result, y, false, pieces);
        for (int x = 0; x < index.width(); ++x) bridgeGaps(picture, result, x, true, pieces);
    }
    // Stable, so that sums of floats are always taken in the same order.
    std::ranges::stable_sort(
        pieces, [](const BorderPiece& p, const BorderPiece& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
    for (const BorderPiece& piece : pieces) {
        if (result.borders.empty() || result.borders.back().a != piece.a || result.borders.back().b != piece.b)
            result.borders.push_back({piece.a, piece.b, 0, 0, 0});
        SuperpixelBorder& border = result.borders.back();
        border.length += piece.length;
        border.strength += piece.strength;
        border.firmness += piece.firmness;
    }
    for (SuperpixelBorder& border : result.borders) border.strength /= border.length, border.firmness /= border.length;
}

}  // namespace

Superpixels findSuperpixels(const SelectionPicture& picture, const BoundaryStrength& boundary, int cellSize,
                            const Progress& progress) {
    Superpixels result;
    const int width = boundary.right.width();
    const int height = boundary.right.height();
    result.index = Image<std::uint32_t>(width, height, kNone);
    std::uint32_t count = 0;
    for (int y = 0, row = 0; y < height; y += cellSize, ++row) {
        if (row % kRowsPerCheckpoint == 0)
            progress.checkpoint(0.2f * static_cast<float>(y) / static_cast<float>(height));
        for (int x = 0; x < width; x += cellSize) {
            const Pixel basin = basinOf(boundary, x, y, cellSize);
            result.index(basin.x, basin.y) = count++;
        }
    }
    flood(boundary, result.index, progress.part(0.2f, 0.6f));
    result.superpixels.resize(count);
    describeSuperpixels(picture, result);
    progress.checkpoint(0.7f);
    findBorders(picture, boundary, result);
    progress.checkpoint(1);
    return result;
}

}  // namespace core
