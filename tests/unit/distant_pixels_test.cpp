// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/distant_pixels.h"

#include <gtest/gtest.h>

namespace {

using core::ImageF;
using core::Vector3f;

TEST(DistantPixels, RegionsAtTheBorderAreDistantButForTheirRim) {
    ImageF depth(40, 30, 1.0f);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 40; ++x) depth(x, y) = 0;
    const auto distant = core::analysis::findDistantPixels(depth);
    EXPECT_EQ(distant(20, 0), 1);
    EXPECT_EQ(distant(20, 8), 1);
    EXPECT_EQ(distant(20, 9), 0) << "mixes with what has depth";
    EXPECT_EQ(distant(20, 10), 0);
}

TEST(DistantPixels, SmallEnclosedHolesAreNotLargeOnesAre) {
    ImageF depth(100, 100, 1.0f);
    for (int y = 10; y < 20; ++y)
        for (int x = 10; x < 20; ++x) depth(x, y) = 0;  // 1 %
    for (int y = 40; y < 60; ++y)
        for (int x = 40; x < 60; ++x) depth(x, y) = 0;  // 4 %
    const auto distant = core::analysis::findDistantPixels(depth);
    EXPECT_EQ(distant(15, 15), 0);
    EXPECT_EQ(distant(50, 50), 1);
}

TEST(DistantPixels, RaysEndAtTheirVanishingPoint) {
    core::Photo photo;
    photo.camera = {40, 30, 40, 40, 20, 15};
    photo.color = core::ImageRgb(40, 30, Vector3f(1, 2, 3));
    photo.color(30, 5) = Vector3f(7, 8, 9);
    ImageF depth(40, 30, 0.0f);
    const auto distant = core::analysis::findDistantPixels(depth);
    const Vector3f d = photo.camera.pixelRay(30, 5).normalized();
    EXPECT_EQ(core::analysis::distantColor(photo, distant, d), Vector3f(7, 8, 9));
    EXPECT_FALSE(core::analysis::distantColor(photo, distant, {0, 0, -1}));
    EXPECT_FALSE(core::analysis::distantColor(photo, distant, Vector3f(5, 0, 1).normalized()));
}

}  // namespace
