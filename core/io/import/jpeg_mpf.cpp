// SPDX-License-Identifier: GPL-3.0-or-later
// Several pictures in one JPEG file (CIPA DC-007, Multi-Picture Format): the second is the depth of an Apple camera.
#include <cstdint>

#include "core/io/image_io.h"
#include "core/io/import/apple_depth.h"
#include "core/io/import/import_format.h"
#include "core/io/import/jpeg_segments.h"
#include "core/io/orientation.h"
#include "core/io/tiff_bytes.h"

namespace core {

namespace {

constexpr std::string_view kMpf("MPF\0", 4);
constexpr std::uint64_t kMaxPictures = 64;
constexpr std::uint64_t kEntryTag = 0xb002;
constexpr std::uint64_t kEntryBytes = 16;

struct Place {
    std::uint64_t offset = 0;  ///< from the start of the index
    std::uint64_t size = 0;
};

/// Places of the pictures after the first, from the picture index, a TIFF structure; empty if it is damaged.
std::vector<Place> readPictureIndex(const TiffBytes& index) {
    const auto entry = index.findEntry(index.integer(4, 4), kEntryTag);
    const auto bytes = entry ? index.integer(*entry + 4, 4) : std::nullopt;
    const auto table = entry ? index.integer(*entry + 8, 4) : std::nullopt;
    if (!bytes || !table || *bytes / kEntryBytes > kMaxPictures) return {};
    std::vector<Place> places;
    for (std::uint64_t i = 1; i < *bytes / kEntryBytes; ++i) {
        const auto size = index.integer(*table + i * kEntryBytes + 4, 4);
        const auto offset = index.integer(*table + i * kEntryBytes + 8, 4);
        if (!size || !offset) return {};
        places.push_back({*offset, *size});
    }
    return places;
}

/// Pictures after the first, as the index places them; those that lie outside the file are empty.
std::vector<std::string_view> secondaryPictures(std::string_view stream) {
    std::vector<std::string_view> pictures;
    for (const JpegSegment& segment : jpegSegments(stream)) {
        if (segment.marker != 0xe2 || !segment.payload.starts_with(kMpf)) continue;
        const std::size_t base = segment.offset + kMpf.size();
        for (const auto& [offset, size] : readPictureIndex(TiffBytes(segment.payload.substr(kMpf.size())))) {
            const bool inside = offset <= stream.size() - base && size <= stream.size() - base - offset;
            pictures.push_back(inside ? stream.substr(base + offset, size) : std::string_view());
        }
        break;
    }
    return pictures;
}

bool recognisesMpf(const ImportFile& file) {
    return file.head().starts_with("\xff\xd8\xff") && !secondaryPictures(file.bytes()).empty();
}

ImportedPhoto readMpf(const ImportFile& file) {
    const ImageInfo info = readImageInfo(file.path());
    ImportedPhoto photo;
    photo.orientation = info.orientation;
    photo.focal35mm = info.focal35mm;
    photo.color = loadColor(file.path());
    bool outside = false;
    for (const std::string_view picture : secondaryPictures(file.bytes())) {
        outside = outside || picture.empty();
        const auto apple = readAppleDepth(file, readJpegXmp(picture));
        if (!apple) continue;
        const EmbeddedImage image{
            std::string(picture),
            Message("messages", "%1 inside \"%2\"").with(Message("messages", "the depth map"), file.path())};
        const int own = readImageInfo(image).orientation;
        setAppleDepth(photo, file, *apple, applyOrientation(loadScalar(image), own == 1 ? info.orientation : 1),
                      info.orientation);
        return photo;
    }
    if (outside)
        file.fail(Message("messages", "the file is truncated: a picture of its index (MPF) lies beyond the end"));
    return photo;
}

}  // namespace

const ImportFormat jpegMpfFormat{MESSAGE_TEXT("messages", "the depth of an Apple camera in a JPEG (MPF)"),
                                 recognisesMpf, readMpf};

}  // namespace core
