// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/smooth_directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using core::DirectionalMap;
using core::Vector3f;

constexpr int kMapHeight = 64;
constexpr float kTexel = std::numbers::pi_v<float> / kMapHeight;

DirectionalMap emptyMap() {
    return {core::ImageRgb(2 * kMapHeight, kMapHeight, Vector3f::Zero()),
            core::ImageF(2 * kMapHeight, kMapHeight, 0.0f)};
}

/// Light with edges: what a mirror shows.
float truth(int x, int y) { return (x / 5 + y / 7) % 2 == 0 ? 1.0f : 4.0f; }

TEST(SmoothDirections, AConstantStaysAndGapsStay) {
    DirectionalMap map = emptyMap();
    for (int y = 0; y < kMapHeight; ++y)
        for (int x = 0; x < 2 * kMapHeight; ++x)
            if ((x * 7 + y * 3) % 5 != 0) {
                map.radiance(x, y) = {1, 2, 3};
                map.coverage(x, y) = static_cast<float>(1 + x % 4);
            }
    DirectionalMap smooth = map;
    core::analysis::smoothDirections(smooth, 5 * kTexel);
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        EXPECT_LT((smooth.radiance[i] - map.radiance[i]).norm(), 1e-4f);
    EXPECT_EQ(smooth.coverage, map.coverage);
}

TEST(SmoothDirections, SpreadsByTheGivenAngle) {
    for (const int row : {32, 12}) {  // at the equator, and 35 degrees from a pole
        DirectionalMap map = emptyMap();
        for (float& c : map.coverage.pixels()) c = 1;
        map.radiance(0, row) = {1, 1, 1};  // at the seam
        const Vector3f center = DirectionalMap::directionFromTexel({0.5f, static_cast<float>(row) + 0.5f}, 128, 64);
        core::analysis::smoothDirections(map, 4 * kTexel);
        double sum = 0;
        double squared = 0;
        for (int y = 0; y < kMapHeight; ++y) {
            for (int x = 0; x < 2 * kMapHeight; ++x) {
                const Vector3f d = DirectionalMap::directionFromTexel(
                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 128, 64);
                const double weight =
                    static_cast<double>(map.radiance(x, y).x() * DirectionalMap::texelSolidAngle(y, 128, 64));
                const double angle = std::acos(std::min(1.0, static_cast<double>(d.dot(center))));
                sum += weight;
                squared += weight * angle * angle;
            }
        }
        // Two dimensions: E[angle²] = 2σ².
        EXPECT_NEAR(std::sqrt(squared / sum / 2), 4 * static_cast<double>(kTexel),
                    0.1 * 4 * static_cast<double>(kTexel))
            << "row " << row;
    }
}

TEST(SmoothDirections, AMirrorAgreesWithItself) {
    DirectionalMap one = emptyMap();
    for (int y = 0; y < kMapHeight; ++y)
        for (int x = 0; x < 2 * kMapHeight; ++x) {
            one.radiance(x, y) = Vector3f::Constant(truth(x, y));
            one.coverage(x, y) = 1;
        }
    EXPECT_EQ(core::analysis::agreementWidth(one, one), 0);
}

TEST(SmoothDirections, ContradictionsAreSmoothedUntilTheyAgree) {
    std::mt19937 random(3);
    std::lognormal_distribution<float> noise(0, 0.8f);
    DirectionalMap one = emptyMap();
    DirectionalMap other = emptyMap();
    DirectionalMap both = emptyMap();
    const auto slow = [](int y) { return 1 + static_cast<float>(y) / kMapHeight; };
    for (int y = 0; y < kMapHeight; ++y)
        for (int x = 0; x < 2 * kMapHeight; ++x) {
            one.radiance(x, y) = Vector3f::Constant(slow(y) * noise(random));
            other.radiance(x, y) = Vector3f::Constant(slow(y) * noise(random));
            both.radiance(x, y) = 0.5f * (one.radiance(x, y) + other.radiance(x, y));
            one.coverage(x, y) = other.coverage(x, y) = both.coverage(x, y) = 1;
        }
    const float width = core::analysis::agreementWidth(one, other);
    ASSERT_GE(width, 2 * kTexel);
    const float mean = std::exp(0.32f);  // of the noise
    const auto error = [&](const DirectionalMap& map) {
        double sum = 0;
        for (int y = 0; y < kMapHeight; ++y)
            for (int x = 0; x < 2 * kMapHeight; ++x)
                sum += std::abs(static_cast<double>(map.radiance(x, y).x() / (mean * slow(y)) - 1));
        return sum;
    };
    DirectionalMap smooth = both;
    core::analysis::smoothDirections(smooth, width);
    EXPECT_LT(error(smooth), 0.33 * error(both));
}

TEST(SmoothDirections, TooLittleInCommonSaysNothing) {
    DirectionalMap one = emptyMap();
    DirectionalMap other = emptyMap();
    for (int x = 0; x < 2 * kMapHeight; ++x) {
        (x < kMapHeight ? one : other).coverage(x, 32) = 1;
        one.radiance(x, 32) = {1, 1, 1};
    }
    for (int x = 0; x < 5; ++x) other.coverage(x, 32) = 1;  // 0.012 sr
    EXPECT_EQ(core::analysis::agreementWidth(one, other), 0);
}

}  // namespace
