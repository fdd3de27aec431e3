// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/selection_stroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

namespace {

constexpr float kFocal = 100;

struct Halves {
    core::ImageRgb color;
    core::ImageF depth;
};

/// Left half dark at 1 m, right half light at 2 m.
Halves makeHalves(int width, int height) {
    Halves picture{core::ImageRgb(width, height, core::Vector3f(0.1f, 0.1f, 0.1f)), core::ImageF(width, height, 1.0f)};
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width; ++x) {
            picture.color(x, y) = {0.7f, 0.6f, 0.5f};
            picture.depth(x, y) = 2;
        }
    return picture;
}

core::SelectionStroke begin(const Halves& picture, const core::SelectionBrush& brush, std::uint8_t before = 0) {
    return {core::BinaryMask(picture.color.width(), picture.color.height(), before), brush, picture.color,
            picture.depth, kFocal};
}

/// Distance of a pixel's centre from the segment between two points.
float distanceTo(int x, int y, core::Vector2f a, core::Vector2f b) {
    const core::Vector2f p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const core::Vector2f way = b - a;
    const float along = way.squaredNorm() > 0 ? std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0f, 1.0f) : 0.0f;
    return (p - a - along * way).norm();
}

TEST(SelectionStroke, PaintsWhatIsWithinItsRadius) {
    const Halves picture = makeHalves(64, 48);
    core::SelectionStroke stroke = begin(picture, {.radius = 6});
    const core::Vector2f a(10.3f, 9.8f), b(50.1f, 33.4f);
    static_cast<void>(stroke.moveTo(a.x(), a.y()));
    const core::PixelBox box = stroke.moveTo(b.x(), b.y());
    // Dabs are 0.3 radii apart, so their union lacks at most 1.2 % of the radius.
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const float distance = distanceTo(x, y, a, b);
            if (distance < 5.9f) {
                EXPECT_EQ(stroke.mask()(x, y), 1) << x << ", " << y;
            }
            if (distance > 6) {
                EXPECT_EQ(stroke.mask()(x, y), 0) << x << ", " << y;
            }
        }
    EXPECT_LE(box.x0, 16);
    EXPECT_GE(box.x1, 55);
}

TEST(SelectionStroke, ErasesAndStaysInThePicture) {
    const Halves picture = makeHalves(40, 30);
    core::SelectionStroke stroke = begin(picture, {.radius = 5, .erase = true}, 1);
    EXPECT_FALSE(stroke.moveTo(0, 0).empty());
    EXPECT_EQ(stroke.mask()(0, 0), 0);
    EXPECT_EQ(stroke.mask()(20, 20), 1);
    for (const float far :
         {-1e9f, 1e30f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_TRUE(stroke.moveTo(far, far).empty()) << far;
    EXPECT_FALSE(stroke.moveTo(39, 29).empty()) << "it goes on afterwards";
    EXPECT_EQ(stroke.mask()(39, 29), 0);
}

TEST(SelectionStroke, ASmallBrushPaintsThePixelUnderIt) {
    const Halves picture = makeHalves(20, 20);
    core::SelectionStroke stroke = begin(picture, {.radius = 0.2f, .hardness = 0});
    static_cast<void>(stroke.moveTo(7.9f, 3.1f));
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) EXPECT_EQ(stroke.mask()(x, y), x == 7 && y == 3 ? 1 : 0);
}

TEST(SelectionStroke, StopsAtDepthEdges) {
    Halves picture = makeHalves(64, 48);
    std::ranges::fill(picture.color.pixels(), core::Vector3f(0.5f, 0.5f, 0.5f));
    core::SelectionStroke stroke = begin(picture, {.radius = 10, .stopAtDepthEdges = true});
    static_cast<void>(stroke.moveTo(28, 24));
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_EQ(stroke.mask()(x, y), x < 32 && distanceTo(x, y, {28, 24}, {28, 24}) <= 10 ? 1 : 0);
}

TEST(SelectionStroke, ASoftRimTakesOnlyWhatLooksAlike) {
    Halves picture = makeHalves(64, 48);
    std::ranges::fill(picture.depth.pixels(), 1.0f);
    core::SelectionStroke stroke = begin(picture, {.radius = 10, .hardness = 0.3f});
    static_cast<void>(stroke.moveTo(26, 24));
    EXPECT_EQ(stroke.mask()(20, 24), 1) << "in the rim, and alike";
    EXPECT_EQ(stroke.mask()(34, 24), 0) << "in the rim, and different";
    core::SelectionStroke hard = begin(picture, {.radius = 10, .hardness = 1});
    static_cast<void>(hard.moveTo(26, 24));
    EXPECT_EQ(hard.mask()(34, 24), 1);
}

// What an event of the pointer costs does not depend on the size of the picture.
TEST(SelectionStroke, AnEventIsQuickInALargePicture) {
    const Halves picture = makeHalves(6000, 4000);
    core::SelectionStroke stroke = begin(picture, {.radius = 80, .hardness = 0.5f, .stopAtDepthEdges = true});
    static_cast<void>(stroke.moveTo(2000, 2000));
    std::vector<double> milliseconds;
    for (int i = 0; i < 15; ++i) {
        const auto start = std::chrono::steady_clock::now();
        static_cast<void>(stroke.moveTo(2000 + 20.0f * static_cast<float>(i), 2000));
        milliseconds.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::sort(milliseconds);
    RecordProperty("median_event_us", static_cast<int>(1000 * milliseconds[7]));
    // Measured in an optimised build: 0.5 ms. Here nothing may grow with the picture, which has 24 million pixels.
    EXPECT_LT(milliseconds[7], 100);
}

}  // namespace
