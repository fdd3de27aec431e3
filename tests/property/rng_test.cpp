// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "shaders/shared/rng.h"
#include "tests/support/statistics.h"

namespace {

constexpr int kTests = 30;  // p-values computed in this file, for the Šidák correction

template <class F>
double uniformP(const F& value, kernel::uint count) {
    std::vector<double> observed(256);
    for (kernel::uint i = 0; i < count; ++i) ++observed[static_cast<std::size_t>(value(i) * 256)];
    return test::chiSquareP(observed, std::vector<double>(256, count / 256.0));
}

template <class F>
double independentP(const F& pair, kernel::uint count) {
    std::vector<double> observed(1024);
    for (kernel::uint i = 0; i < count; ++i) {
        const auto [a, b] = pair(i);
        ++observed[static_cast<std::size_t>(a * 32) * 32 + static_cast<std::size_t>(b * 32)];
    }
    return test::chiSquareP(observed, std::vector<double>(1024, count / 1024.0));
}

TEST(Rng, EveryCounterAloneIsUniform) {
    const double significance = test::sidak(0.01, kTests);
    for (kernel::uint d = 0; d < 8; ++d) {
        EXPECT_GT(uniformP([d](kernel::uint i) { return kernel::rng_float(i, 3, d, 1); }, 200000), significance) << d;
        EXPECT_GT(uniformP([d](kernel::uint i) { return kernel::rng_float(7, i, d, 1); }, 200000), significance) << d;
    }
    EXPECT_GT(uniformP([](kernel::uint i) { return kernel::rng_float(7, 3, i, 1); }, 200000), significance);
    EXPECT_GT(uniformP([](kernel::uint i) { return kernel::rng_float(7, 3, 0, i); }, 200000), significance);
}

TEST(Rng, DimensionsPixelsAndSamplesAreIndependent) {
    const double significance = test::sidak(0.01, kTests);
    using Pair = std::pair<float, float>;
    for (const auto& [a, b] : {std::pair{0u, 1u}, {1u, 2u}, {2u, 3u}, {0u, 4u}, {1u, 5u}, {3u, 6u}})
        EXPECT_GT(
            independentP(
                [a, b](kernel::uint i) {
                    return Pair{kernel::rng_float(i % 640, i / 640, a, 1), kernel::rng_float(i % 640, i / 640, b, 1)};
                },
                200000),
            significance)
            << a << " " << b;
    EXPECT_GT(independentP(
                  [](kernel::uint i) {
                      return Pair{kernel::rng_float(i, 0, 0, 1), kernel::rng_float(i + 1, 0, 0, 1)};
                  },
                  200000),
              significance);
    EXPECT_GT(independentP(
                  [](kernel::uint i) {
                      return Pair{kernel::rng_float(5, i, 0, 1), kernel::rng_float(5, i + 1, 0, 1)};
                  },
                  200000),
              significance);
    EXPECT_GT(independentP(
                  [](kernel::uint i) {
                      return Pair{kernel::rng_float(i, 0, 0, 1), kernel::rng_float(i, 0, 0, 2)};
                  },
                  200000),
              significance);
}

}  // namespace
