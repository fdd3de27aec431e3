// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/image.h"

namespace core {

/// Converts encoded RGB in [0, 1] to scene-linear Rec.709 (D65, relative colorimetric) by an embedded ICC profile, in
/// place; values outside the Rec.709 gamut come out negative or above 1. Grey profiles convert the first channel.
/// Returns false, leaving the pixels, when the profile is damaged or of another colour space than RGB or grey.
[[nodiscard]] bool decodeIcc(std::span<Vector3f> pixels, std::span<const unsigned char> profile);

/// Decodes sRGB in place.
void decodeSrgb(std::span<Vector3f> pixels);
/// Decodes a plain power function in place: linear = encoded^gamma.
void decodeGamma(std::span<Vector3f> pixels, float gamma);

}  // namespace core
