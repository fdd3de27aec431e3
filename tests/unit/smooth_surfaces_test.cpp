// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing of segments' surfaces against analytic shapes.
#include "core/analysis/depth/smooth_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "core/base/error.h"

namespace {

using core::ImageF;
using core::Progress;
using core::analysis::SurfaceSmoothing;

constexpr int kSide = 160;
constexpr float kFocalLength = 500;

struct Picture {
    ImageF truth{kSide, kSide, 0.0f};  ///< inverse depth [1/m]
    ImageF depth{kSide, kSide, 0.0f};
    core::Image<std::uint8_t> measured{kSide, kSide, 1};
    core::LabelImage labels{kSide, kSide, 1};
    core::Camera camera;

    void smooth(SurfaceSmoothing smoothing, const core::Progress& progress = {}) {
        smoothing.label = 1;
        core::analysis::smoothSurfaces(depth, measured, labels, camera, std::vector{smoothing}, progress);
    }
    /// Angle between true and found slopes of `pixels `margin` from the border [degrees]: median or another quantile.
    [[nodiscard]] double tiltError(int margin, double quantile = 0.5) const {
        std::vector<double> tilts;
        for (int y = margin; y < kSide - margin; ++y) {
            for (int x = margin; x < kSide - margin; ++x) {
                const auto slope = [&](const auto& w, int dx, int dy) {
                    return static_cast<double>(w(x + dx, y + dy) - w(x - dx, y - dy)) / 2 *
                           static_cast<double>(kFocalLength / truth(x, y));
                };
                const auto found = [&](int u, int v) { return 1 / depth(u, v); };
                const auto real = [&](int u, int v) { return truth(u, v); };
                const double du = slope(found, 1, 0) - slope(real, 1, 0);
                const double dv = slope(found, 0, 1) - slope(real, 0, 1);
                tilts.push_back(std::atan(std::hypot(du, dv)) * 57.2958);
            }
        }
        const auto at = tilts.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(tilts.size() - 1));
        std::ranges::nth_element(tilts, at);
        return *at;
    }
};

Picture pictureOf(const std::function<float(float, float)>& inverseDepth) {
    Picture p;
    p.camera.width = p.camera.height = kSide;
    p.camera.fx = p.camera.fy = kFocalLength;
    p.camera.cx = p.camera.cy = 0.5f * kSide;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            p.truth(x, y) = inverseDepth(static_cast<float>(x) - 0.5f * kSide, static_cast<float>(y) - 0.5f * kSide);
            p.depth(x, y) = 1 / p.truth(x, y);
        }
    }
    return p;
}

/// Like a ball a little behind its tangent plane.
float bowl(float x, float y) { return 1 - 4e-6f * (x * x + y * y); }

/// What the depth filter leaves of noise of `sigma`.
void addNoise(Picture& p, float sigma) {
    sigma /= 6;
    std::mt19937 random(11);
    std::normal_distribution<float> normal;
    for (float& z : p.depth.pixels()) z = 1 / (1 / z + sigma * normal(random));
}

TEST(SmoothSurfaces, NoiseIsSmoothedAwayFromACurvedSurface) {
    Picture p = pictureOf(bowl);
    addNoise(p, 0.0005f);
    const double before = p.tiltError(2);
    p.smooth({.length = 10, .noise = 0.0005f});
    EXPECT_GT(before, 1.5);
    EXPECT_LT(p.tiltError(2), 0.2 * before);
    EXPECT_LT(p.tiltError(2, 0.99), 0.5 * before);
}

TEST(SmoothSurfaces, AFoldStaysSharp) {
    // Two faces that meet at 90 degrees along x = 0.
    const auto roof = [](float x, float) { return 1 - std::abs(x) / kFocalLength; };
    Picture p = pictureOf(roof);
    addNoise(p, 0.0005f);
    p.smooth({.length = 10, .noise = 0.0005f});
    // Six pixels beside the fold, less than the length, the faces have their slopes.
    for (const int x : {kSide / 2 - 6, kSide / 2 + 6}) {
        double slope = 0;
        for (int y = 10; y < kSide - 10; ++y)
            slope += static_cast<double>(1 / p.depth(x + 1, y) - 1 / p.depth(x - 1, y));
        slope *= 0.5 * static_cast<double>(kFocalLength) / (kSide - 20);
        EXPECT_NEAR(slope, x < kSide / 2 ? 1 : -1, 0.15) << x;
    }
}

