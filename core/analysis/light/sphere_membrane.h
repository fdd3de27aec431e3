// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// Coefficients of one row of texels in the finite volumes of Laplace's equation on the sphere: what flows over the
/// upper, lower and the two side edges; the poles have no edge.
struct MembraneRow {
    float up, down, side;
    float scale;  ///< 1 / (sum of the four and what is absorbed)
};
/// With `screen` > 0 [rad] the equation is the screened one, Δu = u/screen²; 0 = none.
[[nodiscard]] std::vector<MembraneRow> membraneRows(int height, float screen);

inline constexpr int kMembraneSweeps = 60;
inline constexpr float kMembraneOverRelaxation = 1.7f;

/// `kMembraneSweeps` sweeps of red-black successive over-relaxation over the texels without coverage, on the CPU. The
/// texels of one colour only depend on those of the other: any order gives the same result. The width is even.
void relaxMembrane(const ImageF& coverage, std::span<const MembraneRow> rows, ImageRgb& values,
                   const Progress& progress);

}  // namespace core::analysis
