// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/plane_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using core::analysis::fitRobustPlane;
using core::analysis::PlaneMoments;
using core::analysis::PlaneSample;

double planeAt(double u, double v) { return 1.0 + 0.02 * u - 0.03 * v; }

TEST(PlaneFit, MomentsGiveThePlane) {
    PlaneMoments<double> moments;
    for (int v = -1; v <= 3; ++v)
        for (int u = -2; u <= 1; ++u) moments.add(u, v, planeAt(u, v), 1.0 / (1 + u * u));
    const auto plane = moments.solve(1e-9);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(plane->value, 1, 1e-8);
    EXPECT_NEAR(plane->slopeU, 0.02, 1e-8);
    EXPECT_NEAR(plane->slopeV, -0.03, 1e-8);
}

TEST(PlaneFit, ALineKeepsTheGuessAcrossIt) {
    PlaneMoments<double> moments;
    for (int u = -3; u <= 3; ++u) moments.add(u, 0, planeAt(u, 0), 1);
    const auto plane = moments.solve(1e-6, 0.5, -0.7);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(plane->slopeU, 0.02, 1e-5);
    EXPECT_NEAR(plane->slopeV, -0.7, 1e-9);
    EXPECT_FALSE(PlaneMoments<double>().solve(1e-6)) << "nothing was added";
}

TEST(PlaneFit, OutliersHaveNoInfluence) {
    std::vector<PlaneSample> samples;
    for (int v = -4; v <= 4; ++v)
        for (int u = -4; u <= 4; ++u) {
            const bool outlier = (u + 2 * v + 12) % 4 == 0;  // a quarter of them, all to one side
            samples.push_back({u * 0.25, v * 0.25, planeAt(u, v) + (outlier ? 0.5 : 0), 1});
        }
    const auto plane = fitRobustPlane(samples, {.stiffness = 1e-9});
    EXPECT_NEAR(plane.at(0, 0), 1, 1e-4);
    EXPECT_NEAR(plane.at(1, 0), planeAt(4, 0), 1e-4);
    EXPECT_NEAR(plane.at(0, 1), planeAt(0, 4), 1e-4);
}

TEST(PlaneFit, TheSlopeIsLimited) {
    std::vector<PlaneSample> samples;
    for (int u = -4; u <= 4; ++u)
        for (int v = -4; v <= 4; ++v) samples.push_back({u * 1.0, v * 1.0, 1 + 0.1 * u, 1});
    const auto plane = fitRobustPlane(samples, {.maxSlope = 0.05});
    EXPECT_NEAR(plane.slope.norm(), 0.05 * plane.mean, 1e-9);
}

}  // namespace
