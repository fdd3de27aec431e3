// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image_io.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/io/color_decode.h"
#include "core/io/exr_layers.h"
#include "core/io/image_reader.h"
#include "core/io/mask_labels.h"
#include "core/io/orientation.h"

namespace core {

namespace {

struct RgbChannels {
    int red = 0, green = 0, blue = 0;
};

void say(Notes* remarks, Message sentence) {
    if (remarks != nullptr) remarks->push_back(std::move(sentence));
}

/// The channel that is called `name` and in no layer; nullopt = none.
std::optional<ExrChannel> plainChannel(const std::vector<ExrChannel>& channels, std::string_view name) {
    const auto found = std::ranges::find_if(channels, [&](const ExrChannel& c) { return c.name() == name; });
    return found == channels.end() ? std::nullopt : std::optional(*found);
}

bool isAlpha(const ExrChannel& channel) { return channel.component == "A" || channel.component == "a"; }

/// The only channel of a file beside alpha; nullopt = it has several.
std::optional<ExrChannel> onlyChannel(const std::vector<ExrChannel>& channels) {
    std::optional<ExrChannel> only;
    for (const ExrChannel& channel : channels) {
        if (isAlpha(channel)) continue;
        if (only) return std::nullopt;
        only = channel;
    }
    return only;
}

/// RGB to linear XYZ of the given primaries and white (x, y pairs: red, green, blue, white).
Eigen::Matrix3d xyzFromRgb(const std::array<double, 8>& c) {
    Eigen::Matrix3d primaries;
    for (int i = 0; i < 3; ++i) {
        const double x = c[static_cast<unsigned>(2 * i)];
        const double y = c[static_cast<unsigned>(2 * i + 1)];
        primaries.col(i) = Eigen::Vector3d(x / y, 1, (1 - x - y) / y);
    }
    const Eigen::Vector3d white(c[6] / c[7], 1, (1 - c[6] - c[7]) / c[7]);
    return primaries * (primaries.inverse() * white).asDiagonal();
}

/// Matrix to Rec.709 of an EXR file that states other primaries (Bradford adaptation of the white point).
std::optional<Eigen::Matrix3f> rec709FromChromaticities(const OIIO::ImageSpec& spec) {
    std::array<float, 8> stored{};
    if (!spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), stored.data()))
        return std::nullopt;
    constexpr std::array<double, 8> kRec709{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
    std::array<double, 8> source{};
    double difference = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        source[i] = static_cast<double>(stored[i]);
        difference = std::max(difference, std::abs(source[i] - kRec709[i]));
    }
    if (!(difference > 1e-3) || source[1] == 0 || source[3] == 0 || source[5] == 0 || source[7] == 0)
        return std::nullopt;
    Eigen::Matrix3d bradford;
    bradford << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
    const auto cone = [&](const std::array<double, 8>& c) {
        return Eigen::Vector3d(bradford * Eigen::Vector3d(c[6] / c[7], 1, (1 - c[6] - c[7]) / c[7]));
    };
    const Eigen::Vector3d scale = cone(kRec709).cwiseQuotient(cone(source));
    const Eigen::Matrix3d adaptation = bradford.inverse() * scale.asDiagonal() * bradford;
    const Eigen::Matrix3d matrix = xyzFromRgb(kRec709).inverse() * adaptation * xyzFromRgb(source);
    if (!matrix.allFinite()) return std::nullopt;
    return matrix.cast<float>();
}

void decodeToLinear(ImageRgb& image, const OIIO::ImageSpec& spec) {
    if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile")) {
        const auto bytes = static_cast<std::size_t>(profile->datasize());
        if (decodeIcc(image.pixels(), {static_cast<const unsigned char*>(profile->data()), bytes})) return;
    }
    if (spec.format.is_floating_point()) {
        if (const auto matrix = rec709FromChromaticities(spec))
            for (Vector3f& p : image.pixels()) p = *matrix * p;
        return;
    }
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const float gamma = spec.get_float_attribute("oiio:Gamma", 0.0f);
    if (space == "Linear" || space == "linear") return;
    const bool plainGamma = gamma > 0 && std::isfinite(gamma) && std::abs(gamma - 2.2f) > 0.05f;
    if (plainGamma)
        decodeGamma(image.pixels(), gamma);
    else
        decodeSrgb(image.pixels());
}

/// What stands for an infinite radiance: the largest finite half float, beyond which renderers' suns overflow.
constexpr float kLargestHalf = 65504;

/// Numbers of pixels whose values are no radiance.
struct ColorFaults {
    std::size_t notANumber = 0;
    std::size_t infinite = 0;
    std::size_t negative = 0;
};

