// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/params.h"

namespace test {

/// A legal value of a parameter that differs from `value`.
inline core::ParamValue otherValue(const core::ParamRow& row, const core::ParamValue& value) {
    if (const auto* on = std::get_if<bool>(&value)) return !*on;
    if (!row.words.empty()) return row.words[row.words[0].value == std::get<std::int64_t>(value) ? 1 : 0].value;
    const double middle = 0.5 * (row.legal.min + row.legal.max);
    if (std::holds_alternative<core::Vector3f>(row.initial))
        return core::Vector3f(0.25f, 0.5f, static_cast<float>(middle));
    const core::ParamValue other = core::fromNumber(row, middle);
    return other != value ? other : core::fromNumber(row, row.legal.max);
}

}  // namespace test
