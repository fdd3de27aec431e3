// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace core {

/// A measured isotropic BRDF [MPBM03] in the kernels' layout: tables for importance sampling, then the values
/// (shaders/brdf/measured.h), kernel::kMeasuredSize numbers.
struct MeasuredBrdf {
    std::vector<float> table;
};

/// Reads a file in MERL's binary format: the dimensions 90, 90, 180 as 32-bit integers, then three planes (red, green,
/// blue) of doubles to be scaled by 1/1500, 1.15/1500 and 1.66/1500, all little-endian. Negative values mark unmeasured
/// directions and become 0. Throws Error(Input) naming the file, what was expected and what was found.
[[nodiscard]] std::shared_ptr<const MeasuredBrdf> loadMeasuredBrdf(const std::string& path);

}  // namespace core
