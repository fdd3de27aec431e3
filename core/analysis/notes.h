// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/analysis.h"
#include "core/base/message.h"
#include "core/scene/scene.h"

namespace core {

/// What a user should know about an analysis before trusting an edit: guessed light, reflectances and back sides, and
/// what to do about them. The most important first; empty when there is nothing to say.
[[nodiscard]] Notes analysisNotes(const Scene& scene, const Analysis& analysis);

/// Those of them that say why a glossy segment tells little or nothing of the light.
[[nodiscard]] Notes glossyNotes(const Scene& scene, const Analysis& analysis);

}  // namespace core
