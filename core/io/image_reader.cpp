// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image_reader.h"

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <locale>
#include <span>
#include <sstream>

#include "core/base/files.h"
#include "core/io/deep_exr.h"
#include "core/io/tiff_bytes.h"
#include "core/io/truncation.h"

namespace core {

namespace {

/// Compressed formats reach about 1000:1 on constant pictures; a header that claims far more is a lie, and believing
/// it would cost gigabytes.
constexpr std::size_t kMaxCompression = 5000;
constexpr std::size_t kAlwaysAcceptedBytes = std::size_t{16} << 20U;
constexpr std::size_t kMaxFileSize = std::size_t{8} << 30U;
constexpr int kMaxChannels = 1024;
constexpr int kMaxParts = 64;
constexpr std::size_t kMagicBytes = 12;

/// The first bytes of a file; fewer when it is shorter.
std::string readHead(const std::string& path, std::size_t count) {
    std::string head(count, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(count));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

std::string formatFromContent(std::string_view bytes) {
    const std::string_view magic = bytes.substr(0, kMagicBytes);
    const auto starts = [&](std::string_view prefix) { return magic.substr(0, prefix.size()) == prefix; };
    if (starts("\x76\x2f\x31\x01")) return "openexr";
    if (starts("\x89PNG\r\n\x1a\n")) return "png";
    if (starts("\xff\xd8\xff")) return "jpeg";
    if (starts(std::string_view("II*\0", 4)) || starts(std::string_view("MM\0*", 4))) return "tiff";
    if (starts(std::string_view("II+\0", 4)) || starts(std::string_view("MM\0+", 4))) return "tiff";
    if (starts("#?RADIANCE") || starts("#?RGBE")) return "hdr";
    if (magic.size() > 2 && magic[0] == 'P' && std::string_view("123456Ff").find(magic[1]) != std::string_view::npos &&
        std::string_view(" \t\r\n").find(magic[2]) != std::string_view::npos)
        return "pnm";
    return {};
}

/// A library's report, trimmed to end a sentence.
Message libraryReason(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' ')) text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text;
}

std::string imageSizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

std::uint32_t bigEndian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Checksum of a PNG chunk (PNG specification, annex D).
std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xedb88320U : crc >> 1U;
    }
    return ~crc;
}

void appendBigEndian(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<char>(value >> static_cast<unsigned>(shift)));
}

}  // namespace

bool indexedPngToGrey(std::string& bytes) {
    constexpr std::size_t kSignature = 8;
    constexpr std::size_t kHeaderEnd = kSignature + 25;
    if (bytes.size() < kHeaderEnd || bytes.compare(kSignature + 4, 4, "IHDR") != 0) return false;
    if (bytes[kSignature + 17] != 3) return false;
    std::string grey = bytes.substr(0, kHeaderEnd - 4);
    grey[kSignature + 17] = 0;
    appendBigEndian(grey, crc32(std::string_view(grey).substr(kSignature + 4)));
    for (std::size_t at = kHeaderEnd; at + 12 <= bytes.size();) {
        const std::size_t length = std::size_t{bigEndian(bytes, at)} + 12;
        if (length > bytes.size() - at) {
            grey.append(bytes, at);  // truncated: libpng will report it
            break;
        }
        const std::string_view type(bytes.data() + at + 4, 4);
        if (type == "IDAT" || type == "IEND") grey.append(bytes, at, length);
        at += length;
    }
    bytes = std::move(grey);
    return true;
}

bool indexedTiffToGrey(std::string& bytes) {
    constexpr std::uint64_t kPhotometricInterpretation = 262;
    constexpr std::uint64_t kMinIsWhite = 0, kMinIsBlack = 1, kPalette = 3;
    const TiffBytes tiff(bytes);
    if (tiff.integer(2, 2) != 42) return false;  // BigTIFF has 43
    const auto entry = tiff.findEntry(tiff.integer(4, 4), kPhotometricInterpretation);
    const auto meaning = entry ? tiff.integer(*entry + 8, 2) : std::nullopt;
    if (meaning != kPalette && meaning != kMinIsWhite) return false;
    const bool bigEndian = bytes.starts_with("MM");
    bytes[*entry + 8] = static_cast<char>(bigEndian ? 0 : kMinIsBlack);
    bytes[*entry + 9] = static_cast<char>(bigEndian ? kMinIsBlack : 0);
    return true;
}

namespace {

/// Product of the EXPOSURE lines of a Radiance picture, by which its pixels have been multiplied (Ward, "The RADIANCE
/// picture file format"); 1 when there is none or it is no positive number.
float radianceExposure(std::string_view head) {
    constexpr std::string_view kKey = "EXPOSURE=";
    double product = 1;
    for (std::size_t at = 0; at < head.size();) {
        const std::size_t end = std::min(head.find('\n', at), head.size());
        const std::string_view line = head.substr(at, end - at);
        if (line.empty()) break;
        if (line.starts_with(kKey)) product *= std::strtod(std::string(line.substr(kKey.size())).c_str(), nullptr);
        at = end + 1;
    }
    const auto factor = static_cast<float>(product);
    return std::isfinite(factor) && factor > 0 ? factor : 1.0f;
}

/// Magnitude of the scale in a PFM header: "Pf", width, height, scale.
float pfmScale(std::string_view head) {
    if (!head.starts_with("PF") && !head.starts_with("Pf")) return 1;
    std::istringstream text{std::string(head.substr(2))};
    text.imbue(std::locale::classic());
    long width = 0;
    long height = 0;
    float scale = 1;
    if (!(text >> width >> height >> scale)) return 1;
    scale = std::abs(scale);
    return std::isfinite(scale) && scale > 0 ? scale : 1.0f;
}

}  // namespace

