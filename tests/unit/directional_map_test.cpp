// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/directional_map.h"
#include "core/analysis/light/directional_accumulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/analysis/light/fill_directions.h"
#include "tests/support/ray_scene.h"

namespace {

using core::DirectionalMap;
using core::Vector2f;
using core::Vector3f;

Vector3f texelDirection(int x, int y, int width, int height) {
    return DirectionalMap::directionFromTexel({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width,
                                              height);
}

DirectionalMap mapOf(int height, const std::function<Vector3f(const Vector3f&)>& radiance) {
    DirectionalMap map{core::ImageRgb(2 * height, height), core::ImageF(2 * height, height, 1.0f)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x) map.radiance(x, y) = radiance(texelDirection(x, y, 2 * height, height));
    return map;
}

TEST(DirectionalMap, StatedConventions) {
    const int w = 256;
    const int h = 128;
    EXPECT_TRUE(
        DirectionalMap::texelFromDirection({0, 0, 1}, w, h).isApprox(Vector2f(128, 64), 1e-5f));  // forward: centre
    EXPECT_TRUE(DirectionalMap::texelFromDirection({1, 0, 0}, w, h).isApprox(Vector2f(192, 64), 1e-5f));  // right
    EXPECT_TRUE(DirectionalMap::texelFromDirection({-1, 0, 0}, w, h).isApprox(Vector2f(64, 64), 1e-5f));  // left
    EXPECT_NEAR(DirectionalMap::texelFromDirection({0, -1, 0}, w, h).y(), 0, 1e-4f);                      // up: top
    EXPECT_NEAR(DirectionalMap::texelFromDirection({0, 1, 0}, w, h).y(), 128, 1e-4f);
    EXPECT_NEAR(DirectionalMap::texelFromDirection({1e-6f, 0, -1}, w, h).x(), 256, 1e-3f);  // the seam is behind
    EXPECT_NEAR(DirectionalMap::texelFromDirection({-1e-6f, 0, -1}, w, h).x(), 0, 1e-3f);
}

TEST(DirectionalMap, DirectionsSurviveTheRoundTrip) {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const Vector3f d = test::randomDirection(random);
        const Vector3f back =
            DirectionalMap::directionFromTexel(DirectionalMap::texelFromDirection(d, 512, 256), 512, 256);
        EXPECT_LT((d - back).norm(), 2e-6f);
    }
}

TEST(DirectionalMap, SolidAnglesAddUpToTheSphere) {
    for (const int height : {1, 2, 7, 128, 1024}) {
        double sum = 0;
        for (int y = 0; y < height; ++y) sum += 2.0 * height * DirectionalMap::texelSolidAngle(y, 2 * height, height);
        EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-4);
    }
}

TEST(DirectionalMap, LookupIsContinuousAcrossTheSeam) {
    const DirectionalMap map = mapOf(64, [](const Vector3f& d) { return d; });
    for (float y = -0.9f; y < 0.95f; y += 0.1f) {
        const Vector3f a = Vector3f(1e-4f, y, -1).normalized();
        const Vector3f b = Vector3f(-1e-4f, y, -1).normalized();
        EXPECT_LT((map.lookup(a) - map.lookup(b)).norm(), 1e-3f);
        EXPECT_LT((map.lookup(a) - a).norm(), 0.01f);
    }
}

TEST(DirectionalMap, LookupAtTexelCentresIsExact) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> value;
    DirectionalMap map = mapOf(16, [&](const Vector3f&) { return Vector3f(value(random), value(random), 0); });
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            EXPECT_LT((map.lookup(texelDirection(x, y, 32, 16)) - map.radiance(x, y)).norm(), 1e-4f);
}

TEST(DirectionalMap, MeanIsWeightedBySolidAngle) {
    // ∫(d.y)² over the sphere is 1/3 of it; unweighted rows would give 1/2.
    const DirectionalMap map = mapOf(128, [](const Vector3f& d) { return Vector3f(d.y() * d.y(), d.x(), 2); });
    const Vector3f mean = map.mean();
    EXPECT_NEAR(mean.x(), 1.0f / 3, 2e-4f);
    EXPECT_NEAR(mean.y(), 0, 1e-5f);
    EXPECT_NEAR(mean.z(), 2, 1e-5f);
}

TEST(DirectionalMap, MeanOverKnownTexelsOnly) {
    DirectionalMap map = mapOf(32, [](const Vector3f& d) { return d.y() < 0 ? Vector3f(1, 1, 1) : Vector3f(9, 9, 9); });
    for (int y = 16; y < 32; ++y)
        for (int x = 0; x < 64; ++x) map.coverage(x, y) = 0;
    EXPECT_NEAR(map.mean(1).x(), 1, 1e-6f);
    EXPECT_NEAR(map.mean(0).x(), 5, 1e-5f);
    EXPECT_EQ(map.mean(2), Vector3f(0, 0, 0));
}

