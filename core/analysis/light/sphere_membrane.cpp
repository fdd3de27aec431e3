// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/sphere_membrane.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

namespace core::analysis {

std::vector<MembraneRow> membraneRows(int height, float screen) {
    const double step = std::numbers::pi / height;
    std::vector<MembraneRow> rows(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const double middle = std::sin((y + 0.5) * step);
        const double up = std::sin(y * step);
        const double down = std::sin((y + 1) * step);
        const double side = 1 / middle;
        const double absorbed = screen > 0 ? middle * step * step / static_cast<double>(screen * screen) : 0;
        rows[static_cast<std::size_t>(y)] = {static_cast<float>(up), static_cast<float>(down), static_cast<float>(side),
                                             static_cast<float>(1 / (up + down + 2 * side + absorbed))};
    }
    return rows;
}

void relaxMembrane(const ImageF& coverage, std::span<const MembraneRow> rows, ImageRgb& values,
                   const Progress& progress) {
    const int width = values.width();
    const int height = values.height();
    for (int sweep = 0; sweep < kMembraneSweeps; ++sweep) {
        progress.checkpoint(static_cast<float>(sweep) / kMembraneSweeps);
        for (int parity = 0; parity < 2; ++parity) {
            tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const tbb::blocked_range<int>& range) {
                for (int y = range.begin(); y != range.end(); ++y) {
                    const MembraneRow& row = rows[static_cast<std::size_t>(y)];
                    for (int x = (y + parity) % 2; x < width; x += 2) {
                        if (coverage(x, y) > 0) continue;
                        Vector3f sum = row.side * (values((x + 1) % width, y) + values((x + width - 1) % width, y));
                        if (y > 0) sum += row.up * values(x, y - 1);
                        if (y + 1 < height) sum += row.down * values(x, y + 1);
                        values(x, y) += kMembraneOverRelaxation * (row.scale * sum - values(x, y));
                    }
                }
            });
        }
    }
}

}  // namespace core::analysis
