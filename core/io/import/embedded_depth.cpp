// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/embedded_depth.h"

#include <cmath>

#include "core/io/image_io.h"
#include "core/io/import/xmp.h"
#include "core/io/orientation.h"

namespace core {

namespace {

Message numberText(const std::optional<double>& value) {
    return value ? Message(*value) : Message("messages", "nothing");
}

}  // namespace

EmbeddedImage embeddedImage(const ImportFile& file, const std::string& base64, const Message& what) {
    auto bytes = decodeBase64(base64);
    if (!bytes || bytes->empty())
        file.fail(Message("messages", "%1 in its XMP is damaged, expected an image in base64").with(what));
    return {std::move(*bytes), Message("messages", "%1 inside \"%2\"").with(what, file.path())};
}

ImageF decodeRange(const ImportFile& file, const EmbeddedImage& image, const DepthRange& range, int orientation) {
    const bool inverse = range.format == "RangeInverse";
    if (!inverse && range.format != "RangeLinear")
        file.fail(Message("messages", "its depth has the format \"%1\", expected RangeInverse or RangeLinear")
                      .with(range.format));
    if (!range.near || !range.far || !std::isfinite(*range.near) || !std::isfinite(*range.far) || *range.near < 0 ||
        (inverse && *range.near == 0) || *range.far <= *range.near)
        file.fail(Message("messages", "its depth goes from %1 (Near) to %2 (Far), expected 0 < Near < Far")
                      .with(numberText(range.near), numberText(range.far)));
    const ImageInfo info = readImageInfo(image);
    if (info.format.floating || info.format.bits > 16)
        file.fail(Message("messages", "its depth map has %1-bit values, expected 8 or 16-bit integers")
                      .with(info.format.bits));
    const double most = std::exp2(info.format.bits) - 1;
    ImageF depth = loadScalar(image);
    for (float& value : depth.pixels()) {
        const double n = static_cast<double>(value) / most;
        const double z = inverse ? *range.far * *range.near / (*range.far - n * (*range.far - *range.near))
                                 : *range.near + n * (*range.far - *range.near);
        value = static_cast<float>(z);
    }
    return applyOrientation(std::move(depth), info.orientation == 1 ? orientation : 1);
}

}  // namespace core