ImageReader::ImageReader(const std::string& path, Palette palette)
    : subject_("\"" + path + "\""), path_(path), fileSize_(checkedFileSize(path)) {
    if (fileSize_ > kMaxFileSize)
        fail(Message("messages", "it has %1 bytes, more than Patina accepts").with(fileSize_));
    format_ = formatFromContent(readHead(path, kMagicBytes));
    open(path, palette);
}

ImageReader::ImageReader(EmbeddedImage image)
    : subject_(std::move(image.subject)), fileSize_(image.bytes.size()), memory_(std::move(image.bytes)) {
    format_ = formatFromContent(memory_);
    open("embedded", Palette::Colors);
}

std::string ImageReader::readAll() const { return path_.empty() ? memory_ : readFile(path_, kMaxFileSize); }

void ImageReader::open(const std::string& name, Palette palette) {
    if (format_.empty())
        fail(Message("messages",
                     "its content is no image format that Patina reads (expected EXR, PNG, TIFF, JPEG, PFM or HDR)"));
    if (format_ == "jpeg" && !jpegIsComplete(readAll()))
        fail(Message("messages", "the file is truncated (JPEG data without an end)"));
    if (format_ == "tiff" && !tiffIsComplete(readAll()))
        fail(Message("messages", "the file is truncated (TIFF data beyond its end)"));
    input_ = OIIO::ImageInput::create(format_, false);
    if (!input_) fail(Message("messages", "this build of OpenImageIO does not read %1 files").with(format_));
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1;
    if (palette == Palette::Indices && format_ == "png") {
        std::string bytes = readAll();
        if (indexedPngToGrey(bytes)) memory_ = std::move(bytes);
    }
    if (palette == Palette::Indices && format_ == "tiff") {
        std::string bytes = readAll();
        if (indexedTiffToGrey(bytes)) memory_ = std::move(bytes);
    }
    if (!memory_.empty()) {
        proxy_ = std::make_unique<OIIO::Filesystem::IOMemReader>(memory_.data(), memory_.size());
        if (!input_->set_ioproxy(proxy_.get()))
            fail(Message("messages", "this build of OpenImageIO does not read %1 files from memory").with(format_));
    }
    if (!input_->open(name, spec_, config)) fail(libraryReason(input_->geterror()));
    checkHeader();
    readHeaderFactor();
    if (format_ == "png" && pngBits() < 8) spec_["oiio:BitsPerSample"] = pngBits();
}

void ImageReader::readHeaderFactor() {
    constexpr std::size_t kHeaderBytes = 4096;
    if (format_ != "pnm" && format_ != "hdr") return;
    const std::string head = path_.empty() ? memory_.substr(0, kHeaderBytes) : readHead(path_, kHeaderBytes);
    headerFactor_ = format_ == "pnm" ? pfmScale(head) : radianceExposure(head);
}

bool isImageFile(const std::string& path) {
    (void)checkedFileSize(path);
    return !formatFromContent(readHead(path, kMagicBytes)).empty();
}

/// Bits per sample, because OpenImageIO expands PNG rows of 1, 2 or 4 bits to 8 without reporting it.
int ImageReader::pngBits() const {
    constexpr std::size_t kBitDepth = 24;
    const std::string head = path_.empty() ? memory_.substr(0, kBitDepth + 1) : readHead(path_, kBitDepth + 1);
    return head.size() > kBitDepth ? head[kBitDepth] : 0;
}

ImageReader::~ImageReader() {
    if (input_) input_->close();
}

void ImageReader::fail(const Message& reason) const {
    throw Error(ErrorKind::Input, Message("messages", "Cannot read %1: %2.").with(subject_, reason));
}

void ImageReader::checkHeader() const {
    const auto checkSize = [&](int width, int height) {
        if (width <= 0 || height <= 0)
            fail(Message("messages", "the image size is %1").with(imageSizeText(width, height)));
        if (width > kMaxImageSide || height > kMaxImageSide ||
            static_cast<long>(width) * static_cast<long>(height) > kMaxImagePixels)
            fail(Message("messages", "the image size is %1, expected at most %2 pixels a side and %3 megapixels")
                     .with(imageSizeText(width, height), kMaxImageSide, kMaxImagePixels / 1'000'000));
    };
    checkSize(spec_.width, spec_.height);
    checkSize(spec_.full_width, spec_.full_height);
    if (spec_.depth > 1)
        fail(Message("messages", "it is a volume of depth %1, expected a flat image").with(spec_.depth));
    if (spec_.deep && path_.empty())
        fail(Message("messages", "it is a deep image (several samples per pixel), expected a flat one"));
    if (spec_.nchannels < 1 || spec_.nchannels > kMaxChannels)
        fail(Message("messages", "it has %1 channels, expected 1 to %2").with(spec_.nchannels, kMaxChannels));
    const auto bytes = static_cast<std::size_t>(spec_.image_bytes(true));
    if (bytes > kAlwaysAcceptedBytes && bytes / kMaxCompression > fileSize_)
        fail(Message("messages", "the header claims %1 pixels, but the file has only %2 bytes")
                 .with(imageSizeText(spec_.width, spec_.height), fileSize_));
}

