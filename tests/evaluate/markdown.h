// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluate/json.h"

namespace evaluate {

/// A number with `digits` after the point; "–" for a value that is absent or no number.
[[nodiscard]] std::string fixed(const Json& value, int digits);
/// A fraction in per cent.
[[nodiscard]] std::string percent(const Json& value, int digits = 1);

/// Markdown table, written as it is filled.
class Table {
  public:
    Table(std::ostream& out, const std::vector<std::string>& columns);
    void row(const std::vector<std::string>& cells);

  private:
    std::ostream& out_;
};

}  // namespace evaluate
