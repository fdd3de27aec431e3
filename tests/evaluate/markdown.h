// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluate/json.h"

namespace evaluate {

/// A number with `digits` decimals; "–" for a missing value or one that is not a number.
[[nodiscard]] std::string fixed(const Json& value, int digits);
/// A fraction as a percentage.
[[nodiscard]] std::string percent(const Json& value, int digits = 1);

/// Markdown table that writes each row immediately.
class Table {
  public:
    Table(std::ostream& out, const std::vector<std::string>& columns);
    void row(const std::vector<std::string>& cells);

  private:
    std::ostream& out_;
};

}  // namespace evaluate