TEST(SmoothSurfaces, AJumpInsideASegmentStays) {
    Picture p = pictureOf([](float x, float) { return x < 0 ? 1.0f : 0.9f; });
    addNoise(p, 0.0005f);
    p.smooth({.length = 10, .noise = 0.0005f});
    for (int y = 0; y < kSide; ++y) {
        EXPECT_NEAR(1 / p.depth(kSide / 2 - 2, y), 1, 0.005f) << y;
        EXPECT_NEAR(1 / p.depth(kSide / 2 + 1, y), 0.9f, 0.005f) << y;
    }
}

TEST(SmoothSurfaces, AGrooveOfARoundedMapIsSpanned) {
    // Three pixels wide and one and a half steps deep, as where a painted line was taken for one.
    constexpr float kStep = 0.004f;
    Picture p = pictureOf(bowl);
    for (int y = 0; y < kSide; ++y)
        for (int x = 40; x < 43; ++x) p.depth(x, y) = 1 / (p.truth(x, y) - 1.5f * kStep);
    p.smooth({.length = 12, .noise = kStep / std::sqrt(12.0f), .correlation = 4, .rounded = true});
    for (int y = 20; y < kSide - 20; ++y) ASSERT_NEAR(1 / p.depth(41, y), p.truth(41, y), 0.2f * kStep) << y;
}

TEST(SmoothSurfaces, ReliefLargerThanTheNoiseStays) {
    // Waves 24 pixels long, ten times as high as the noise; a length of 20 pixels alone would smooth them away.
    const auto waves = [](float x, float) { return 1 + 0.005f * std::sin(x * 0.2618f); };
    Picture p = pictureOf(waves);
    addNoise(p, 0.0005f);
    p.smooth({.length = 20, .noise = 0.0005f});
    double product = 0, power = 0;
    for (int y = 20; y < kSide - 20; ++y) {
        for (int x = 20; x < kSide - 20; ++x) {
            const double wave = static_cast<double>(p.truth(x, y)) - 1;
            product += wave * (static_cast<double>(1 / p.depth(x, y)) - 1);
            power += wave * wave;
        }
    }
    EXPECT_GT(product / power, 0.9);
}

TEST(SmoothSurfaces, WhatIsNotMeasuredIsSpanned) {
    Picture p = pictureOf(bowl);
    for (int y = 70; y < 90; ++y)
        for (int x = 70; x < 90; ++x) p.depth(x, y) = 1.3f, p.measured(x, y) = 0;
    p.smooth({.length = 10, .noise = 0.0005f});
    for (int y = 70; y < 90; ++y)
        for (int x = 70; x < 90; ++x) ASSERT_NEAR(1 / p.depth(x, y), p.truth(x, y), 0.002f) << x << ", " << y;
}

TEST(SmoothSurfaces, OtherSegmentsAndShortLengthsAreLeftAlone) {
    Picture p = pictureOf(bowl);
    addNoise(p, 0.0005f);
    for (int y = 0; y < kSide; ++y)
        for (int x = kSide / 2; x < kSide; ++x) p.labels(x, y) = 2;
    const ImageF before = p.depth;
    p.smooth({.length = 0.9f, .noise = 0.0005f});
    EXPECT_EQ(p.depth, before);
    p.smooth({.length = 8, .noise = 0.0005f});
    for (int y = 0; y < kSide; ++y)
        for (int x = kSide / 2; x < kSide; ++x) ASSERT_EQ(p.depth(x, y), before(x, y));
    EXPECT_NE(p.depth(10, 10), before(10, 10));
}

TEST(SmoothSurfaces, CanBeCancelled) {
    Picture p = pictureOf(bowl);
    const ImageF before = p.depth;
    const std::atomic<bool> cancel{true};
    EXPECT_THROW(p.smooth({.length = 8, .noise = 0.0005f}, core::Progress({}, &cancel)), core::Error);
    EXPECT_EQ(p.depth, before);
}

}  // namespace
