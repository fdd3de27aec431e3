// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/base/image.h"
#include "core/io/image_io.h"
#include "core/io/import/import_format.h"

namespace core {

/// An image in base64 inside `file`. `what` names it: `the depth map`. Throws Error(Input) when it is no base64.
[[nodiscard]] EmbeddedImage embeddedImage(const ImportFile& file, const std::string& base64, const Message& what);

/// A range [Near, Far] that Google's depth maps and XDM store in integers.
struct DepthRange {
    std::string format;  ///< RangeLinear or RangeInverse
    std::optional<double> near;
    std::optional<double> far;
};

/// A depth image whose integers fill `range`, as depths in the unit of `range`. It is turned by `orientation`, unless
/// it says itself how it is oriented. Throws Error(Input).
[[nodiscard]] ImageF decodeRange(const ImportFile& file, const EmbeddedImage& image, const DepthRange& range,
                                 int orientation);

/// The picture before the camera's artificial blur, turned by `orientation` unless it says itself how it is oriented.
/// Throws Error(Input).
[[nodiscard]] ImageRgb loadSharpPicture(EmbeddedImage image, int orientation);

/// Intrinsics of `photo.color`, as displayed, from those of the same picture as stored, at any size.
void setStoredCamera(ImportedPhoto& photo, const Camera& stored, int orientation);

/// Kind of depth by the property MeasureType of Google's depth maps: along the optical axis unless it is OpticRay.
[[nodiscard]] DepthKind measuredKind(const std::optional<std::string>& measureType);

/// Takes over the unit of depth as XMP states it: m, cm, mm, and their names. What is missing or unknown is taken as a
/// metre, and `photo.assumedUnit` says so.
void setLengthUnit(ImportedPhoto& photo, const ImportFile& file, const std::optional<std::string>& stated);

}  // namespace core