int ImageReader::orientation() const {
    const int value = spec_.get_int_attribute("Orientation", 1);
    return value >= 1 && value <= 8 ? value : 1;
}

std::vector<OIIO::ImageSpec> ImageReader::parts() {
    std::vector<OIIO::ImageSpec> specs;
    for (int part = 0; part < kMaxParts && input_->seek_subimage(part, 0); ++part) specs.push_back(input_->spec());
    (void)input_->geterror();
    goToPart(0);
    return specs;
}

void ImageReader::goToPart(int part) {
    if (!input_->seek_subimage(part, 0)) fail(libraryReason(input_->geterror()));
    spec_ = input_->spec();
    checkHeader();
}

float ImageReader::integerScale() const {
    if (spec_.format.is_floating_point()) return 1.0f;
    const int typeBits = static_cast<int>(spec_.format.basesize() * 8);
    const int bits = std::clamp(spec_.get_int_attribute("oiio:BitsPerSample", typeBits), 1, typeBits);
    const bool isSigned = spec_.format == OIIO::TypeDesc::INT8 || spec_.format == OIIO::TypeDesc::INT16 ||
                          spec_.format == OIIO::TypeDesc::INT32;
    return static_cast<float>(std::exp2(isSigned ? bits - 1 : bits) - 1.0);
}

bool ImageReader::dataFillsDisplay() const {
    return spec_.x == spec_.full_x && spec_.y == spec_.full_y && spec_.width == spec_.full_width &&
           spec_.height == spec_.full_height;
}

void ImageReader::readRegion(int channelBegin, int channelEnd, float* target) {
    if (spec_.deep) {
        try {
            const std::vector<std::string> names(spec_.channelnames.begin() + channelBegin,
                                                 spec_.channelnames.begin() + channelEnd);
            std::ranges::copy(flattenDeepExr(path_, input_->current_subimage(), names), target);
        } catch (const Error& error) {
            fail(error.message());
        } catch (const std::exception& error) {
            fail(libraryReason(error.what()));
        }
        return;
    }
    if (!input_->read_image(input_->current_subimage(), 0, channelBegin, channelEnd, OIIO::TypeFloat, target))
        fail(libraryReason(input_->geterror()));
    if (headerFactor_ == 1) return;
    const auto count = static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(spec_.height) *
                       static_cast<std::size_t>(channelEnd - channelBegin);
    for (float& value : std::span(target, count)) value /= headerFactor_;
}

ImageF ImageReader::readChannel(int channel) {
    ImageF data(spec_.width, spec_.height);
    readRegion(channel, channel + 1, data.data());
    if (const float scale = integerScale(); scale != 1.0f)
        for (float& value : data.pixels()) value = std::round(value * scale);
    if (dataFillsDisplay()) return data;
    ImageF display(width(), height(), 0.0f);
    for (int y = 0; y < spec_.height; ++y)
        for (int x = 0; x < spec_.width; ++x) {
            const int u = x + spec_.x - spec_.full_x;
            const int v = y + spec_.y - spec_.full_y;
            if (display.contains(u, v)) display(u, v) = data(x, y);
        }
    return display;
}

ImageRgb ImageReader::readRgb(int red, int green, int blue) {
    ImageRgb data(spec_.width, spec_.height, Vector3f(0, 0, 0));
    static_assert(sizeof(Vector3f) == 3 * sizeof(float));
    if (green == red + 1 && blue == red + 2) {
        readRegion(red, red + 3, data.data()->data());
    } else {
        ImageF plane(spec_.width, spec_.height);
        const std::array<int, 3> channels{red, green, blue};
        for (std::size_t c = 0; c < 3; ++c) {
            if (c == 0 || channels[c] != channels[c - 1]) readRegion(channels[c], channels[c] + 1, plane.data());
            for (std::size_t i = 0; i < data.size(); ++i) data[i][static_cast<int>(c)] = plane[i];
        }
    }
    if (dataFillsDisplay()) return data;
    ImageRgb display(width(), height(), Vector3f(0, 0, 0));
    for (int y = 0; y < spec_.height; ++y)
        for (int x = 0; x < spec_.width; ++x) {
            const int u = x + spec_.x - spec_.full_x;
            const int v = y + spec_.y - spec_.full_y;
            if (display.contains(u, v)) display(u, v) = data(x, y);
        }
    return display;
}

}  // namespace core
