// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/membrane.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/pixel.h"

namespace core::analysis {
namespace {

using Kind = MembraneCell::Kind;

constexpr float kOverRelaxation = 1.7f;
constexpr int kCoarseSweeps = 100;
constexpr int kSweeps = 12;
/// Width or height [cells] up to which a level has no coarser one.
constexpr int kCoarsest = 8;

/// Means over 2×2 cells, of finite bounds too; a cell with a fixed one in it is fixed.
Image<MembraneCell> coarser(const Image<MembraneCell>& fine) {
    Image<MembraneCell> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
    for (int y = 0; y < coarse.height(); ++y) {
        for (int x = 0; x < coarse.width(); ++x) {
            float fixedSum = 0, freeSum = 0, mostSum = 0;
            int fixed = 0, free = 0, bounded = 0;
            for (int k = 0; k < 4; ++k) {
                const int fx = 2 * x + (k & 1);
                const int fy = 2 * y + (k >> 1);
                if (!fine.contains(fx, fy)) continue;
                const MembraneCell& cell = fine(fx, fy);
                if (cell.kind == Kind::Free) freeSum += cell.value, ++free;
                if (cell.kind == Kind::Fixed) fixedSum += cell.value, ++fixed;
                if (std::isfinite(cell.most)) mostSum += cell.most, ++bounded;
            }
            if (fixed > 0)
                coarse(x, y) = {fixedSum / static_cast<float>(fixed), Kind::Fixed};
            else if (free > 0)
                coarse(x, y) = {freeSum / static_cast<float>(free), Kind::Free};
            if (fixed == 0 && bounded > 0) coarse(x, y).most = mostSum / static_cast<float>(bounded);
        }
    }
    return coarse;
}

void relax(Image<MembraneCell>& cells, const std::vector<Pixel>& free, float factor) {
    for (const auto& [x, y] : free) {
        float sum = 0;
        int count = 0;
        for (const Pixel& step : kNeighbors) {
            if (!cells.contains(x + step.x, y + step.y)) continue;
            const MembraneCell& other = cells(x + step.x, y + step.y);
            if (other.kind == Kind::Outside) continue;
            sum += other.value;
            ++count;
        }
        if (count == 0) continue;
        MembraneCell& cell = cells(x, y);
        cell.value = std::min(cell.value + factor * (sum / static_cast<float>(count) - cell.value), cell.most);
    }
}

}  // namespace

void solveMembrane(Image<MembraneCell>& cells, const Progress& progress) {
    // Coarser levels have a quarter of the cells each, so all of them together take about a third of this one's time.
    constexpr float kCoarserShare = 0.25f;
    progress.checkpoint(0);
    std::vector<Pixel> free;
    for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x)
            if (cells(x, y).kind == Kind::Free) free.push_back({x, y});
    if (free.empty()) return;
    const bool coarsest = cells.width() <= kCoarsest || cells.height() <= kCoarsest;
    if (!coarsest) {
        Image<MembraneCell> coarse = coarser(cells);
        solveMembrane(coarse, progress.part(0, kCoarserShare));
        for (const auto& [x, y] : free) cells(x, y).value = coarse(x / 2, y / 2).value;
    }
    const int sweeps = coarsest ? kCoarseSweeps : kSweeps;
    const Progress own = coarsest ? progress : progress.part(kCoarserShare, 1);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        own.checkpoint(static_cast<float>(sweep) / static_cast<float>(sweeps));
        // Plain relaxation last: it removes the checkerboard that over-relaxation leaves.
        relax(cells, free, sweep + 2 < sweeps ? kOverRelaxation : 1.0f);
    }
}

}  // namespace core::analysis
