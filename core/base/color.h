// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/base/image.h"
#include "shaders/shared/interop.h"

namespace core {

/// sRGB transfer function (IEC 61966-2-1): display-encoded value in [0, 1] to linear. No clamping.
[[nodiscard]] inline float srgbDecode(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}
/// Inverse of `srgbDecode`.
[[nodiscard]] inline float srgbEncode(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Luminance of a Rec.709 colour, as the kernels compute it.
[[nodiscard]] inline float luminance(const Vector3f& c) { return kernel::luminance({c.x(), c.y(), c.z()}); }

}  // namespace core
