// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "shaders/shared/interop.h"

namespace core {

/// Luminance of a Rec.709 colour, as the kernels compute it.
[[nodiscard]] inline float luminance(const Vector3f& c) { return kernel::luminance({c.x(), c.y(), c.z()}); }

}  // namespace core
