// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <vector>

#include "core/base/color.h"
#include "core/base/files.h"
#include "core/io/image_io.h"
#include "core/io/image_writer.h"

namespace core {

namespace {

enum class Format { Exr, Png, Tiff, Jpeg, Hdr };

const char* pluginName(Format format) {
    switch (format) {
        case Format::Exr:
            return "openexr";
        case Format::Png:
            return "png";
        case Format::Tiff:
            return "tiff";
        case Format::Jpeg:
            return "jpeg";
        case Format::Hdr:
            return "hdr";
    }
    return "";
}

std::string extensionOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

Format formatOf(const std::string& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".exr") return Format::Exr;
    if (extension == ".png") return Format::Png;
    if (extension == ".tif" || extension == ".tiff") return Format::Tiff;
    if (extension == ".jpg" || extension == ".jpeg") return Format::Jpeg;
    if (extension == ".hdr") return Format::Hdr;
    throw Error(ErrorKind::Usage,
                Message("messages",
                        "Cannot write \"%1\": the file name ends in \"%2\", expected .exr, .png, .tif, .jpg or .hdr.")
                    .with(path, extension));
}

[[noreturn]] void refuse(const std::string& path, const Message& content, const Message& expected) {
    throw Error(ErrorKind::Usage,
                Message("messages", "Cannot write \"%1\": %2 cannot be stored in a %3 file, expected %4.")
                    .with(path, content, extensionOf(path), expected));
}

OIIO::ImageSpec makeSpec(int width, int height, int channels, const OIIO::TypeDesc& type, Format format) {
    OIIO::ImageSpec spec(width, height, channels, type);
    if (format == Format::Exr || format == Format::Tiff) spec["compression"] = "zip";
    if (format == Format::Jpeg) spec["Compression"] = "jpeg:95";
    spec["Software"] = "Patina " PATINA_VERSION;
    return spec;
}

void write(const std::string& path, Format format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
           const void* pixels) {
    writeImage(path, pluginName(format), spec, type, pixels);
}

std::vector<std::uint16_t> quantize(std::span<const float> values, float scale, float offset) {
    std::vector<std::uint16_t> result(values.size());
    std::ranges::transform(values, result.begin(), [&](float v) {
        const float scaled = v * scale + offset;
        return std::isfinite(scaled) ? static_cast<std::uint16_t>(std::lround(std::clamp(scaled, 0.0f, 65535.0f)))
                                     : std::uint16_t{0};
    });
    return result;
}

/// A value that does not fit would be cut, and nobody would notice.
void requireSixteenBits(const ImageF& image, float scale, const std::string& path) {
    constexpr float kLargest = 65535.5f;
    float largest = 0;
    for (const float value : image.pixels())
        if (std::isfinite(value)) largest = std::max(largest, value);
    if (largest * scale < kLargest) return;
    throw Error(
        ErrorKind::Usage,
        Message("messages",
                "Cannot write \"%1\": a PNG holds measurements up to %2 here, and the largest is %3. Expected .exr or "
                ".tif.")
            .with(path, 65535.0f / scale, largest));
}

std::span<const float> components(const ImageRgb& image) {
    static_assert(sizeof(Vector3f) == 3 * sizeof(float));
    return {image.empty() ? nullptr : image.data()->data(), image.size() * 3};
}

void writeLinear(const ImageRgb& image, const std::string& path, Format format) {
    OIIO::ImageSpec spec = makeSpec(image.width(), image.height(), 3, OIIO::TypeFloat, format);
    spec["oiio:ColorSpace"] = "Linear";
    write(path, format, spec, OIIO::TypeFloat, image.data());
}

/// Samples in [0, 65535] as 16 bit, or 8 bit for JPEG.
void writeIntegers(const std::vector<std::uint16_t>& samples, int width, int height, int channels,
                   const std::string& path, Format format, const char* colorSpace) {
    const bool byte = format == Format::Jpeg;
    OIIO::ImageSpec spec = makeSpec(width, height, channels, byte ? OIIO::TypeUInt8 : OIIO::TypeUInt16, format);
    spec["oiio:ColorSpace"] = colorSpace;
    write(path, format, spec, OIIO::TypeUInt16, samples.data());
}

}  // namespace

void writeImage(const std::string& path, const char* format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                const void* pixels) {
    const auto fail = [&](const Message& reason) {
        throw Error(ErrorKind::Output, Message("messages", "Cannot write \"%1\": %2.").with(path, reason));
    };
    const auto failAsReported = [&](std::string reason) {
        while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.')) reason.pop_back();
        fail(reason);
    };
    AtomicFile file(path);
    OIIO::ImageSpec stamped = spec;
    // The EXR writer would store the time of day, so that equal pictures had different bytes.
    stamped["DateTime"] = "";
    std::vector<unsigned char> bytes;
    // Outlives the output, whose destructor still asks for its position.
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) fail(Message("messages", "this build of OpenImageIO does not write %1 files").with(format));
    // Into memory first, because on a full disk the PNG writer reports nothing and the JPEG writer ends the program.
    // TIFF reports its errors, and OpenImageIO 2.4 writes damaged TIFF files to memory.
    const bool inMemory =
        std::string_view(format) != "tiff" && output->supports("ioproxy") != 0 && output->set_ioproxy(&memory);
    if (!output->open(inMemory ? path : file.temporaryPath(), stamped)) failAsReported(output->geterror());
    if (!output->write_image(type, pixels)) failAsReported(output->geterror());
    if (!output->close()) failAsReported(output->geterror());
    if (!inMemory) return file.commit();
    writeFileAtomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void requireColorExtension(const std::string& path) { (void)formatOf(path); }
