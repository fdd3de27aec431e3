// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/upsample_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using core::ImageF;
using core::ImageRgb;
using core::upsampleDepth;
using core::Vector3f;

constexpr int kFactor = 5;
constexpr int kLargeWidth = 300;
constexpr int kLargeHeight = 200;

/// A plane of inverse depth at map coordinates of the large picture.
float planeAt(float x, float y) { return 1 / (1.2f + 0.002f * x - 0.001f * y); }

ImageF smallPlane() {
    ImageF depth(kLargeWidth / kFactor, kLargeHeight / kFactor);
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            depth(x, y) = planeAt((static_cast<float>(x) + 0.5f) * kFactor, (static_cast<float>(y) + 0.5f) * kFactor);
    return depth;
}

/// A disc in front of a wall. Its outline in the small map is off by up to half a pixel of the map, and the pixels of
/// the map that it cuts lie between the surfaces, as sensors and phones deliver them.
struct Disc {
    ImageRgb color{kLargeWidth, kLargeHeight, Vector3f(0.1f, 0.15f, 0.1f)};
    ImageF small{kLargeWidth / kFactor, kLargeHeight / kFactor};
    static bool inside(int x, int y) { return std::hypot(x + 0.5 - 148, y + 0.5 - 97) < 61; }
    Disc() {
        for (int j = 0; j < small.height(); ++j) {
            for (int i = 0; i < small.width(); ++i) {
                int covered = 0;
                for (int y = j * kFactor; y < (j + 1) * kFactor; ++y) {
                    for (int x = i * kFactor; x < (i + 1) * kFactor; ++x) {
                        if (!inside(x, y)) continue;
                        ++covered;
                        color(x, y) = Vector3f(0.7f, 0.5f, 0.3f);
                    }
                }
                const float share = static_cast<float>(covered) / (kFactor * kFactor);
                small(i, j) = 1 / (share * 2 + (1 - share) * 1);
            }
        }
    }
};

TEST(UpsampleDepth, APlaneStaysThatPlaneUpToTheBorder) {
    const ImageF large = upsampleDepth(smallPlane(), kLargeWidth, kLargeHeight, nullptr);
    for (int y = 0; y < kLargeHeight; ++y)
        for (int x = 0; x < kLargeWidth; ++x)
            ASSERT_NEAR(large(x, y), planeAt(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f), 2e-4f)
                << x << " " << y;
}

TEST(UpsampleDepth, ASphereHasNoFacets) {
    ImageF depth(60, 40);
    const auto truth = [](float x, float y) {
        const float dx = (x - 150) / 150;
        const float dy = (y - 100) / 150;
        return 1 / (1 + 0.2f * std::sqrt(1.5f - dx * dx - dy * dy));
    };
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            depth(x, y) = truth((static_cast<float>(x) + 0.5f) * kFactor, (static_cast<float>(y) + 0.5f) * kFactor);
    const ImageF large = upsampleDepth(depth, kLargeWidth, kLargeHeight, nullptr);
    for (int y = 20; y < kLargeHeight - 20; ++y) {
        for (int x = 20; x < kLargeWidth - 20; ++x) {
            const auto slope = [&](const auto& z) { return (z(x + 1) - z(x - 1)) / 2; };
            const float found = slope([&](int i) { return large(i, y); });
            const float expected =
                slope([&](int i) { return truth(static_cast<float>(i) + 0.5f, static_cast<float>(y) + 0.5f); });
            // Facets of a bilinear interpolation would change the slope in steps of 2·10⁻⁵.
            ASSERT_NEAR(found, expected, 8e-6f) << x << " " << y;
        }
    }
}

TEST(UpsampleDepth, EdgesFollowTheColours) {
    const Disc disc;
    const auto wrong = [&](const ImageF& large) {
        int count = 0;
        for (int y = 0; y < kLargeHeight; ++y)
            for (int x = 0; x < kLargeWidth; ++x) {
                const float expected = Disc::inside(x, y) ? 0.5f : 1.0f;
                count += std::abs(large(x, y) - expected) > 0.05f ? 1 : 0;
            }
        return count;
    };
    const int guided = wrong(upsampleDepth(disc.small, kLargeWidth, kLargeHeight, &disc.color));
    const int blind = wrong(upsampleDepth(disc.small, kLargeWidth, kLargeHeight, nullptr));
    // The outline is 383 pixels long.
    EXPECT_LE(guided, 12);
    EXPECT_GT(blind, 60) << "the colours are what decides";
}

TEST(UpsampleDepth, NoPixelLiesBetweenTheSurfaces) {
    const Disc disc;
    const ImageF large = upsampleDepth(disc.small, kLargeWidth, kLargeHeight, nullptr);
    for (const float z : large.pixels()) {
        // Within a tenth of the jump: pixels of the map that hold little of the other surface have some weight.
        ASSERT_LT(std::min(std::abs(1 / z - 2), std::abs(1 / z - 1)), 0.1f) << z;
    }
}

TEST(UpsampleDepth, HolesRemainAndLonePixelsAreFilled) {
    ImageF depth = smallPlane();
    depth(10, 10) = 0;
    for (int y = 20; y < 30; ++y)
        for (int x = 20; x < 30; ++x) depth(x, y) = 0;
    const ImageRgb grey(kLargeWidth, kLargeHeight, Vector3f(0.5f, 0.5f, 0.5f));
    const ImageF large = upsampleDepth(depth, kLargeWidth, kLargeHeight, &grey);
    for (int y = 0; y < kLargeHeight; ++y) {
        for (int x = 0; x < kLargeWidth; ++x) {
            const bool deep = x >= 105 && x < 145 && y >= 105 && y < 145;
            const bool outside = x < 95 || x >= 155 || y < 95 || y >= 155;
            if (deep) {
                ASSERT_EQ(large(x, y), 0) << x << " " << y;
            } else if (outside) {
                ASSERT_NEAR(large(x, y), planeAt(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f), 3e-4f)
                    << x << " " << y;
            }
        }
    }
}

TEST(UpsampleDepth, OnePixelAndNothing) {
    const ImageF one = upsampleDepth(ImageF(1, 1, 2.0f), 40, 30, nullptr);
    for (const float z : one.pixels()) ASSERT_NEAR(z, 2, 1e-5f);
    const ImageF nothing = upsampleDepth(ImageF(7, 5, 0.0f), 40, 30, nullptr);
    for (const float z : nothing.pixels()) ASSERT_EQ(z, 0);
}

}  // namespace
