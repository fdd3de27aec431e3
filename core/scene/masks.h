// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"

namespace core {

/// Throws Error(Input), or of another kind, naming the first mask that has not the photograph's size.
void requireMasksFit(const Scene& scene, ErrorKind kind = ErrorKind::Input);
/// Sentences about masks that are the same everywhere in their segment.
[[nodiscard]] Notes maskNotes(const Scene& scene);

}  // namespace core
