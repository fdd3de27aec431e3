// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image_io.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/io/color_decode.h"
#include "core/io/image_reader.h"
#include "core/io/mask_labels.h"
#include "core/io/orientation.h"

namespace core {

namespace {

struct RgbChannels {
    int red = 0, green = 0, blue = 0;
};

std::optional<RgbChannels> findRgb(const OIIO::ImageSpec& spec) {
    const std::string names[][3] = {{"R", "G", "B"}, {"red", "green", "blue"}};
    for (const auto& name : names) {
        const RgbChannels found{findChannel(spec, name[0]), findChannel(spec, name[1]), findChannel(spec, name[2])};
        if (found.red >= 0 && found.green >= 0 && found.blue >= 0) return found;
    }
    return std::nullopt;
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
    if (spec.format.is_floating_point()) {
        if (const auto matrix = rec709FromChromaticities(spec))
            for (Vector3f& p : image.pixels()) p = *matrix * p;
        return;
    }
    if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile")) {
        const auto bytes = static_cast<std::size_t>(profile->datasize());
        if (decodeIcc(image.pixels(), {static_cast<const unsigned char*>(profile->data()), bytes})) return;
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

/// Numbers of pixels whose values are no radiance.
struct ColorFaults {
    std::size_t notFinite = 0;
    std::size_t negative = 0;
};

/// Negative values are usual in a small part of a picture: colours outside Rec.709, ringing of a filter.
std::optional<Message> remarkOn(const ColorFaults& faults, std::size_t pixels, const std::string& path) {
    constexpr double kUsualNegative = 0.05;
    const auto percent = [&](std::size_t count) {
        const double share = 100.0 * static_cast<double>(count) / static_cast<double>(pixels);
        return share < 1 ? std::to_string(count) : std::to_string(std::lround(share)) + " %";
    };
    const bool negative = static_cast<double>(faults.negative) > kUsualNegative * static_cast<double>(pixels);
    if (faults.notFinite > 0 && negative)
        return Message(
                   "messages",
                   "In \"%1\" %2 of the pixels are not finite numbers and %3 are negative, expected radiance of 0 or "
                   "more: they count as 0. Repair the picture first.")
            .with(path, percent(faults.notFinite), percent(faults.negative));
    if (faults.notFinite > 0)
        return Message(
                   "messages",
                   "In \"%1\" %2 of the pixels are not finite numbers, expected radiance of 0 or more: they count as "
                   "0. Repair the picture first.")
            .with(path, percent(faults.notFinite));
    if (negative)
        return Message(
                   "messages",
                   "In \"%1\" %2 of the pixels are negative, expected radiance of 0 or more: they count as 0. Repair "
                   "the picture first.")
            .with(path, percent(faults.negative));
    return std::nullopt;
}

ImageRgb readColor(ImageReader& reader, ColorFaults* faults = nullptr) {
    reader.seekPart([](const OIIO::ImageSpec& spec) { return findRgb(spec).has_value(); });
    const OIIO::ImageSpec& spec = reader.spec();
    RgbChannels channels;
    if (const auto named = findRgb(spec))
        channels = *named;
    else if (const int luminance = findChannel(spec, "Y"); luminance >= 0)
        channels = {luminance, luminance, luminance};
    else if (spec.nchannels > 2 && reader.format() != "openexr")
        channels = {0, 1, 2};
    else if (spec.nchannels <= 2 || reader.format() != "openexr")
        channels = {0, 0, 0};
    else
        reader.fail(Message("messages", "it has no channels R, G, B"));
    ImageRgb image = reader.readRgb(channels.red, channels.green, channels.blue);
    for (Vector3f& p : image.pixels()) {
        if (faults != nullptr) {
            if (!p.allFinite())
                ++faults->notFinite;
            else if (p.minCoeff() < 0)
                ++faults->negative;
        }
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(p[c])) p[c] = 0;
    }
    decodeToLinear(image, spec);
    for (Vector3f& p : image.pixels())
        for (int c = 0; c < 3; ++c) p[c] = std::isfinite(p[c]) ? std::max(p[c], 0.0f) : 0.0f;
    return applyOrientation(std::move(image), reader.orientation());
}

ImageF readScalar(ImageReader& reader) {
    int channel = 0;
    for (const char* name : {"Z", "Y"}) {
        const auto has = [&](const OIIO::ImageSpec& spec) { return findChannel(spec, name) >= 0; };
        if (!reader.seekPart(has)) continue;
        channel = findChannel(reader.spec(), name);
        break;
    }
    return applyOrientation(reader.readChannel(channel), reader.orientation());
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
    info.device = deviceName(spec.get_string_attribute("Make"), spec.get_string_attribute("Model"));
    info.format.floating = spec.format.is_floating_point();
    info.format.bits = static_cast<int>(spec.format.basesize() * 8);
    info.hasDepthChannel = reader.seekPart([](const OIIO::ImageSpec& part) { return findChannel(part, "Z") >= 0; });
    if (info.hasDepthChannel && !info.format.floating) info.hasDepthChannel = false;
    return info;
}

}  // namespace

ImageRgb loadColor(const std::string& path, Notes* remarks) {
    ImageReader reader(path);
    ColorFaults faults;
    ImageRgb image = readColor(reader, &faults);
    const auto remark = remarkOn(faults, image.size(), path);
    if (remark && remarks != nullptr) remarks->push_back(*remark);
    return image;
}

ImageRgb loadColor(EmbeddedImage image) {
    ImageReader reader(std::move(image));
    return readColor(reader);
}

ImageF loadScalar(const std::string& path) {
    ImageReader reader(path);
    return readScalar(reader);
}

ImageF loadScalar(EmbeddedImage image) {
    ImageReader reader(std::move(image));
    return readScalar(reader);
}

ImageF loadCoverage(const std::string& path) {
    ImageReader reader(path);
    const auto hasBoth = [](const OIIO::ImageSpec& spec) {
        return !spec.deep && findChannel(spec, "Z") >= 0 && findChannel(spec, "A") >= 0;
    };
    if (!reader.seekPart(hasBoth)) return {};
    return applyOrientation(reader.readChannel(findChannel(reader.spec(), "A")), reader.orientation());
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

LabelImage loadLabels(const std::string& path, Notes* remarks, MaskEdges edges) {
    ImageReader reader(path, ImageReader::Palette::Indices);
    if (reader.format() == "jpeg")
        reader.fail(Message(
            "messages", "it is a JPEG picture, whose compression changes label numbers; expected PNG, TIFF or EXR"));
    ImageF values = reader.readChannel(0);
    if (reader.spec().nchannels >= 3) {
        for (int channel = 1; channel < 3; ++channel)
            if (reader.readChannel(channel) != values)
                reader.fail(
                    Message("messages", "it is a colour picture, expected one number per pixel (grey or palette)"));
    }
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