/// Negative values are usual in a small part of a picture: colours outside Rec.709, ringing of a filter.
void remarkOn(const ColorFaults& faults, std::size_t pixels, const std::string& path, Notes* remarks) {
    constexpr double kUsualNegative = 0.05;
    const auto percent = [&](std::size_t count) {
        const double share = 100.0 * static_cast<double>(count) / static_cast<double>(pixels);
        return share < 1 ? std::to_string(count) : std::to_string(std::lround(share)) + " %";
    };
    if (faults.notANumber > 0)
        say(remarks,
            Message("messages",
                    "In \"%1\" %2 of the pixels are not numbers, expected radiance of 0 or more: they count as "
                    "0. Repair the picture first.")
                .with(path, percent(faults.notANumber)));
    if (faults.infinite > 0)
        say(remarks,
            Message("messages",
                    "In \"%1\" %2 of the pixels are infinite, expected radiance of 0 or more: they count as the "
                    "largest finite value of the file, and as %3 at least.")
                .with(path, percent(faults.infinite), kLargestHalf));
    if (static_cast<double>(faults.negative) > kUsualNegative * static_cast<double>(pixels))
        say(remarks,
            Message("messages",
                    "In \"%1\" %2 of the pixels are negative, expected radiance of 0 or more: they count as 0. "
                    "Repair the picture first.")
                .with(path, percent(faults.negative)));
}

/// Replaces what is no radiance, except negative values, which other primaries may make positive.
ColorFaults repairRadiance(ImageRgb& image) {
    ColorFaults faults;
    float largest = kLargestHalf;
    for (const Vector3f& p : image.pixels())
        for (int c = 0; c < 3; ++c)
            if (std::isfinite(p[c])) largest = std::max(largest, p[c]);
    for (Vector3f& p : image.pixels()) {
        if (p.array().isNaN().any())
            ++faults.notANumber;
        else if (p.array().isInf().any() && p.maxCoeff() > largest)
            ++faults.infinite;
        else if (p.minCoeff() < 0)
            ++faults.negative;
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(p[c])) p[c] = p[c] > 0 ? largest : 0.0f;
    }
    return faults;
}

/// Goes to the part that holds the colour and finds its channels there.
RgbChannels seekExrColor(ImageReader& reader, const std::string& path, Notes* remarks) {
    const std::vector<ExrChannel> channels = exrChannels(reader.parts());
    if (const auto color = exrColor(channels)) {
        if (!color->others.empty()) {
            std::string others;
            for (const std::string& layer : color->others) others += (others.empty() ? "" : ", ") + layer;
            say(remarks, Message("messages", "The colour is read from layer \"%1\" of \"%2\", which has others: %3.")
                             .with(color->layer, path, others));
        }
        reader.goToPart(color->part);
        return {color->channels[0], color->channels[1], color->channels[2]};
    }
    auto grey = plainChannel(channels, "Y");
    if (!grey) grey = onlyChannel(channels);
    if (!grey)
        reader.fail(
            Message("messages", "it has no channels R, G, B in any layer, only %1").with(exrChannelNames(channels)));
    reader.goToPart(grey->part);
    return {grey->index, grey->index, grey->index};
}

ImageRgb readColor(ImageReader& reader, const std::string& path = {}, Notes* remarks = nullptr) {
    RgbChannels channels;
    if (reader.format() == "openexr")
        channels = seekExrColor(reader, path, remarks);
    else if (reader.spec().nchannels > 2)
        channels = {0, 1, 2};
    ImageRgb image = reader.readRgb(channels.red, channels.green, channels.blue);
    remarkOn(repairRadiance(image), image.size(), path, remarks);
    decodeToLinear(image, reader.spec());
    for (Vector3f& p : image.pixels())
        for (int c = 0; c < 3; ++c) p[c] = std::isfinite(p[c]) ? std::max(p[c], 0.0f) : 0.0f;
    return applyOrientation(std::move(image), reader.orientation());
}

/// A grey picture, or one whose red, green and blue are the same. The compression of a JPEG changes its colours a
/// little.
ImageF readGrey(ImageReader& reader) {
    constexpr float kJpegTolerance = 12.0f / 255;
    if (reader.spec().nchannels < 3) return reader.readChannel(0);
    const float tolerance = reader.format() == "jpeg" ? kJpegTolerance : 0.0f;
    const float scale = reader.integerScale();
    // All at once, because an embedded picture can be read only once.
    const ImageRgb color = reader.readRgb(0, 1, 2);
    ImageF grey(color.width(), color.height());
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const Vector3f& p = color[i];
        if (p.maxCoeff() - p.minCoeff() > tolerance)
            reader.fail(Message("messages", "it is a colour picture, expected one number per pixel"));
        grey[i] = scale == 1 ? p.x() : std::round(p.x() * scale);
    }
    return grey;
}

