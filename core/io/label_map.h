// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace core {

/// The scene with its labels in a file beside the project: a PNG called NAME.segments-HASH.png after its content, so
/// that a file once written never changes and an older project stays readable. Throws Error(Output).
[[nodiscard]] Scene withSavedLabels(const Scene& scene, const std::string& project);

/// Writes a mask as a picture, 255 where it is 1 and 0 elsewhere. Throws Error(Output).
void saveMask(const BinaryMask& mask, const std::string& path);

}  // namespace core
