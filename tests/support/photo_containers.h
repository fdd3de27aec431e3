// SPDX-License-Identifier: GPL-3.0-or-later
// Photographs with embedded depth, assembled byte by byte without the code under test.
#pragma once

#include <libheif/heif.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/image_files.h"

namespace test {

inline std::string base64(const std::string& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= bytes.size() - i ? digits[bits >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

inline std::string bigEndian16(std::size_t value) { return {static_cast<char>(value >> 8U), static_cast<char>(value)}; }

inline std::string jpegSegment(unsigned marker, const std::string& payload) {
    return std::string("\xff") + static_cast<char>(marker) + bigEndian16(payload.size() + 2) + payload;
}

/// A grey or colour JPEG of one value, as OpenImageIO writes it.
inline std::string plainJpeg(const TempFolder& folder, int width, int height, int channels,
                             const std::vector<std::uint8_t>& pixels) {
    const std::string path = folder / "plain.jpg";
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeUInt8);
    spec["Compression"] = "jpeg:100";
    writeWith("jpeg", path, spec, OIIO::TypeUInt8, pixels.data());
    return readBytes(path);
}

/// The JPEG with further segments right after its start.
inline std::string withSegments(const std::string& jpeg, const std::string& segments) {
    return jpeg.substr(0, 2) + segments + jpeg.substr(2);
}

/// EXIF with an orientation and nothing else.
inline std::string exifSegment(int orientation) {
    return jpegSegment(0xe1, std::string("Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01", 24) +
                                 bigEndian16(static_cast<std::size_t>(orientation)) + std::string(6, '\0'));
}

inline std::string xmpText(const std::string& namespaces, const std::string& attributes,
                           const std::string& elements = {}) {
    return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
           "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description rdf:about=\"\" " +
           namespaces + " " + attributes + ">" + elements + "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

inline std::string xmpSegment(const std::string& text) {
    return jpegSegment(0xe1, std::string("http://ns.adobe.com/xap/1.0/\0", 29) + text);
}

inline const std::string kGuid = "0123456789ABCDEF0123456789ABCDEF";

/// One part of an extended packet; `claimed` is the size of the whole.
inline std::string extendedXmpSegment(const std::string& part, std::size_t offset, std::size_t claimed,
                                      const std::string& guid = kGuid) {
    return jpegSegment(0xe1, std::string("http://ns.adobe.com/xmp/extension/\0", 35) + guid +
                                 bigEndian32(static_cast<std::uint32_t>(claimed)) +
                                 bigEndian32(static_cast<std::uint32_t>(offset)) + part);
}

/// An extended packet cut into parts of `size` bytes, the last part first.
inline std::string extendedXmp(const std::string& text, std::size_t size) {
    std::string segments;
    for (std::size_t begin = 0; begin < text.size(); begin += size)
        segments = extendedXmpSegment(text.substr(begin, size), begin, text.size()) + segments;
    return segments;
}

/// Apple's description of a disparity image; `range` as in apdi:FloatMinValue.
inline std::string appleXmp(const std::string& least, const std::string& most, int width, int height,
                            const std::vector<double>& intrinsics, const std::string& type = "disparity") {
    std::string matrix;
    for (const double value : intrinsics) matrix += "<rdf:li>" + std::to_string(value) + "</rdf:li>";
    const auto element = [](const std::string& name, const std::string& value) {
        return "<" + name + ">" + value + "</" + name + ">";
    };
    return xmpText(
        "xmlns:depthData=\"http://ns.apple.com/depthData/1.0/\" "
        "xmlns:apdi=\"http://ns.apple.com/pixeldatainfo/1.0/\"",
        "",
        element("apdi:AuxiliaryImageType", type) + element("apdi:FloatMinValue", least) +
            element("apdi:FloatMaxValue", most) + element("apdi:IntMinValue", "0") +
            element("apdi:IntMaxValue", "255") +
            element("depthData:IntrinsicMatrixReferenceWidth", std::to_string(width)) +
            element("depthData:IntrinsicMatrixReferenceHeight", std::to_string(height)) +
            element("depthData:Accuracy", "relative") +
            element("depthData:IntrinsicMatrix", element("rdf:Seq", matrix)));
}

/// The MPF segment of a file with two pictures; the second lies `offset` bytes behind the segment's TIFF start.
inline std::string mpfSegment(std::uint32_t offset, std::uint32_t size) {
    std::string index("MM\0*\0\0\0\x08\0\x02", 10);
    index += std::string("\xb0\x01\0\x04\0\0\0\x01\0\0\0\x02", 12);
    index += std::string("\xb0\x02\0\x07\0\0\0\x20\0\0\0\x26", 12) + bigEndian32(0);
    index += bigEndian32(0x30000) + std::string(12, '\0');
    index += bigEndian32(0) + bigEndian32(size) + bigEndian32(offset) + std::string(4, '\0');
    return jpegSegment(0xe2, std::string("MPF\0", 4) + index);
}

/// `front` (a JPEG), a gap, and `second`, which the MPF index points to; `segments` come first.
inline std::string mpfFile(const std::string& front, const std::string& segments, const std::string& second) {
    const std::size_t gap = 50;
    const std::size_t index = 2 + segments.size() + 4 + 4;  // where the segment's TIFF structure starts
    const std::size_t mpfBytes = mpfSegment(0, 0).size();
    const std::size_t at = front.size() + segments.size() + mpfBytes + gap;
    const std::string mpf =
        mpfSegment(static_cast<std::uint32_t>(at - index), static_cast<std::uint32_t>(second.size()));
    return withSegments(front, segments + mpf) + std::string(gap, '\0') + second;
}

/// A picture behind the photograph of a Dynamic Depth file, as its XMP lists it.
struct DynamicItem {
    std::string uri;
    std::string length;
    std::string padding = "0";
};

/// XMP of Dynamic Depth 1.0. `plain` writes items and cameras as attributes and elements of rdf:li itself.
inline std::string dynamicDepthXmp(const std::vector<DynamicItem>& items, const std::string& depth,
                                   const std::string& elements = {}, bool plain = false) {
    const auto listed = [plain](const std::string& name, const std::string& attributes, const std::string& content) {
        if (plain) return "<rdf:li " + attributes + ">" + content + "</rdf:li>";
        return "<rdf:li rdf:parseType=\"Resource\"><" + name + " " + attributes + ">" + content + "</" + name +
               "></rdf:li>";
    };
    std::string directory = listed("Container:Item", "Item:Length=\"0\" Item:DataURI=\"primary\"", "");
    for (const DynamicItem& item : items)
        directory += listed("Container:Item",
                            "Item:Length=\"" + item.length + "\" Item:Padding=\"" + item.padding +
                                "\" Item:DataURI=\"" + item.uri + "\"",
                            "");
    std::string namespaces;
    for (const char* name : {"Device", "Container", "Item", "Camera", "DepthMap", "Image", "ImagingModel"}) {
        std::string lower = name;
        std::ranges::transform(lower, lower.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        namespaces += "xmlns:" + std::string(name) + "=\"http://ns.google.com/photos/dd/1.0/" + lower + "/\" ";
    }
    return xmpText(namespaces, "",
                   "<Device:Container><Container:Directory><rdf:Seq>" + directory +
                       "</rdf:Seq></Container:Directory></Device:Container><Device:Cameras><rdf:Seq>" +
                       listed("Device:Camera", "", "<Camera:DepthMap " + depth + "/>" + elements) +
                       "</rdf:Seq></Device:Cameras>");
}

/// Boxes of ISO base media files.
inline std::string box(const std::string& type, const std::string& content) {
    return bigEndian32(static_cast<std::uint32_t>(content.size() + 8)) + type + content;
}

/// An encoded HEVC picture: the decoder's configuration and the data.
struct HevcPicture {
    int width = 0, height = 0;
    std::string configuration;  ///< hvcC box
    std::string data;
};

/// Encodes a picture with libheif and takes it out of the file it makes. One plane is grey, three are RGB. Sizes below
/// 64 are extended by the encoder.
inline HevcPicture encodeHevc(int width, int height, const std::vector<std::vector<std::uint8_t>>& planes) {
    const auto check = [](const heif_error& error) {
        if (error.code != heif_error_Ok) throw std::runtime_error(error.message);
    };
    const bool grey = planes.size() == 1;
    heif_image* image = nullptr;
    check(heif_image_create(width, height, grey ? heif_colorspace_monochrome : heif_colorspace_RGB,
                            grey ? heif_chroma_monochrome : heif_chroma_444, &image));
    const std::vector<heif_channel> channels =
        grey ? std::vector{heif_channel_Y} : std::vector{heif_channel_R, heif_channel_G, heif_channel_B};
    for (std::size_t c = 0; c < planes.size(); ++c) {
        check(heif_image_add_plane(image, channels[c], width, height, 8));
        int stride = 0;
        std::uint8_t* target = heif_image_get_plane(image, channels[c], &stride);
        for (int y = 0; y < height; ++y)
            std::copy_n(planes[c].begin() + static_cast<std::ptrdiff_t>(y) * width, width,
                        target + static_cast<std::ptrdiff_t>(y) * stride);
    }
    heif_context* context = heif_context_alloc();
    heif_encoder* encoder = nullptr;
    check(heif_context_get_encoder_for_format(context, heif_compression_HEVC, &encoder));
    check(heif_encoder_set_lossless(encoder, 1));
    heif_image_handle* handle = nullptr;
    check(heif_context_encode_image(context, image, encoder, nullptr, &handle));
    std::string file;
    heif_writer writer{1, [](heif_context*, const void* bytes, std::size_t size, void* target) {
                           static_cast<std::string*>(target)->assign(static_cast<const char*>(bytes), size);
                           return heif_error{heif_error_Ok, heif_suberror_Unspecified, "ok"};
                       }};
    check(heif_context_write(context, &writer, &file));
    heif_image_handle_release(handle);
    heif_encoder_release(encoder);
    heif_context_free(context);
    heif_image_release(image);

    const auto size = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(file.at(at + i));
        return std::size_t{value};
    };
    const std::size_t configuration = file.find("hvcC") - 4;
    const std::size_t data = file.find("mdat") - 4;
    return {width, height, file.substr(configuration, size(configuration)), file.substr(data + 8, size(data) - 8)};
}

/// A HEIC file: `color` is the primary picture, `gain` and `depth` are auxiliary ones, in this order, and `xmp`
/// describes the depth. Items that `auxiliaryOf` names beside the primary one (1) are, as a tone-mapped picture is for
/// programs that do not know it, of a type of their own. `turns` counter-clockwise quarter turns are applied to all
/// when they are shown. `primaries` and `transfer` are the values of the nclx box, unspecified by default.
inline std::string heicFile(const HevcPicture& color, const HevcPicture& gain, const HevcPicture& depth,
                            const std::string& xmp, int turns, std::size_t primaries = 2, std::size_t transfer = 2,
                            const std::vector<std::size_t>& auxiliaryOf = {1}) {
    const std::string none(4, '\0');  // version and flags
    const auto extent = [&](const HevcPicture& picture) {
        return box("ispe", none + bigEndian32(static_cast<std::uint32_t>(picture.width)) +
                               bigEndian32(static_cast<std::uint32_t>(picture.height)));
    };
    const auto auxiliary = [&](const std::string& type) { return box("auxC", none + type + '\0'); };
    const std::string properties = box(
        "ipco", color.configuration + extent(color) + gain.configuration + extent(gain) +
                    auxiliary("urn:com:apple:photo:2020:aux:hdrgainmap") + depth.configuration + extent(depth) +
                    auxiliary("urn:mpeg:hevc:2015:auxid:2") + box("irot", std::string(1, static_cast<char>(turns))) +
                    box("colr", "nclx" + bigEndian16(primaries) + bigEndian16(transfer) + bigEndian16(6) + '\x80'));
    std::string association = none + bigEndian32(3);
    const auto associate = [&](int item, std::vector<int> indices) {
        association += bigEndian16(static_cast<std::size_t>(item)) + static_cast<char>(indices.size());
        for (const int index : indices) association += static_cast<char>(index | 0x80);
    };
    associate(1, {1, 2, 9, 10});
    associate(2, {3, 4, 5, 9});
    associate(3, {6, 7, 8, 9});

    const auto entry = [](int item, const std::string& type, const std::string& rest) {
        return box("infe", std::string("\x02\0\0\0", 4) + bigEndian16(static_cast<std::size_t>(item)) + bigEndian16(0) +
                               type + rest);
    };
    const bool toneMapped = auxiliaryOf.size() > 1;
    const std::string items = none + bigEndian16(toneMapped ? 5 : 4) + entry(1, "hvc1", std::string(1, '\0')) +
                              entry(2, "hvc1", std::string(1, '\0')) + entry(3, "hvc1", std::string(1, '\0')) +
                              entry(4, "mime", std::string("\0application/rdf+xml\0", 21)) +
                              (toneMapped ? entry(5, "tmap", std::string(1, '\0')) : "");
    const auto refer = [](const std::string& type, std::size_t from, const std::vector<std::size_t>& targets) {
        std::string content = bigEndian16(from) + bigEndian16(targets.size());
        for (const std::size_t target : targets) content += bigEndian16(target);
        return box(type, content);
    };
    const std::string references =
        none + refer("auxl", 2, auxiliaryOf) + refer("auxl", 3, auxiliaryOf) + refer("cdsc", 4, {3});
    std::vector<std::string> payloads{color.data, gain.data, depth.data, xmp};
    if (toneMapped) payloads.emplace_back("tone map");
    const auto meta = [&](std::size_t begin) {
        std::string locations = none + std::string("\x44\0", 2) + bigEndian16(payloads.size());
        for (std::size_t i = 0; i < payloads.size(); ++i) {
            locations += bigEndian16(i + 1) + bigEndian16(0) + bigEndian16(1);
            locations += bigEndian32(static_cast<std::uint32_t>(begin)) +
                         bigEndian32(static_cast<std::uint32_t>(payloads[i].size()));
            begin += payloads[i].size();
        }
        return box("meta", none + box("hdlr", none + none + "pict" + std::string(13, '\0')) +
                               box("pitm", none + bigEndian16(1)) + box("iloc", locations) + box("iinf", items) +
                               box("iref", references) + box("iprp", properties + box("ipma", association)));
    };
    const std::string type = box("ftyp", "heic" + none + "mif1heic");
    std::string data;
    for (const std::string& payload : payloads) data += payload;
    return type + meta(type.size() + meta(0).size() + 8) + box("mdat", data);
}

}  // namespace test
