// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/sphere_membrane.h"

#include <cmath>
#include <numbers>

#include "core/analysis/kernels.h"
#include "core/base/directional_map.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

/// Share of the work in the levels coarser than the finest one, each with a quarter of the texels of the next:
/// 1/4 + 1/16 + … of the finest.
constexpr float kCoarserShare = 0.25f;

/// Maps with fewer rows, or an odd number of them, are the coarsest level.
constexpr int kMinFineRows = 16;

/// A map of half the size: means over the covered ones of 2×2 texels, and their number.
struct CoarseMap {
    ImageF coverage;
    ImageRgb values;
};
CoarseMap halfSize(const ImageF& coverage, const ImageRgb& values) {
    const int width = values.width();
    const int height = values.height();
    CoarseMap coarse{ImageF(width / 2, height / 2, 0.0f), ImageRgb(width / 2, height / 2, Vector3f::Zero())};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (!(coverage(x, y) > 0)) continue;
            coarse.values(x / 2, y / 2) += values(x, y);
            coarse.coverage(x / 2, y / 2) += 1;
        }
    }
    for (std::size_t i = 0; i < coarse.values.size(); ++i)
        if (coarse.coverage[i] > 0) coarse.values[i] /= coarse.coverage[i];
    return coarse;
}

/// Gives texels without coverage the values of a map of half the size, interpolated.
void startFrom(ImageRgb&& coarse, const ImageF& coverage, ImageRgb& values) {
    const DirectionalMap guess{std::move(coarse), {}};
    for (int y = 0; y < values.height(); ++y)
        for (int x = 0; x < values.width(); ++x)
            if (!(coverage(x, y) > 0))
                values(x, y) =
                    guess.lookupTexel({0.5f * (static_cast<float>(x) + 0.5f), 0.5f * (static_cast<float>(y) + 0.5f)});
}

}  // namespace

void solveSphereMembrane(const ImageF& coverage, ImageRgb& values, float screen, const StepContext& context) {
    const int height = values.height();
    const bool coarsest = height < kMinFineRows || height % 2 != 0;
    if (!coarsest) {
        CoarseMap coarse = halfSize(coverage, values);
        solveSphereMembrane(coarse.coverage, coarse.values, screen, context.part(0, kCoarserShare));
        startFrom(std::move(coarse.values), coverage, values);
    }
    context.kernels.relaxMembrane(coverage, membraneRows(height, screen), values,
                                  context.progress.part(coarsest ? 0 : kCoarserShare, 1));
}

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
    for (int half = 0; half < 2 * kMembraneSweeps; ++half) {
        const auto from = static_cast<float>(half) / (2 * kMembraneSweeps);
        const auto to = static_cast<float>(half + 1) / (2 * kMembraneSweeps);
        parallelFor(progress.part(from, to), height, [&](int y) {
            const MembraneRow& row = rows[static_cast<std::size_t>(y)];
            for (int x = (y + half) % 2; x < width; x += 2) {
                if (coverage(x, y) > 0) continue;
                Vector3f sum = row.side * (values((x + 1) % width, y) + values((x + width - 1) % width, y));
                if (y > 0) sum += row.up * values(x, y - 1);
                if (y + 1 < height) sum += row.down * values(x, y + 1);
                values(x, y) += kMembraneOverRelaxation * (row.scale * sum - values(x, y));
            }
        });
    }
}

}  // namespace core::analysis
