// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/directional_map.h"
#include "core/base/image.h"

namespace core {

/// Largest width or height and largest pixel count that is accepted from a file.
inline constexpr int kMaxImageSide = 32768;
inline constexpr long kMaxImagePixels = 200'000'000;

// Reading. The format is recognised by content, not by name: EXR, PNG, TIFF, JPEG, PFM (and PGM, PPM), HDR. Every
// failure is an Error(Input) that names the file. An image is returned as it is displayed: its own EXIF orientation is
// applied, and an EXR data window is placed in its display window (zero outside).

/// Colour as scene-linear Rec.709: integer files are decoded by their ICC profile, otherwise their gamma, otherwise
/// sRGB; float files without a profile are taken as linear, in the primaries they name, else Rec.709. The exposure in
/// the header of an HDR file is undone. Of an EXR with layers, the one that exrColor finds. A single channel is grey.
/// Alpha is ignored. NaN becomes 0, infinity the largest finite value (at least 65504), negative values are clamped to
/// 0; `remarks` says so, and from which of several layers the colour comes.
[[nodiscard]] ImageRgb loadColor(const std::string& path, Notes* remarks = nullptr);
/// One channel of stored values as float, undecoded (16-bit PNG gives 0..65535): of an EXR file the depth (exrDepth),
/// otherwise its only channel; of other files the grey value. A picture whose red, green and blue differ is refused.
/// Only the sign of a PFM's scale is used, for the byte order. `remarks` names the channel of an EXR where it is in a
/// layer.
[[nodiscard]] ImageF loadScalar(const std::string& path, Notes* remarks = nullptr);
/// Channel A beside the depth of a flat image: the share of each pixel that is covered. Empty where there is none.
[[nodiscard]] ImageF loadCoverage(const std::string& path);
/// Bits per sample of the file's stored values, and whether they are floating point.
struct StoredFormat {
    int bits = 8;
    bool floating = false;
};
[[nodiscard]] StoredFormat storedFormat(const std::string& path);
/// Diagonal of a 36 mm x 24 mm frame [mm], to which equivalent focal lengths refer.
inline constexpr double kFilmDiagonal = 43.266615;
/// Maker and model without saying the maker twice: "Apple", "iPhone 12" is "Apple iPhone 12".
[[nodiscard]] std::string deviceName(const std::string& maker, const std::string& model);
/// Properties of a file, without reading its pixels.
struct ImageInfo {
    int width = 0;                   ///< as displayed (orientation applied)
    int height = 0;                  ///< as displayed
    int orientation = 1;             ///< EXIF, 1..8
    std::optional<float> focal35mm;  ///< 35 mm equivalent focal length [mm], also from sensor size
    std::string device;              ///< maker and model of the camera; "" = not stated
    bool hasDepthChannel = false;    ///< an EXR file with a floating-point depth (exrDepth)
    float pixelAspect = 1;           ///< width of a pixel over its height
    StoredFormat format;
};
[[nodiscard]] ImageInfo readImageInfo(const std::string& path);
/// Whether the file's content is one of the formats above. Throws when there is no such file.
[[nodiscard]] bool isImageFile(const std::string& path);
/// What becomes of a black-and-white mask with soft edges: one object, or one segment for each of its values.
enum class MaskEdges { Harden, Keep };
/// Label map: 8 or 16-bit integers (floats when they are whole numbers), palette pictures by index, of a renderer's EXR
/// the object numbers (exrIndices). JPEG is refused. A
/// black-and-white mask with soft edges (Harden), or one in the alpha channel, is one object (core/io/mask_labels.h);
/// `remarks` says so.
[[nodiscard]] LabelImage loadLabels(const std::string& path, Notes* remarks = nullptr,
                                    MaskEdges edges = MaskEdges::Harden);

/// An image file inside another file.
struct EmbeddedImage {
    std::string bytes;
    Message subject;  ///< its name in messages: `the depth map inside "photo.jpg"`
};
[[nodiscard]] ImageRgb loadColor(EmbeddedImage image);
[[nodiscard]] ImageF loadScalar(EmbeddedImage image);
[[nodiscard]] ImageInfo readImageInfo(EmbeddedImage image);

// Writing. The target is replaced atomically: an existing file is never left half written, and survives any failure.
// Throws Error(Output) when it cannot be written, Error(Usage) for an extension the content cannot be stored in.

/// Scene-linear colour to a file whose extension says the format: exr, hdr linear; png (16 bit), tif (16 bit), jpg
/// sRGB-encoded and clipped to [0, 1].
void saveColor(const ImageRgb& image, const std::string& path);
/// Scalars as they are: exr (one channel with the given name), tif and hdr keep floats; png stores `value * pngScale`
/// rounded to 16 bit, and Error(Usage) where one does not fit. No jpg.
void saveScalar(const ImageF& image, const std::string& path, const std::string& channel, float pngScale = 1000.0f);
/// Unit vectors: exr and float tif as x, y, z channels named R, G, B; png and jpg as 0.5 + 0.5·v. No hdr.
void saveVectors(const ImageV3& image, const std::string& path);
/// Positions [m]: exr and float tif as x, y, z channels named R, G, B. Nothing else can hold them.
void savePositions(const ImageV3& image, const std::string& path);
/// png and tif (8 bit up to label 255, else 16), exr (32-bit integers). No jpg, no hdr.
void saveLabels(const LabelImage& image, const std::string& path);
/// Directional map; EXR carries the LatLong envmap attribute and the coverage as a fourth channel. In OpenEXR's frame
/// for such maps (Y up, Z in the centre) our camera frame is X = −x, Y = −y, Z = z.
void saveDirectionalMap(const DirectionalMap& map, const std::string& path);

/// Throws Error(Usage) when `path` has no extension that colour can be saved in: to find out before hours of work.
void requireColorExtension(const std::string& path);
/// Throws Error(Output) when `path` cannot be written; writes nothing.
void requireWritable(const std::string& path);

}  // namespace core