/// Whether two channels are the same, also where there is no number.
bool sameNumbers(const ImageF& a, const ImageF& b) {
    return std::ranges::equal(a.pixels(), b.pixels(),
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// The depth of an EXR file; otherwise the only number that each of its pixels has.
ImageF readExrScalar(ImageReader& reader, const std::string& path, Notes* remarks) {
    const std::vector<ExrChannel> channels = exrChannels(reader.parts());
    const auto color = exrColor(channels);
    auto scalar = exrDepth(channels);
    if (scalar && scalar->name() != "Z")
        say(remarks, Message("messages", "The depth is channel \"%1\" of \"%2\".").with(scalar->name(), path));
    if (!scalar && !color) scalar = plainChannel(channels, "Y");
    if (!scalar && !color) scalar = onlyChannel(channels);
    if (scalar) {
        reader.goToPart(scalar->part);
        return reader.readChannel(scalar->index);
    }
    if (color) {
        reader.goToPart(color->part);
        ImageF red = reader.readChannel(color->channels[0]);
        if (sameNumbers(reader.readChannel(color->channels[1]), red) &&
            sameNumbers(reader.readChannel(color->channels[2]), red))
            return red;
    }
    reader.fail(Message("messages", "none of its channels is a depth map: %1").with(exrChannelNames(channels)));
}

ImageF readScalar(ImageReader& reader, const std::string& path = {}, Notes* remarks = nullptr) {
    if (reader.ignoredScale() != 1)
        say(remarks,
            Message("messages",
                    "The scale %1 in the header of \"%2\" is not applied: its values are taken as they are stored.")
                .with(reader.ignoredScale(), path));
    ImageF values = reader.format() == "openexr" ? readExrScalar(reader, path, remarks) : readGrey(reader);
    return applyOrientation(std::move(values), reader.orientation());
}

/// 35 mm equivalent of a focal length whose sensor is known by its pixels per length (EXIF 2.32, 4.6.5: tags
/// FocalPlaneXResolution and FocalPlaneResolutionUnit). A picture made smaller since then keeps PixelXDimension.
std::optional<float> focalFromSensor(const OIIO::ImageSpec& spec) {
    constexpr float kCentimetre = 10;
    constexpr float kInch = 25.4f;
    const float focal = spec.get_float_attribute("Exif:FocalLength", 0.0f);
    const float resolution = spec.get_float_attribute("Exif:FocalPlaneXResolution", 0.0f);
    if (!(std::isfinite(focal) && focal > 0 && std::isfinite(resolution) && resolution > 0)) return std::nullopt;
    float unit = kInch;
    switch (spec.get_int_attribute("Exif:FocalPlaneResolutionUnit", 2)) {
        case 3:
            unit = kCentimetre;
            break;
        case 4:
            unit = 1;
            break;
        case 5:
            unit = 1e-3f;
            break;
        default:
            break;
    }
    const int width = spec.get_int_attribute("Exif:PixelXDimension", spec.width);
    const int height = spec.get_int_attribute("Exif:PixelYDimension", spec.height);
    if (width <= 0 || height <= 0) return std::nullopt;
    const auto diagonal = static_cast<float>(std::hypot(width, height)) * unit / resolution;  // of the sensor [mm]
    return focal * static_cast<float>(kFilmDiagonal) / diagonal;
}

ImageInfo readInfo(ImageReader& reader) {
    const OIIO::ImageSpec& spec = reader.spec();
    ImageInfo info;
    info.orientation = reader.orientation();
    info.width = info.orientation >= 5 ? reader.height() : reader.width();
    info.height = info.orientation >= 5 ? reader.width() : reader.height();
    if (const float focal = spec.get_float_attribute("Exif:FocalLengthIn35mmFilm", 0.0f);
        std::isfinite(focal) && focal > 0)
        info.focal35mm = focal;
    else
        info.focal35mm = focalFromSensor(spec);
    if (const float aspect = spec.get_float_attribute("PixelAspectRatio", 1.0f); std::isfinite(aspect) && aspect > 0)
        info.pixelAspect = aspect;
    info.device = deviceName(spec.get_string_attribute("Make"), spec.get_string_attribute("Model"));
    info.format.floating = spec.format.is_floating_point();
    info.format.bits = static_cast<int>(spec.format.basesize() * 8);
    if (reader.format() != "openexr") return info;
    const std::vector<OIIO::ImageSpec> parts = reader.parts();
    const std::vector<ExrChannel> channels = exrChannels(parts);
    const auto depth = exrDepth(channels);
    info.hasDepthChannel =
        depth && parts[static_cast<std::size_t>(depth->part)].channelformat(depth->index).is_floating_point();
    return info;
}

}  // namespace

ImageRgb loadColor(const std::string& path, Notes* remarks) {
    ImageReader reader(path);
    return readColor(reader, path, remarks);
}

ImageRgb loadColor(EmbeddedImage image) {
    ImageReader reader(std::move(image));
    return readColor(reader);
}

ImageF loadScalar(const std::string& path, Notes* remarks) {
    ImageReader reader(path);
    return readScalar(reader, path, remarks);
}

ImageF loadScalar(EmbeddedImage image) {
    ImageReader reader(std::move(image));
    return readScalar(reader);
}

ImageF loadCoverage(const std::string& path) {
    ImageReader reader(path);
    const std::vector<OIIO::ImageSpec> parts = reader.parts();
    const std::vector<ExrChannel> channels = exrChannels(parts);
    const auto depth = exrDepth(channels);
    if (!depth || parts[static_cast<std::size_t>(depth->part)].deep) return {};
    for (const ExrChannel& channel : channels) {
        if (channel.part != depth->part || !isAlpha(channel)) continue;
        reader.goToPart(channel.part);
        return applyOrientation(reader.readChannel(channel.index), reader.orientation());
    }
    return {};
}

std::string deviceName(const std::string& maker, const std::string& model) {
    if (maker.empty() || model.starts_with(maker)) return model;
    return model.empty() ? maker : maker + " " + model;
}

ImageInfo readImageInfo(const std::string& path) {
    ImageReader reader(path);
    return readInfo(reader);
}

ImageInfo readImageInfo(EmbeddedImage image) {
    ImageReader reader(std::move(image));
    return readInfo(reader);
}

StoredFormat storedFormat(const std::string& path) { return readImageInfo(path).format; }

namespace {

/// Object numbers of an EXR file; otherwise a grey or palette picture.
ImageF readLabelValues(ImageReader& reader) {
    const bool isExr = reader.format() == "openexr";
    const std::vector<ExrChannel> channels = isExr ? exrChannels(reader.parts()) : std::vector<ExrChannel>();
    if (const auto indices = exrIndices(channels)) {
        reader.goToPart(indices->part);
        return reader.readChannel(indices->index);
    }
    ImageF values = reader.readChannel(0);
    if (reader.spec().nchannels < 3) return values;
    for (int channel = 1; channel < 3; ++channel) {
        if (reader.readChannel(channel) == values) continue;
        if (hasCryptomatte(channels))
            reader.fail(Message("messages",
                                "it has Cryptomatte layers, which Patina does not read, and no layer of object numbers "
                                "(IndexOB); its channels are %1")
                            .with(exrChannelNames(channels)));
        if (isExr)
            reader.fail(Message("messages",
                                "it is a colour picture, expected one number per pixel, or a layer of object numbers "
                                "(IndexOB); its channels are %1")
                            .with(exrChannelNames(channels)));
        reader.fail(Message("messages", "it is a colour picture, expected one number per pixel (grey or palette)"));
    }
    return values;
}

}  // namespace

LabelImage loadLabels(const std::string& path, Notes* remarks, MaskEdges edges) {
    ImageReader reader(path, ImageReader::Palette::Indices);
    if (reader.format() == "jpeg")
        reader.fail(Message(
            "messages", "it is a JPEG picture, whose compression changes label numbers; expected PNG, TIFF or EXR"));
    ImageF values = readLabelValues(reader);
    const auto remark = [&](const std::optional<Message>& sentence) {
        if (sentence && remarks != nullptr) remarks->push_back(*sentence);
    };
    const float maximum = reader.integerScale();
    const int alpha = reader.spec().alpha_channel;
    if (alpha > 0) remark(takeObjectFromAlpha(values, reader.readChannel(alpha), maximum, path));
    if (edges == MaskEdges::Harden) remark(hardenMask(values, maximum, path));
    LabelImage labels(values.width(), values.height());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const float value = values[i];
        if (!(value >= 0 && value <= 65535) || value != std::floor(value))
            reader.fail(
                Message("messages", "it contains the label %1, expected whole numbers from 0 to 65535").with(value));
        labels[i] = static_cast<std::uint16_t>(value);
    }
    return applyOrientation(std::move(labels), reader.orientation());
}

}  // namespace core
