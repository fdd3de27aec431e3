// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/depth/filter_depth.h"

namespace {

using core::ImageF;
using core::LabelImage;

TEST(CompleteSegments, SpansHolesFromTheSegmentOnly) {
    LabelImage labels(40, 30, 0);
    ImageF depth(40, 30, 0.0f);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            if (x < 20) labels(x, y) = 1;
            if (x >= 24) labels(x, y) = 2;
            // A plane in inverse depth is harmonic, so the membrane over a hole inside it is that plane.
            if (labels(x, y) == 1) depth(x, y) = 1.0f / (1.0f + 0.01f * static_cast<float>(x + y));
            if (labels(x, y) == 2) depth(x, y) = 5.0f;
        }
    }
    for (int y = 8; y < 20; ++y)
        for (int x = 5; x < 14; ++x) depth(x, y) = 0;
    for (int y = 0; y < 30; ++y) depth(24, y) = 0;

    core::analysis::completeSegments(depth, labels);
    for (int y = 8; y < 20; ++y)
        for (int x = 5; x < 14; ++x)
            EXPECT_NEAR(1.0f / depth(x, y), 1.0f + 0.01f * static_cast<float>(x + y), 1e-3f) << x << ' ' << y;
    for (int y = 0; y < 30; ++y) {
        EXPECT_NEAR(depth(24, y), 5.0f, 1e-4f);  // continued from its own segment, not from the nearer one
        EXPECT_EQ(depth(22, y), 0.0f);           // unlabelled: distant
    }
}

TEST(CompleteSegments, LeavesValidPixelsAndEmptySegmentsAlone) {
    LabelImage labels(8, 8, 3);
    ImageF depth(8, 8, 2.0f);
    depth(4, 4) = 0;
    for (int y = 0; y < 8; ++y) labels(0, y) = 4, depth(0, y) = 0;
    core::analysis::completeSegments(depth, labels);
    EXPECT_NEAR(depth(4, 4), 2.0f, 1e-5f);
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(depth(0, y), 0.0f);  // nothing is known of segment 4
        for (int x = 1; x < 8; ++x) {
            if (x == 4 && y == 4) continue;
            EXPECT_EQ(depth(x, y), 2.0f);
        }
    }
}

}  // namespace
