// SPDX-License-Identifier: GPL-3.0-or-later
// Several pictures in one JPEG file (CIPA DC-007, Multi-Picture Format): one of the further ones is the depth of an
// Apple camera.
#include <algorithm>
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

/// The pictures after the first.
struct FurtherPictures {
    std::vector<std::string_view> indexed;  ///< where the index places them
    std::vector<std::string_view> behind;   ///< as they follow the end of the first
    /// Number of places in the index that hold no picture.
    std::size_t missed = 0;
};

FurtherPictures furtherPictures(std::string_view stream) {
    FurtherPictures pictures;
    for (const JpegSegment& segment : jpegSegments(stream)) {
        if (segment.marker != 0xe2 || !segment.payload.starts_with(kMpf)) continue;
        const std::size_t base = segment.offset + kMpf.size();
        for (const auto& [offset, size] : readPictureIndex(TiffBytes(segment.payload.substr(kMpf.size())))) {
            const bool inside = offset <= stream.size() - base && size <= stream.size() - base - offset;
            const std::string_view picture = inside ? stream.substr(base + offset, size) : std::string_view();
            if (picture.starts_with("\xff\xd8\xff"))
                pictures.indexed.push_back(picture);
            else
                ++pictures.missed;
        }
        break;
    }
    pictures.behind = jpegPicturesBehind(stream);
    return pictures;
}

bool recognisesMpf(const ImportFile& file) {
    if (!file.head().starts_with("\xff\xd8\xff")) return false;
    const FurtherPictures pictures = furtherPictures(file.bytes());
    return !pictures.indexed.empty() || pictures.missed > 0 ||
           std::ranges::any_of(pictures.behind,
                               [&](std::string_view picture) { return isAppleDepth(readJpegXmp(picture)); });
}

/// Takes the depth from `picture`; false when it is another picture.
bool takeDepth(ImportedPhoto& photo, const ImportFile& file, std::string_view picture) {
    const auto apple = readAppleDepth(file, readJpegXmp(picture));
    if (!apple) return false;
    const EmbeddedImage image{
        std::string(picture),
        Message("messages", "%1 inside \"%2\"").with(Message("messages", "the depth map"), file.path())};
    const int own = readImageInfo(image).orientation;
    setAppleDepth(photo, file, *apple, applyOrientation(loadScalar(image), own == 1 ? photo.orientation : 1),
                  photo.orientation);
    return true;
}

ImportedPhoto readMpf(const ImportFile& file) {
    const ImageInfo info = readImageInfo(file.path());
    ImportedPhoto photo;
    photo.orientation = info.orientation;
    photo.focal35mm = info.focal35mm;
    photo.color = loadColor(file.path());
    const FurtherPictures pictures = furtherPictures(file.bytes());
    const bool cut = pictures.behind.empty() ? !jpegPictureEnd(file.bytes()) : !jpegPictureEnd(pictures.behind.back());
    if (cut && pictures.missed > 0)
        file.fail(Message("messages", "the file is truncated: a picture of its index (MPF) lies beyond the end"));
    for (const std::string_view picture : pictures.indexed)
        if (takeDepth(photo, file, picture)) return photo;
    // Programs that change the metadata move the index, and leave the offsets in it as they were.
    for (const std::string_view picture : pictures.behind)
        if (takeDepth(photo, file, picture)) return photo;
    if (pictures.missed > 0 && pictures.behind.size() < pictures.indexed.size() + pictures.missed)
        photo.remarks.push_back(
            Message("messages",
                    "The index (MPF) of \"%1\" names a further picture that is not in the file: another program "
                    "dropped it when it saved the photograph, and the depth with it if that was there. Take the "
                    "original file, or give a depth map.")
                .with(file.path()));
    return photo;
}

}  // namespace

const ImportFormat jpegMpfFormat{MESSAGE_TEXT("messages", "the depth of an Apple camera in a JPEG (MPF)"),
                                 recognisesMpf, readMpf};

}  // namespace core
