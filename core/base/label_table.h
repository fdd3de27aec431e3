// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// One value for every label that a label image can hold, by the label.
template <class T>
class LabelTable {
  public:
    static constexpr std::size_t kSize = 65536;
    explicit LabelTable(const T& value = T{}) : values_(kSize, value) {}
    // decltype(auto), because std::vector<bool> hands out proxies.
    [[nodiscard]] decltype(auto) operator[](std::size_t label) { return values_[label]; }
    [[nodiscard]] decltype(auto) operator[](std::size_t label) const { return values_[label]; }
    [[nodiscard]] static constexpr std::size_t size() { return kSize; }

  private:
    std::vector<T> values_;
};

}  // namespace core
