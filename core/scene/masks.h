// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"

namespace core {

/// Throws an error of this kind naming the first mask whose size is not the photograph's.
void requireMasksFit(const Scene& scene, ErrorKind kind = ErrorKind::Input);
/// Sentences about masks that are constant in their segment.
[[nodiscard]] Notes maskNotes(const Scene& scene);

}  // namespace core
