// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/directional_map.h"
#include "core/image.h"

namespace core {

/// Largest width or height and largest pixel count that is accepted from a file.
inline constexpr int kMaxImageSide = 32768;
inline constexpr long kMaxImagePixels = 200'000'000;

/// Colour as scene-linear Rec.709: 8/16-bit files are decoded by their ICC profile or transfer function (sRGB when
/// they say nothing), float files are taken as linear. NaN and Inf become 0, negative values are clamped to 0.
[[nodiscard]] ImageRgb loadColor(const std::string& path);
/// One channel of stored values as float, undecoded (16-bit PNG gives 0..65535); channel Z, else Y, else the first.
[[nodiscard]] ImageF loadScalar(const std::string& path);
/// Bits per sample of the file's stored values, and whether they are floating point.
struct StoredFormat {
    int bits = 8;
    bool floating = false;
};
[[nodiscard]] StoredFormat storedFormat(const std::string& path);
/// Label map: 8 or 16-bit integers, or an indexed/grey picture.
[[nodiscard]] LabelImage loadLabels(const std::string& path);

/// Scene-linear colour to a file whose extension says the format: exr, hdr linear; png (16 bit), tif (16 bit), jpg
/// sRGB-encoded and clipped to [0, 1]. Throws Error(Output) when it cannot be written, Error(Usage) for an unknown
/// extension. Writes to a temporary file first: an existing file is never left half written.
void saveColor(const ImageRgb& image, const std::string& path);
/// Scalars as they are: exr, tif and hdr keep floats; png stores `value * pngScale` rounded to 16 bit.
void saveScalar(const ImageF& image, const std::string& path, const std::string& channel, float pngScale = 1000.0f);
/// Vectors in [-1, 1] or metres: exr as x, y, z channels named R, G, B; 8/16-bit formats as 0.5 + 0.5·v.
void saveVectors(const ImageV3& image, const std::string& path);
void saveLabels(const LabelImage& image, const std::string& path);
/// Directional map; EXR carries the LatLong envmap attribute.
void saveDirectionalMap(const DirectionalMap& map, const std::string& path);

}  // namespace core
