// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "core/scene/scene.h"
#include "tests/evaluate/json.h"

namespace evaluate {

/// Objects of a scene selected by a simulated user: each click falls on the middle of the largest region that is still
/// wrong, and adds or removes, until selection and truth overlap by 90 % (intersection over union), at most 12 times.
/// Objects are the labels of at least 400 pixels, without the largest where there are several: the table. One entry per
/// object: clicks (13 = not reached), overlap after one click and at the end, mean distance of the outline [px],
/// seconds per click; beside them the seconds of preparation.
[[nodiscard]] Json selectionReport(const core::Scene& scene, const std::string& name);

/// Table and means, as Markdown.
void printSelections(std::ostream& out, const Json& reports);

}  // namespace evaluate