TEST(FillDirections, KeepsWhatIsKnownAndCoverage) {
    DirectionalMap map = mapOf(16, [](const Vector3f& d) { return Vector3f(d.x() + 2, 1, 1); });
    const DirectionalMap before = map;
    for (int x = 0; x < 32; x += 2) {
        map.coverage(x, 8) = 0;
        map.radiance(x, 8).setZero();
    }
    core::analysis::fillDirections(map, core::EnvironmentFill::Shepard, Vector3f(9, 9, 9), {});
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            if (y == 8 && x % 2 == 0) {
                EXPECT_EQ(map.coverage(x, y), 0);
                EXPECT_NEAR(map.radiance(x, y).x(), before.radiance(x, y).x(), 0.12f);
            } else {
                EXPECT_EQ(map.radiance(x, y), before.radiance(x, y));
            }
        }
    }
}

TEST(FillDirections, AgreesWithAllPairsSummation) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> value;
    const int height = 24;
    DirectionalMap map =
        mapOf(height, [&](const Vector3f& d) { return Vector3f(1 + d.x(), 1 + 0.5f * d.z(), value(random)); });
    for (std::size_t i = 0; i < map.coverage.size(); ++i) map.coverage[i] = value(random) < 0.15f ? 3.0f : 0.0f;
    DirectionalMap filled = map;
    core::analysis::fillDirections(filled, core::EnvironmentFill::Shepard, Vector3f::Zero(), {});
    double squares = 0;
    int count = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            if (map.coverage(x, y) > 0) continue;
            const Eigen::Vector3d d = texelDirection(x, y, 2 * height, height).cast<double>();
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            double weight = 0;
            for (int sy = 0; sy < height; ++sy) {
                for (int sx = 0; sx < 2 * height; ++sx) {
                    if (map.coverage(sx, sy) <= 0) continue;
                    const Eigen::Vector3d s = texelDirection(sx, sy, 2 * height, height).cast<double>();
                    const double angle = std::acos(std::clamp(d.dot(s), -1.0, 1.0));
                    const double k = DirectionalMap::texelSolidAngle(sy, 2 * height, height) / std::pow(angle, 3);
                    sum += k * map.radiance(sx, sy).cast<double>();
                    weight += k;
                }
            }
            const Eigen::Vector3d error = filled.radiance(x, y).cast<double>() - sum / weight;
            EXPECT_LT(error.head<2>().cwiseAbs().maxCoeff(), 0.02) << "at " << x << ", " << y;
            squares += error.z() * error.z();
            ++count;
        }
    }
    // White noise of range 1 is the worst case for taking far texels in groups.
    EXPECT_LT(std::sqrt(squares / count), 0.01);
}

TEST(FillDirections, SphereHasNoSeamAndNoPoles) {
    // One observation behind the camera, one in front: what fills the rest depends on the angle to them alone.
    const int height = 32;
    DirectionalMap map{core::ImageRgb(2 * height, height), core::ImageF(2 * height, height)};
    map.radiance(0, height / 2) = Vector3f(1, 0, 0);  // just beside the seam
    map.coverage(0, height / 2) = 1;
    map.radiance(height, height / 2) = Vector3f(0, 1, 0);
    map.coverage(height, height / 2) = 1;
    core::analysis::fillDirections(map, core::EnvironmentFill::Shepard, Vector3f::Zero(), {});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            if (map.coverage(x, y) > 0) continue;
            const Vector3f d = texelDirection(x, y, 2 * height, height);
            const float a =
                std::acos(std::clamp(d.dot(texelDirection(0, height / 2, 2 * height, height)), -1.0f, 1.0f));
            const float b =
                std::acos(std::clamp(d.dot(texelDirection(height, height / 2, 2 * height, height)), -1.0f, 1.0f));
            const float expected = b * b * b / (a * a * a + b * b * b);
            EXPECT_NEAR(map.radiance(x, y).x(), expected, 2e-3f) << "at " << x << ", " << y;
        }
    }
}

TEST(FillDirections, NothingKnownGivesTheFallback) {
    DirectionalMap map{core::ImageRgb(16, 8), core::ImageF(16, 8)};
    core::analysis::fillDirections(map, core::EnvironmentFill::Shepard, Vector3f(1, 2, 3), {});
    for (const Vector3f& c : map.radiance.pixels()) EXPECT_EQ(c, Vector3f(1, 2, 3));
    EXPECT_FLOAT_EQ(map.mean().y(), 2);
}

