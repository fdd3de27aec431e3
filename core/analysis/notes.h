// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scene/scene.h"

namespace core {

/// What a user should know about an analysis before trusting an edit: guessed light, reflectances and back sides. Full
/// sentences that say what to do; the most important first, empty when there is nothing to say.
[[nodiscard]] std::vector<std::string> analysisNotes(const Scene& scene, const Analysis& analysis);

}  // namespace core
