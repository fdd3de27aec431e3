// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/jpeg_segments.h"

#include <algorithm>
#include <cstdint>
#include <map>

namespace core {

namespace {

constexpr std::string_view kXmp("http://ns.adobe.com/xap/1.0/\0", 29);
constexpr std::string_view kExtendedXmp("http://ns.adobe.com/xmp/extension/\0", 35);
constexpr std::size_t kGuidBytes = 32;
constexpr std::size_t kExtendedHeader = kExtendedXmp.size() + kGuidBytes + 8;  // GUID, full length, offset

std::uint32_t bigEndian32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Parts of one extended packet.
struct Extension {
    std::uint32_t size = 0;  ///< as claimed
    bool sizesAgree = true;
    std::map<std::uint32_t, std::string_view> parts;  ///< by offset
};

/// Empty, with `damage` set, unless the parts follow each other without gap and fill the claimed size.
std::string join(const Extension& extension, Message& damage) {
    std::size_t there = 0;
    bool gap = !extension.sizesAgree;
    for (const auto& [offset, part] : extension.parts) {
        gap = gap || offset != there;
        there += part.size();
    }
    if (gap || there != extension.size) {
        damage = Message("messages", "its extended XMP is incomplete: expected %1 bytes in successive parts, found %2")
                     .with(extension.size, there);
        return {};
    }
    std::string text;
    text.reserve(there);
    for (const auto& [offset, part] : extension.parts) text += part;
    return text;
}

}  // namespace

std::vector<JpegSegment> jpegSegments(std::string_view stream, bool* complete) {
    std::vector<JpegSegment> segments;
    if (complete != nullptr) *complete = false;
    const auto byte = [&](std::size_t i) { return unsigned{static_cast<unsigned char>(stream[i])}; };
    if (!stream.starts_with("\xff\xd8\xff")) return segments;
    for (std::size_t i = 2; i + 4 <= stream.size();) {
        if (byte(i) != 0xff) return segments;
        const unsigned marker = byte(i + 1);
        if (marker == 0xff) {  // fill byte
            ++i;
            continue;
        }
        if (marker == 0xda || marker == 0xd9) {  // start of scan, end of image
            if (complete != nullptr) *complete = true;
            return segments;
        }
        const std::size_t length = byte(i + 2) << 8U | byte(i + 3);
        if (length < 2 || length > stream.size() - i - 2) return segments;
        segments.push_back({marker, i + 4, stream.substr(i + 4, length - 2)});
        i += 2 + length;
    }
    return segments;
}

std::optional<std::size_t> jpegPictureEnd(std::string_view stream) {
    const auto byte = [&](std::size_t i) { return unsigned{static_cast<unsigned char>(stream[i])}; };
    if (!stream.starts_with("\xff\xd8\xff")) return std::nullopt;
    for (std::size_t i = 2; i + 2 <= stream.size();) {
        if (byte(i) != 0xff) {  // coded data
            i = std::min(stream.find('\xff', i), stream.size());
            continue;
        }
        const unsigned marker = byte(i + 1);
        if (marker == 0xd9) return i + 2;
        if (marker == 0xff) {  // fill byte
            ++i;
        } else if (marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {  // without length
            i += 2;
        } else {
            if (i + 4 > stream.size()) break;
            i += 2 + std::max(2U, byte(i + 2) << 8U | byte(i + 3));
        }
    }
    return std::nullopt;
}

std::vector<std::string_view> jpegPicturesBehind(std::string_view stream) {
    constexpr std::size_t kMostPictures = 64;
    std::vector<std::string_view> pictures;
    auto end = jpegPictureEnd(stream);
    while (end && pictures.size() < kMostPictures) {
        const std::size_t begin = stream.find("\xff\xd8\xff", *end);
        if (begin == std::string_view::npos) break;
        const auto length = jpegPictureEnd(stream.substr(begin));
        pictures.push_back(stream.substr(begin, length.value_or(std::string_view::npos)));
        if (!length) break;
        end = begin + *length;
    }
    return pictures;
}

std::vector<std::string> jpegXmpPackets(std::string_view stream, Message* damage) {
    std::vector<std::string> packets;
    std::map<std::string_view, Extension> extensions;
    bool complete = false;
    for (const JpegSegment& segment : jpegSegments(stream, &complete)) {
        if (segment.marker != 0xe1) continue;
        if (segment.payload.starts_with(kXmp)) packets.emplace_back(segment.payload.substr(kXmp.size()));
        if (!segment.payload.starts_with(kExtendedXmp) || segment.payload.size() < kExtendedHeader) continue;
        Extension& extension = extensions[segment.payload.substr(kExtendedXmp.size(), kGuidBytes)];
        const std::uint32_t size = bigEndian32(segment.payload, kExtendedHeader - 8);
        extension.sizesAgree = extension.sizesAgree && (extension.parts.empty() || extension.size == size);
        extension.size = size;
        const auto offset = bigEndian32(segment.payload, kExtendedHeader - 4);
        if (!extension.parts.emplace(offset, segment.payload.substr(kExtendedHeader)).second)
            extension.sizesAgree = false;
    }
    Message problem;
    if (!complete) problem = Message("messages", "the file is truncated: its header segments have no end");
    for (const auto& [guid, extension] : extensions) {
        const auto refers = [&](const std::string& packet) { return packet.find(guid) != std::string::npos; };
        if (std::ranges::none_of(packets, refers)) continue;
        std::string text = join(extension, problem);
        if (!text.empty()) packets.push_back(std::move(text));
        break;
    }
    if (damage != nullptr) *damage = problem;
    return packets;
}

}  // namespace core
