// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/segment/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace core::analysis {

std::optional<PrincipalAxes> principalAxes(std::span<const Vector3f> points) {
    if (points.empty()) return std::nullopt;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Vector3f& p : points) mean += p.cast<double>();
    mean /= static_cast<double>(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Vector3f& p : points) {
        const Eigen::Vector3d d = p.cast<double>() - mean;
        scatter += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return PrincipalAxes{mean, solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace core::analysis
