// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/plane_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/statistics.h"

namespace core::analysis {
namespace {

double residualOf(const RobustPlane& plane, const PlaneSample& s) {
    return s.w - plane.mean - plane.slope.dot(Eigen::Vector2d(s.u, s.v) - plane.center);
}

/// Weighted least squares about the weighted centre.
RobustPlane fitWeightedPlane(std::span<const PlaneSample> samples, std::span<const double> weights,
                             const RobustPlaneFit& fit) {
    double total = 0, sum = 0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        total += weights[i];
        sum += weights[i] * samples[i].w;
        moment += weights[i] * Eigen::Vector2d(samples[i].u, samples[i].v);
    }
    RobustPlane plane{.mean = sum / total, .center = moment / total};
    Eigen::Matrix2d normal = fit.stiffness * total * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Eigen::Vector2d d = Eigen::Vector2d(samples[i].u, samples[i].v) - plane.center;
        normal += weights[i] * d * d.transpose();
        right += weights[i] * (samples[i].w - plane.mean) * d;
    }
    plane.slope = normal.inverse() * right;
    const double most = fit.maxSlope * plane.mean;
    if (plane.slope.norm() > most) plane.slope *= most / plane.slope.norm();
    return plane;
}

}  // namespace

RobustPlane fitRobustPlane(std::span<const PlaneSample> samples, const RobustPlaneFit& fit) {
    std::vector<double> weights(samples.size()), offsets(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) weights[i] = samples[i].weight;
    RobustPlane plane;
    for (int round = 0; round < fit.rounds; ++round) {
        plane = fitWeightedPlane(samples, weights, fit);
        if (round + 1 == fit.rounds) break;
        for (std::size_t i = 0; i < samples.size(); ++i) offsets[i] = std::abs(residualOf(plane, samples[i]));
        const double scale = std::max(fit.scale * median(offsets), fit.minScale * plane.mean);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double off = residualOf(plane, samples[i]) / scale;
            const double gemanMcClure = (1 + off * off) * (1 + off * off);
            weights[i] = samples[i].weight / (round + 1 < fit.absoluteRounds ? 0.1 + std::abs(off) : gemanMcClure);
        }
    }
    return plane;
}

}  // namespace core::analysis
