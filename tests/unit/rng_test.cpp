// SPDX-License-Identifier: GPL-3.0-or-later
#include "shaders/shared/rng.h"

#include <gtest/gtest.h>

#include <set>

TEST(Rng, HashIsPcg4d) {
    // Computed by an independent implementation with unbounded integers.
    const kernel::uvec4 zero = kernel::rng_hash(kernel::uvec4(0, 0, 0, 0));
    EXPECT_EQ(zero.x, 0x0f02f829u);
    EXPECT_EQ(zero.y, 0x2d568769u);
    EXPECT_EQ(zero.z, 0x32b0c43bu);
    EXPECT_EQ(zero.w, 0xd32548eau);
    const kernel::uvec4 h = kernel::rng_hash(kernel::uvec4(1, 2, 3, 4));
    EXPECT_EQ(h.x, 0x3622cd16u);
    EXPECT_EQ(h.y, 0xf11471d8u);
    EXPECT_EQ(h.z, 0xe1109b3fu);
    EXPECT_EQ(h.w, 0x02b94c2fu);
}

TEST(Rng, FloatsStayBelowOne) {
    EXPECT_EQ(kernel::rng_to_float(0), 0.0f);
    EXPECT_LT(kernel::rng_to_float(0xffffffffu), 1.0f);
}

TEST(Rng, PairsAreTheSingleDimensions) {
    for (kernel::uint d = 0; d < 16; d += 2) {
        const kernel::vec2 pair = kernel::rng_vec2(11, 12, d, 13);
        EXPECT_EQ(pair.x, kernel::rng_float(11, 12, d, 13));
        EXPECT_EQ(pair.y, kernel::rng_float(11, 12, d + 1, 13));
    }
}

TEST(Rng, StreamsDiffer) {
    std::set<kernel::uint> seeds;
    for (kernel::uint stream = 0; stream < 1000; ++stream) seeds.insert(kernel::rng_stream(1, stream));
    EXPECT_EQ(seeds.size(), 1000u);
}
