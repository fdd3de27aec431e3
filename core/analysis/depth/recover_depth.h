// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/step.h"

namespace core::analysis {

/// Depth of a scene's photograph as the other steps see it (docs/method.md#depth): without flying pixels and noise,
/// known at every pixel of a segment that has any depth, its surfaces smooth. Throws Error(Input) when the photograph
/// has no valid depth at all.
[[nodiscard]] RecoveredDepth recoverDepth(const Scene& scene, const StepContext& context);

}  // namespace core::analysis
