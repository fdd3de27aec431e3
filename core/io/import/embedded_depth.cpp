// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/embedded_depth.h"

#include <algorithm>
#include <cctype>
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

ImageRgb loadSharpPicture(EmbeddedImage image, int orientation) {
    const bool turned = readImageInfo(image).orientation != 1;
    return applyOrientation(loadColor(std::move(image)), turned ? 1 : orientation);
}

void setStoredCamera(ImportedPhoto& photo, const Camera& stored, int orientation) {
    const Camera turned = orientCamera(stored, orientation);
    const float sx = static_cast<float>(photo.color.width()) / static_cast<float>(turned.width);
    const float sy = static_cast<float>(photo.color.height()) / static_cast<float>(turned.height);
    photo.camera = Camera{photo.color.width(), photo.color.height(), turned.fx * sx,
                          turned.fy * sy,      turned.cx * sx,       turned.cy * sy};
}

DepthKind measuredKind(const std::optional<std::string>& measureType) {
    return measureType == "OpticRay" ? DepthKind::Distance : DepthKind::Z;
}

void setLengthUnit(ImportedPhoto& photo, const ImportFile& file, const std::optional<std::string>& stated) {
    struct Unit {
        std::string_view name;
        double metres;
    };
    static constexpr Unit kUnits[] = {
        {"m", 1},      {"meter", 1},           {"meters", 1},         {"metre", 1},
        {"metres", 1}, {"cm", 0.01},           {"centimeters", 0.01}, {"centimetres", 0.01},
        {"mm", 0.001}, {"millimeters", 0.001}, {"millimetres", 0.001}};
    std::string name = stated.value_or("");
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Unit& unit : kUnits)
        if (name == unit.name) {
            photo.unit = unit.metres;
            return;
        }
    photo.assumedUnit =
        (name.empty() || name == "none"
             ? Message("messages",
                       "The depth inside \"%1\" has no unit: 1 is taken as a metre. Give the metres per unit "
                       "to set the true scale.")
                   .with(file.path())
             : Message("messages",
                       "The depth inside \"%1\" has the unit \"%2\", which is not known: 1 is taken as a metre. Give "
                       "the metres per unit to set the true scale.")
                   .with(file.path(), *stated))
            .about(Setting::DepthUnit);
}

}  // namespace core
