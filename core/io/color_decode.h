// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/image.h"

namespace core {

/// Converts encoded RGB in [0, 1] to scene-linear Rec.709 (D65, relative colorimetric) by an embedded ICC profile, in
/// place; values outside the Rec.709 gamut come out negative or above 1. Grey profiles convert the first channel.
/// Returns false, leaving the pixels, when the profile is damaged or of another colour space than RGB or grey.
[[nodiscard]] bool decodeIcc(std::span<Vector3f> pixels, std::span<const unsigned char> profile);

/// An RGB colour space as ITU-T H.273 codes it (`nclx` in HEIF).
struct CodedRgb {
    std::array<double, 2> red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};  ///< x, y
    std::uint16_t transfer = 2;  ///< TransferCharacteristics; 2 (unspecified) is sRGB
};
/// Converts encoded RGB to scene-linear Rec.709 as `decodeIcc` does. Returns false, leaving the pixels, for transfer
/// characteristics that are not relative to a white (PQ, HLG), logarithmic or reserved, and for impossible
/// chromaticities.
[[nodiscard]] bool decodeCoded(std::span<Vector3f> pixels, const CodedRgb& space);

/// Decodes sRGB in place.
void decodeSrgb(std::span<Vector3f> pixels);
/// Decodes a plain power function in place: linear = encoded^gamma.
void decodeGamma(std::span<Vector3f> pixels, float gamma);

}  // namespace core
