// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/base/label_table.h"
#include "core/base/pixel.h"
#include "core/base/robust.h"

namespace {

TEST(Statistics, MedianIsTheUpperMiddleValueOfAnEvenCount) {
    EXPECT_EQ(core::median(std::vector{3, 1, 2}), 2);
    EXPECT_EQ(core::median(std::vector{4, 1, 3, 2}), 3);
    EXPECT_EQ(core::median(std::array{7.0f}), 7.0f);
}

TEST(Statistics, QuantileIsTheRankBelow) {
    EXPECT_EQ(core::quantile(std::vector{4, 1, 3, 2}, 0.5), 2);
    EXPECT_EQ(core::quantile(std::vector{5, 1, 4, 2, 3}, 0.0), 1);
    EXPECT_EQ(core::quantile(std::vector{5, 1, 4, 2, 3}, 1.0), 5);
    EXPECT_EQ(core::quantile(std::vector{5, 1, 4, 2, 3}, 0.74), 3);
}

TEST(Robust, WeightsFallFromOne) {
    EXPECT_EQ(core::gemanMcClure(0.0), 1);
    EXPECT_EQ(core::gemanMcClure(1.0f), 0.25f);
    EXPECT_EQ(core::biweight(0.0f), 1);
    EXPECT_EQ(core::biweight(0.5), 0.25);
    EXPECT_EQ(core::biweight(2.0), 0);
}

TEST(PixelBox, ContainsWhatWasAdded) {
    core::PixelBox box;
    EXPECT_TRUE(box.empty());
    box.add({3, 4});
    box.add({1, 6});
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.width(), 3);
    EXPECT_EQ(box.height(), 3);
}

TEST(LabelTable, HoldsOneValuePerLabel) {
    core::LabelTable<bool> flags;
    flags[65535] = true;
    EXPECT_TRUE(flags[65535]);
    EXPECT_FALSE(flags[0]);
}

}  // namespace
