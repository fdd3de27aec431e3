// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "tests/evaluate/json.h"

namespace evaluate {

/// Targets of the reconstruction, judged from the other parts of an evaluation ("analysis", "edits", "speed",
/// "selection"): entries
/// {"target", "reached", "met"}. Parts that were not evaluated are left out.
[[nodiscard]] Json judgeTargets(const Json& evaluation);

/// Table of the targets, as Markdown.
void printTargets(std::ostream& out, const Json& targets);

}  // namespace evaluate
