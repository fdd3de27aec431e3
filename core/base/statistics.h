// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ranges>

#include "core/base/error.h"

namespace core {

/// The value of rank floor(q · (n − 1)) in increasing order, with q in [0, 1]: 0 = minimum, 1 = maximum. Reorders
/// `values`, which must not be empty.
template <std::ranges::random_access_range Range>
[[nodiscard]] auto quantile(Range&& values, double q) {
    const auto count = std::ranges::distance(values);
    CORE_ASSERT(count > 0, "a quantile needs values");
    const auto rank = std::ranges::begin(values) + static_cast<std::ptrdiff_t>(q * static_cast<double>(count - 1));
    std::ranges::nth_element(values, rank);
    return *rank;
}

/// Median: the value of rank n / 2, so the upper of the two middle values when n is even. Reorders `values`, which must
/// not be empty.
template <std::ranges::random_access_range Range>
[[nodiscard]] auto median(Range&& values) {
    const auto count = std::ranges::distance(values);
    CORE_ASSERT(count > 0, "a median needs values");
    const auto middle = std::ranges::begin(values) + count / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace core
