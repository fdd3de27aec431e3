// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/base/image.h"

namespace core::analysis {

/// Principal component analysis of points.
struct PrincipalAxes {
    Eigen::Vector3d mean;
    Eigen::Vector3d eigenvalues;   ///< of the scatter matrix, ascending
    Eigen::Matrix3d eigenvectors;  ///< columns, unit, in the order of `eigenvalues`
};

/// nullopt without points or when the decomposition fails.
[[nodiscard]] std::optional<PrincipalAxes> principalAxes(std::span<const Vector3f> points);

}  // namespace core::analysis
