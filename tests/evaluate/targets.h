// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "tests/evaluate/json.h"

namespace evaluate {

/// What reconstruction has to reach, judged from the other parts of an evaluation ("analysis", "edits", "speed"):
/// entries {"target", "reached", "met"}. What was not evaluated is left out.
[[nodiscard]] Json judgeTargets(const Json& evaluation);

/// Table of the targets, as Markdown.
void printTargets(std::ostream& out, const Json& targets);

}  // namespace evaluate
