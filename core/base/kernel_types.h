// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/image.h"
#include "shaders/shared/interop.h"

namespace core {

// Vectors as code shared with GLSL (shaders/shared) has them, and back.
[[nodiscard]] inline kernel::vec3 toKernel(const Vector3f& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline Vector3f fromKernel(kernel::vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace core
