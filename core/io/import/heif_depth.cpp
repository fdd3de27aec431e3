// SPDX-License-Identifier: GPL-3.0-or-later
// HEIC photographs with an auxiliary depth image (Apple portrait mode). libheif applies the file's own rotation and
// mirroring to both images; the EXIF orientation is not applied on top.
#include <libheif/heif.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/io/color_decode.h"
#include "core/io/image_io.h"
#include "core/io/import/apple_depth.h"
#include "core/io/import/heif_boxes.h"
#include "core/io/import/import_format.h"
#include "core/io/orientation.h"
#include "core/io/tiff_bytes.h"

namespace core {

namespace {

constexpr std::string_view kDepthTypes[] = {"urn:mpeg:hevc:2015:auxid:2",
                                            "urn:mpeg:mpegB:cicp:systems:auxiliary:depth"};
constexpr std::size_t kMaxMetadataBytes = std::size_t{16} << 20U;
constexpr int kMaxItems = 64;

struct Release {
    void operator()(heif_context* context) const { heif_context_free(context); }
    void operator()(heif_image_handle* handle) const { heif_image_handle_release(handle); }
    void operator()(heif_image* image) const { heif_image_release(image); }
    void operator()(heif_decoding_options* options) const { heif_decoding_options_free(options); }
    void operator()(heif_color_profile_nclx* profile) const { heif_nclx_color_profile_free(profile); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

bool recognisesHeifDepth(const ImportFile& file) {
    const std::string& head = file.head();
    if (head.size() < 12 || head.compare(4, 4, "ftyp") != 0) return false;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(head.data());
    return heif_check_filetype(bytes, static_cast<int>(head.size())) != heif_filetype_no;
}

/// The TIFF structure in an EXIF block as HEIC stores it; empty when there is none.
std::string_view tiffOf(std::string_view block) {
    const std::size_t begin = std::min(block.find("MM"), block.find("II"));
    return begin == std::string_view::npos ? std::string_view() : block.substr(begin);
}

/// Text of a tag in the first directory; "" when there is none.
std::string exifText(std::string_view tiff, std::uint64_t tag) {
    const TiffBytes exif(tiff);
    const auto entry = exif.findEntry(exif.integer(4, 4), tag);
    const auto length = entry ? exif.integer(*entry + 4, 4) : std::nullopt;
    const auto place = length && *length > 4 ? exif.integer(*entry + 8, 4) : entry ? std::optional(*entry + 8) : entry;
    if (!length || !place || *place > tiff.size()) return {};
    const std::string_view text = tiff.substr(*place, *length);
    return std::string(text.substr(0, text.find('\0')));
}

/// 35 mm equivalent focal length [mm].
std::optional<float> focalFromExif(std::string_view tiff) {
    constexpr std::uint64_t kExifDirectory = 0x8769;
    constexpr std::uint64_t kFocalLengthIn35mmFilm = 0xa405;
    const TiffBytes exif(tiff);
    const auto pointer = exif.findEntry(exif.integer(4, 4), kExifDirectory);
    const auto entry = pointer ? exif.findEntry(exif.integer(*pointer + 8, 4), kFocalLengthIn35mmFilm) : std::nullopt;
    const auto focal = entry ? exif.integer(*entry + 8, 2) : std::nullopt;
    if (!focal || *focal == 0) return std::nullopt;
    return static_cast<float>(*focal);
}

/// One HEIC file and its images; every failure is an Error(Input) that names it.
class HeifReader {
  public:
    explicit HeifReader(const ImportFile& file)
        : file_(file), rewritten_(withSingleAuxiliaryTargets(file.bytes())), context_(heif_context_alloc()) {
        const std::string& bytes = rewritten_ ? *rewritten_ : file.bytes();
        heif_context_set_maximum_image_size_limit(context_.get(), kMaxImageSide);
        check(heif_context_read_from_memory_without_copy(context_.get(), bytes.data(), bytes.size(), nullptr));
        heif_image_handle* handle = nullptr;
        check(heif_context_get_primary_image_handle(context_.get(), &handle));
        primary_.reset(handle);
    }

    [[nodiscard]] ImageRgb readColor() const {
        const bool deep = heif_image_handle_get_luma_bits_per_pixel(primary_.get()) > 8;
        const Owned<heif_image> image = decode(*primary_, heif_colorspace_RGB,
                                               deep ? heif_chroma_interleaved_RRGGBB_LE : heif_chroma_interleaved_RGB);
        const Plane plane = planeOf(*image, heif_channel_interleaved);
        ImageRgb color(plane.width, plane.height);
        for (int y = 0; y < plane.height; ++y)
            for (int x = 0; x < plane.width; ++x)
                for (int c = 0; c < 3; ++c) color(x, y)[c] = plane.sample(3 * x + c, y) / plane.most();
        decodeTransfer(color);
        for (Vector3f& p : color.pixels()) p = p.cwiseMax(0.0f);
        return color;
    }

    /// The auxiliary image that is a depth map; null when there is none.
    [[nodiscard]] Owned<heif_image_handle> depthImage() const {
        std::vector<heif_item_id> ids(static_cast<std::size_t>(
            std::min(heif_image_handle_get_number_of_auxiliary_images(primary_.get(), 0), kMaxItems)));
        heif_image_handle_get_list_of_auxiliary_image_IDs(primary_.get(), 0, ids.data(), static_cast<int>(ids.size()));
        for (const heif_item_id id : ids) {
            heif_image_handle* handle = nullptr;
            check(heif_image_handle_get_auxiliary_image_handle(primary_.get(), id, &handle));
            Owned<heif_image_handle> image(handle);
            const char* text = nullptr;
            check(heif_image_handle_get_auxiliary_type(handle, &text));
            const std::string type = text == nullptr ? "" : text;
            heif_image_handle_free_auxiliary_types(handle, &text);
            for (const std::string_view known : kDepthTypes)
                if (type == known) return image;
        }
        return nullptr;
    }

    /// Stored integers of a grey image, with or without the file's rotation and mirroring.
    [[nodiscard]] ImageF readGrey(const heif_image_handle& handle, bool turned) const {
        const Owned<heif_image> image = decode(handle, heif_colorspace_undefined, heif_chroma_undefined, turned);
        if (heif_image_has_channel(image.get(), heif_channel_Y) == 0)
            file_.fail(Message("messages", "its depth image is in colour, expected grey"));
        const Plane plane = planeOf(*image, heif_channel_Y);
        ImageF values(plane.width, plane.height);
        for (int y = 0; y < plane.height; ++y)
            for (int x = 0; x < plane.width; ++x) values(x, y) = plane.sample(x, y);
        return values;
    }

    [[nodiscard]] Xmp readXmp(const heif_image_handle& handle) const { return Xmp(metadata(handle, "mime")); }

    [[nodiscard]] std::optional<float> focal35mm() const {
        for (const std::string& block : metadata(*primary_, "Exif"))
            if (const auto focal = focalFromExif(tiffOf(block))) return focal;
        return std::nullopt;
    }

    [[nodiscard]] std::string device() const {
        constexpr std::uint64_t kMake = 0x010f, kModel = 0x0110;
        for (const std::string& block : metadata(*primary_, "Exif")) {
            const std::string_view tiff = tiffOf(block);
            const std::string name = deviceName(exifText(tiff, kMake), exifText(tiff, kModel));
            if (!name.empty()) return name;
        }
        return {};
    }

  private:
    struct Plane {
        const std::uint8_t* bytes = nullptr;
        int width = 0, height = 0, stride = 0, bits = 8;
        [[nodiscard]] float most() const { return static_cast<float>((1 << bits) - 1); }
        [[nodiscard]] float sample(int i, int y) const {
            const std::uint8_t* row = bytes + static_cast<std::ptrdiff_t>(y) * stride;
            if (bits <= 8) return static_cast<float>(row[i]);
            return static_cast<float>(row[2 * i] | row[2 * i + 1] << 8);
        }
    };

    void check(const heif_error& error) const {
        if (error.code != heif_error_Ok) file_.fail(error.message);
    }

    [[nodiscard]] Owned<heif_image> decode(const heif_image_handle& handle, heif_colorspace space, heif_chroma chroma,
                                           bool turned = true) const {
        const int width = heif_image_handle_get_width(&handle);
        const int height = heif_image_handle_get_height(&handle);
        if (width < 1 || height < 1 || static_cast<long>(width) * static_cast<long>(height) > kMaxImagePixels)
            file_.fail(Message("messages", "the image size is %1x%2, expected at most %3 pixels")
                           .with(width, height, kMaxImagePixels));
        const Owned<heif_decoding_options> options(heif_decoding_options_alloc());
        options->ignore_transformations = turned ? 0 : 1;
        heif_image* image = nullptr;
        check(heif_decode_image(&handle, &image, space, chroma, options.get()));
        return Owned<heif_image>(image);
    }

    [[nodiscard]] Plane planeOf(const heif_image& image, heif_channel channel) const {
        Plane plane;
        plane.bytes = heif_image_get_plane_readonly(&image, channel, &plane.stride);
        plane.width = heif_image_get_width(&image, channel);
        plane.height = heif_image_get_height(&image, channel);
        plane.bits = heif_image_get_bits_per_pixel_range(&image, channel);
        if (plane.bytes == nullptr || plane.width < 1 || plane.height < 1 || plane.bits < 1 || plane.bits > 16)
            file_.fail(Message("messages", "an image in it has no pixels"));
        return plane;
    }

    /// Metadata blocks of one type; those that are too large are left out.
    [[nodiscard]] std::vector<std::string> metadata(const heif_image_handle& handle, const char* type) const {
        std::vector<heif_item_id> ids(static_cast<std::size_t>(
            std::min(heif_image_handle_get_number_of_metadata_blocks(&handle, type), kMaxItems)));
        heif_image_handle_get_list_of_metadata_block_IDs(&handle, type, ids.data(), static_cast<int>(ids.size()));
        std::vector<std::string> blocks;
        for (const heif_item_id id : ids) {
            const std::size_t size = heif_image_handle_get_metadata_size(&handle, id);
            if (size == 0 || size > kMaxMetadataBytes) continue;
            std::string& block = blocks.emplace_back(size, '\0');
            check(heif_image_handle_get_metadata(&handle, id, block.data()));
        }
        return blocks;
    }

    void decodeTransfer(ImageRgb& color) const {
        std::string profile(heif_image_handle_get_raw_color_profile_size(primary_.get()), '\0');
        if (!profile.empty()) {
            check(heif_image_handle_get_raw_color_profile(primary_.get(), profile.data()));
            const auto* bytes = reinterpret_cast<const unsigned char*>(profile.data());
            if (decodeIcc(color.pixels(), {bytes, profile.size()})) return;
        }
        heif_color_profile_nclx* found = nullptr;
        if (heif_image_handle_get_nclx_color_profile(primary_.get(), &found).code == heif_error_Ok) {
            const Owned<heif_color_profile_nclx> nclx(found);
            CodedRgb space;
            space.transfer = static_cast<std::uint16_t>(nclx->transfer_characteristics);
            if (nclx->color_primaries != heif_color_primaries_unspecified) {
                space.red = {nclx->color_primary_red_x, nclx->color_primary_red_y};
                space.green = {nclx->color_primary_green_x, nclx->color_primary_green_y};
                space.blue = {nclx->color_primary_blue_x, nclx->color_primary_blue_y};
                space.white = {nclx->color_primary_white_x, nclx->color_primary_white_y};
            }
            if (decodeCoded(color.pixels(), space)) return;
            file_.fail(
                Message("messages",
                        "its colours have the primaries %1 and the transfer function %2 of ITU-T H.273 (16 is PQ, 18 "
                        "is HLG), expected sRGB, a gamma, Rec.709, Rec.2020, linear light or an ICC profile")
                    .with(static_cast<int>(nclx->color_primaries), static_cast<int>(nclx->transfer_characteristics)));
        }
        decodeSrgb(color.pixels());
    }

    const ImportFile& file_;
    std::optional<std::string> rewritten_;  ///< the file, where libheif does not take it as it is
    Owned<heif_context> context_;
    Owned<heif_image_handle> primary_;
};

/// The EXIF orientation that turns `stored` into `displayed`; nullopt when none does.
std::optional<int> orientationBetween(const ImageF& stored, const ImageF& displayed) {
    for (int orientation = 1; orientation <= 8; ++orientation)
        if (applyOrientation(stored, orientation) == displayed) return orientation;
    return std::nullopt;
}

ImportedPhoto readHeifDepth(const ImportFile& file) {
    const HeifReader reader(file);
    ImportedPhoto photo;
    photo.color = reader.readColor();
    photo.focal35mm = reader.focal35mm();
    photo.device = reader.device();
    const auto depth = reader.depthImage();
    if (depth == nullptr) return photo;
    auto apple = readAppleDepth(file, reader.readXmp(*depth));
    if (!apple)
        file.fail(Message("messages",
                          "its depth image says nothing about its range, expected XMP with an AuxiliaryImageType of "
                          "disparity or depth"));
    ImageF displayed = reader.readGrey(*depth, true);
    const auto orientation = orientationBetween(reader.readGrey(*depth, false), displayed);
    if (!orientation) apple->camera.reset();
    setAppleDepth(photo, file, *apple, std::move(displayed), orientation.value_or(1));
    return photo;
}

}  // namespace

const ImportFormat heifDepthFormat{MESSAGE_TEXT("messages", "the auxiliary depth image of a HEIC file"),
                                   recognisesHeifDepth, readHeifDepth};

}  // namespace core