TEST(FillMembrane, SolvesLaplacesEquationOnTheSphere) {
    // log tan(θ/2) is harmonic on the sphere away from the poles.
    const auto truth = [](const Vector3f& d) {
        const float theta = std::acos(-d.y());
        return Vector3f(std::tan(theta / 2), 1, 2 * std::tan(theta / 2));
    };
    DirectionalMap map = mapOf(64, truth);
    for (int y = 12; y < 52; ++y)
        for (int x = 0; x < 128; ++x) {
            map.coverage(x, y) = 0;
            map.radiance(x, y).setZero();
        }
    core::analysis::fillDirections(map, core::EnvironmentFill::Membrane, Vector3f::Zero(), {});
    for (int y = 12; y < 52; ++y)
        for (int x = 0; x < 128; x += 5) {
            const Vector3f expected = truth(texelDirection(x, y, 128, 64));
            EXPECT_LT((map.radiance(x, y) - expected).norm(), 0.03f * expected.norm()) << x << ' ' << y;
        }
}

TEST(FillMembrane, SunAtTheEdgeOfWhatWasSeenDoesNotSpread) {
    DirectionalMap map = mapOf(64, [](const Vector3f&) { return Vector3f(1, 1, 1); });
    for (int y = 32; y < 64; ++y)
        for (int x = 0; x < 128; ++x) map.coverage(x, y) = 0;
    map.radiance(40, 31) = Vector3f(5000, 5000, 5000);
    DirectionalMap shepard = map;
    core::analysis::fillDirections(map, core::EnvironmentFill::Membrane, Vector3f::Zero(), {});
    core::analysis::fillDirections(shepard, core::EnvironmentFill::Shepard, Vector3f::Zero(), {});
    double membraneSum = 0, shepardSum = 0, weight = 0;
    for (int y = 32; y < 64; ++y)
        for (int x = 0; x < 128; ++x) {
            const double w = DirectionalMap::texelSolidAngle(y, 128, 64);
            membraneSum += w * map.radiance(x, y).x();
            shepardSum += w * shepard.radiance(x, y).x();
            weight += w;
        }
    EXPECT_LT(membraneSum / weight, 1.2);
    EXPECT_GT(shepardSum / weight, 2.0) << "what the paper's fill would do";
}

TEST(CompleteDirections, FadesFromWhatWasSeenToTheUsersMap) {
    DirectionalMap map = mapOf(64, [](const Vector3f&) { return Vector3f(1, 1, 1); });
    for (int y = 32; y < 64; ++y)
        for (int x = 0; x < 128; ++x) map.coverage(x, y) = 0;
    const core::ImageRgb user(128, 64, Vector3f(3, 3, 3));
    core::analysis::completeDirections(map, user, {});
    EXPECT_EQ(map.radiance(10, 31).x(), 1);
    EXPECT_NEAR(map.radiance(10, 32).x(), 3 - 2 * std::exp(-std::numbers::pi_v<float> / 64 / 0.06f), 0.1f);
    for (int y = 33; y < 64; ++y) EXPECT_GT(map.radiance(10, y).x(), map.radiance(10, y - 1).x() - 1e-4f);
    EXPECT_NEAR(map.radiance(10, 36).x(), 3, 0.4f);  // 13 degrees away
    EXPECT_NEAR(map.radiance(10, 50).x(), 3, 0.01f);
}

TEST(DirectionalAccumulator, TakesTheWeightedMeanPerTexel) {
    core::analysis::DirectionalAccumulator sum(8);
    const Vector3f d = texelDirection(3, 2, 16, 8);
    sum.add(d, {1, 2, 3});
    sum.add(d, {4, 2, 0}, 0.5f);
    const DirectionalMap map = sum.map();
    EXPECT_FLOAT_EQ(map.coverage(3, 2), 1.5f);
    EXPECT_TRUE(map.radiance(3, 2).isApprox(Vector3f(2, 2, 2)));
    EXPECT_EQ(map.coverage(4, 2), 0);
    EXPECT_TRUE(map.clipped.empty());
    EXPECT_NEAR(std::numbers::pi_v<float>, DirectionalMap::texelSolidAngle(0, 2, 1) / 2, 1e-5f);
}

TEST(DirectionalAccumulator, ClippedChannelsCountOnlyWhereNothingElseIsKnown) {
    core::analysis::DirectionalAccumulator sum(8);
    const Vector3f both = texelDirection(3, 2, 16, 8);
    sum.add(both, {1, 1, 0.5f}, 1, 0b011);
    sum.add(both, {5, 1, 0.7f}, 1, 0b010);
    sum.add(both, {1, 1, 0.6f}, 1, 0b011);
    const Vector3f never = texelDirection(5, 2, 16, 8);
    sum.add(never, {2, 2, 2});
    const DirectionalMap map = sum.map();
    EXPECT_FLOAT_EQ(map.radiance(3, 2).x(), 5);
    EXPECT_FLOAT_EQ(map.radiance(3, 2).y(), 1);
    EXPECT_FLOAT_EQ(map.radiance(3, 2).z(), 0.6f);
    EXPECT_EQ(map.clipped(3, 2), 0b010);
    EXPECT_EQ(map.clipped(5, 2), 0);
    EXPECT_EQ(map.clipped(7, 2), 0);
}

}  // namespace
