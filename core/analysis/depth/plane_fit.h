// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>

namespace core::analysis {

// Planes are linear in inverse depth: w = a + b·u + c·v for pixel coordinates (u, v).

/// Weighted least-squares plane from sums over its samples: one pass, no memory, for fits at every pixel. Coordinates
/// and values should be small, relative to the centre of the window.
template <class T>
struct PlaneMoments {
    T s = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0, sw = 0, suw = 0, svw = 0;

    struct Plane {
        T value;           ///< at (0, 0)
        T slopeU, slopeV;  ///< per unit of u and v
    };

    void add(T u, T v, T w, T weight) {
        const T ku = weight * u;
        const T kv = weight * v;
        s += weight;
        su += ku;
        sv += kv;
        suu += ku * u;
        suv += ku * v;
        svv += kv * v;
        sw += weight * w;
        suw += ku * w;
        svw += kv * w;
    }

    /// `stiffness` > 0: relative weight that holds the slope at (guessU, guessV) where the samples do not determine it,
    /// as across a line of pixels. nullopt without any weight.
    [[nodiscard]] std::optional<Plane> solve(T stiffness, T guessU = 0, T guessV = 0) const {
        if (!(s > 0)) return std::nullopt;
        const T regularization = stiffness * s;
        const T cuu = suu - su * su / s + regularization;
        const T cuv = suv - su * sv / s;
        const T cvv = svv - sv * sv / s + regularization;
        const T cuw = suw - su * sw / s + regularization * guessU;
        const T cvw = svw - sv * sw / s + regularization * guessV;
        const T determinant = cuu * cvv - cuv * cuv;
        if (!(determinant > 0)) return std::nullopt;
        const T slopeU = (cvv * cuw - cuv * cvw) / determinant;
        const T slopeV = (cuu * cvw - cuv * cuw) / determinant;
        return Plane{(sw - slopeU * su - slopeV * sv) / s, slopeU, slopeV};
    }
};

/// One value of a robust fit.
struct PlaneSample {
    double u, v;
    double w;
    double weight;  ///< before reweighting
};

/// How a robust fit treats its samples. The defaults suit windows of a few hundred samples around a gap.
struct RobustPlaneFit {
    int rounds = 7;  ///< of reweighted least squares
    /// Number of the first rounds, which minimise absolute residuals: outliers cannot bias them.
    int absoluteRounds = 3;
    double stiffness = 1e-4;                                    ///< as in `PlaneMoments::solve`, towards slope 0
    double maxSlope = std::numeric_limits<double>::infinity();  ///< relative to the mean value, per unit of (u, v)
    double scale = 3;        ///< residual with a weight of a quarter, in medians of the absolute residuals
    double minScale = 1e-6;  ///< smallest such residual, relative to the mean value
};

/// Plane w = mean + slope · ((u, v) − center).
struct RobustPlane {
    double mean = 0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    Eigen::Vector2d center = Eigen::Vector2d::Zero();

    [[nodiscard]] double at(double u, double v) const { return mean + slope.dot(Eigen::Vector2d(u, v) - center); }
};

/// Plane through most of the samples, by iteratively reweighted least squares with weights of Geman and McClure.
/// `samples` must not be empty.
[[nodiscard]] RobustPlane fitRobustPlane(std::span<const PlaneSample> samples, const RobustPlaneFit& fit = {});

}  // namespace core::analysis
