// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/analysis/step_context.h"
#include "core/base/image.h"

namespace core::analysis {

/// Fills the texels of a latitude-longitude map without coverage by Laplace's equation on the sphere, with the covered
/// ones as its boundary. With `screen` > 0 [rad] by the screened equation, Δu = u/screen²: values decay to zero over
/// about that angle. Coarse to fine, so that every level only has to settle its own detail.
void solveSphereMembrane(const ImageF& coverage, ImageRgb& values, float screen, const StepContext& context);

/// Coefficients of one row of texels in the finite volumes of Laplace's equation on the sphere: flow over the upper,
/// the lower and the two side edges; the poles have no edge.
struct MembraneRow {
    float up, down, side;
    float scale;  ///< 1 / (sum of the four and of what is absorbed)
};
/// Rows of a map; `screen` as above, 0 = none.
[[nodiscard]] std::vector<MembraneRow> membraneRows(int height, float screen);

inline constexpr int kMembraneSweeps = 60;
inline constexpr float kMembraneOverRelaxation = 1.7f;

/// `kMembraneSweeps` sweeps of red-black successive over-relaxation over the texels without coverage, on the CPU. The
/// texels of one colour only depend on those of the other, so any order gives the same result. The width is even.
void relaxMembrane(const ImageF& coverage, std::span<const MembraneRow> rows, ImageRgb& values,
                   const Progress& progress);

}  // namespace core::analysis
