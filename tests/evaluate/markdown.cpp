// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/markdown.h"

#include <cmath>
#include <cstdio>

namespace evaluate {

std::string fixed(const Json& value, int digits) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) return "–";
    char text[64];
    std::snprintf(text, sizeof(text), "%.*f", digits, value.get<double>());
    return text;
}

std::string percent(const Json& value, int digits) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) return "–";
    return fixed(100 * value.get<double>(), digits) + " %";
}

Table::Table(std::ostream& out, const std::vector<std::string>& columns) : out_(out) {
    row(columns);
    row(std::vector<std::string>(columns.size(), "---"));
}

void Table::row(const std::vector<std::string>& cells) {
    out_ << '|';
    for (const std::string& cell : cells) out_ << ' ' << cell << " |";
    out_ << '\n';
}

}  // namespace evaluate