void requireWritable(const std::string& path) { const AtomicFile probe(path); }

void saveColor(const ImageRgb& image, const std::string& path) {
    const Format format = formatOf(path);
    if (format == Format::Exr || format == Format::Hdr) return writeLinear(image, path, format);
    std::vector<float> encoded(image.size() * 3);
    std::ranges::transform(components(image), encoded.begin(),
                           [](float v) { return std::isfinite(v) ? srgbEncode(std::clamp(v, 0.0f, 1.0f)) : 0.0f; });
    writeIntegers(quantize(encoded, 65535.0f, 0.0f), image.width(), image.height(), 3, path, format, "sRGB");
}

void saveScalar(const ImageF& image, const std::string& path, const std::string& channel, float pngScale) {
    const Format format = formatOf(path);
    if (format == Format::Jpeg)
        refuse(path, Message("messages", "measurements"), Message("messages", ".exr, .tif, .hdr or .png"));
    if (format == Format::Png) {
        requireSixteenBits(image, pngScale, path);
        writeIntegers(quantize(image.pixels(), pngScale, 0.0f), image.width(), image.height(), 1, path, format,
                      "Linear");
        return;
    }
    if (format == Format::Hdr) {
        ImageRgb grey(image.width(), image.height());
        for (std::size_t i = 0; i < image.size(); ++i) grey[i] = Vector3f::Constant(image[i]);
        return writeLinear(grey, path, format);
    }
    OIIO::ImageSpec spec = makeSpec(image.width(), image.height(), 1, OIIO::TypeFloat, format);
    spec.channelnames = {channel};
    if (channel == "Z") spec.z_channel = 0;
    write(path, format, spec, OIIO::TypeFloat, image.data());
}

void saveVectors(const ImageV3& image, const std::string& path) {
    const Format format = formatOf(path);
    if (format == Format::Hdr)
        refuse(path, Message("messages", "negative numbers"), Message("messages", ".exr, .tif, .png or .jpg"));
    if (format == Format::Exr || format == Format::Tiff) return writeLinear(image, path, format);
    writeIntegers(quantize(components(image), 0.5f * 65535.0f, 0.5f * 65535.0f), image.width(), image.height(), 3, path,
                  format, "Linear");
}

void savePositions(const ImageV3& image, const std::string& path) {
    const Format format = formatOf(path);
    if (format != Format::Exr && format != Format::Tiff)
        refuse(path, Message("messages", "positions in metres"), Message("messages", ".exr or .tif"));
    writeLinear(image, path, format);
}

void saveLabels(const LabelImage& image, const std::string& path) {
    const Format format = formatOf(path);
    if (format == Format::Jpeg || format == Format::Hdr)
        refuse(path, Message("messages", "labels"), Message("messages", ".png, .tif or .exr"));
    const std::vector<std::uint32_t> labels(image.pixels().begin(), image.pixels().end());
    const bool small = std::ranges::all_of(labels, [](std::uint32_t label) { return label < 256; });
    if (format == Format::Exr) {
        OIIO::ImageSpec spec = makeSpec(image.width(), image.height(), 1, OIIO::TypeUInt32, format);
        spec.channelnames = {"label"};
        write(path, format, spec, OIIO::TypeUInt32, labels.data());
    } else if (small) {
        const std::vector<std::uint8_t> bytes(labels.begin(), labels.end());
        write(path, format, makeSpec(image.width(), image.height(), 1, OIIO::TypeUInt8, format), OIIO::TypeUInt8,
              bytes.data());
    } else {
        write(path, format, makeSpec(image.width(), image.height(), 1, OIIO::TypeUInt16, format), OIIO::TypeUInt16,
              image.data());
    }
}

void saveDirectionalMap(const DirectionalMap& map, const std::string& path) {
    if (formatOf(path) != Format::Exr) return saveColor(map.radiance, path);
    const bool covered = map.coverage.sameSize(map.radiance);
    OIIO::ImageSpec spec =
        makeSpec(map.radiance.width(), map.radiance.height(), covered ? 4 : 3, OIIO::TypeFloat, Format::Exr);
    spec.channelnames = {"R", "G", "B"};
    spec.alpha_channel = -1;
    if (covered) spec.channelnames.emplace_back("coverage");
    spec["textureformat"] = "LatLong Environment";
    spec["oiio:ColorSpace"] = "Linear";
    std::vector<float> pixels;
    pixels.reserve(map.radiance.size() * 4);
    for (std::size_t i = 0; i < map.radiance.size(); ++i) {
        for (int c = 0; c < 3; ++c) pixels.push_back(map.radiance[i][c]);
        if (covered) pixels.push_back(map.coverage[i]);
    }
    write(path, Format::Exr, spec, OIIO::TypeFloat, pixels.data());
}

}  // namespace core
