// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/embedded_depth.h"

#include <cmath>
#include <sstream>

#include "core/io/image_io.h"
#include "core/io/import/xmp.h"
#include "core/io/orientation.h"

namespace core {

namespace {

std::string numberText(const std::optional<double>& value) {
    if (!value) return "nothing";
    std::ostringstream text;
    text << *value;
    return text.str();
}

}  // namespace

EmbeddedImage embeddedImage(const ImportFile& file, const std::string& base64, const std::string& what) {
    auto bytes = decodeBase64(base64);
    if (!bytes || bytes->empty()) file.fail(what + " in its XMP is damaged, expected an image in base64");
    return {std::move(*bytes), what + " inside \"" + file.path() + "\""};
}

ImageF decodeRange(const ImportFile& file, const EmbeddedImage& image, const DepthRange& range, int orientation) {
    const bool inverse = range.format == "RangeInverse";
    if (!inverse && range.format != "RangeLinear")
        file.fail("its depth has the format \"" + range.format + "\", expected RangeInverse or RangeLinear");
    if (!range.near || !range.far || !std::isfinite(*range.near) || !std::isfinite(*range.far) || *range.near < 0 ||
        (inverse && *range.near == 0) || *range.far <= *range.near)
        file.fail("its depth goes from " + numberText(range.near) + " (Near) to " + numberText(range.far) +
                  " (Far), expected 0 < Near < Far");
    const ImageInfo info = readImageInfo(image);
    if (info.format.floating || info.format.bits > 16)
        file.fail("its depth map has " + std::to_string(info.format.bits) +
                  "-bit values, expected 8 or 16-bit integers");
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
