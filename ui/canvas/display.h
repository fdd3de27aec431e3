// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <cstdint>

#include "core/base/image.h"

namespace ui {

/// sRGB transfer function, [0, 1] to [0, 1]; values outside are clipped.
[[nodiscard]] float encodeSrgb(float linear);
/// Inverse of `encodeSrgb`.
[[nodiscard]] float decodeSrgb(float encoded);

/// Scene-linear colour as the screen shows it, and back; the colours of buttons and swatches.
[[nodiscard]] QColor displayColor(const core::Vector3f& linear);
[[nodiscard]] core::Vector3f linearColor(const QColor& color);

/// Scene-linear picture as 8-bit sRGB, radiance multiplied by 2^`exposureStops`.
[[nodiscard]] QImage displayImage(const core::ImageRgb& linear, float exposureStops = 0);

/// Distinct, light colour of a segment, display-encoded [0, 1]; 0 (no segment) is dark grey.
[[nodiscard]] core::Vector3f segmentColor(std::uint16_t label);

/// Perceptually even colour ramp, dark violet to yellow, display-encoded; `t` in [0, 1].
[[nodiscard]] core::Vector3f rampColor(float t);

}  // namespace ui
