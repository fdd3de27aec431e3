// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/photo_loader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/analysis/depth/upsample_depth.h"
#include "core/base/statistics.h"
#include "core/io/image_io.h"
#include "core/io/import/import_format.h"
#include "core/io/orientation.h"

namespace core {

namespace {

// Shares of the time to load a photograph of 12 megapixels whose depth is smaller.
/// Reading the depth.
constexpr float kDepthEnd = 0.05f;
/// Reading depth and colour.
constexpr float kImportEnd = 0.35f;
/// Enlarging the depth; the labels take the rest.
constexpr float kEnlargeEnd = 0.92f;

constexpr double kDefaultFovDegrees = 60;
constexpr double kShapeTolerance = 0.02;  ///< relative difference of width / height

void note(Notes* notes, Message sentence) {
    if (notes != nullptr) notes->push_back(std::move(sentence));
}

std::string sizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// True if a map can be enlarged to the photograph: same shape within the tolerance, and not larger.
bool fits(int width, int height, const Camera& camera) {
    const double ratio = static_cast<double>(width) * camera.height / (static_cast<double>(height) * camera.width);
    return std::abs(ratio - 1) <= kShapeTolerance && width <= camera.width && height <= camera.height;
}

template <class T>
Image<T> enlarge(Image<T> image, const Camera& camera) {
    if (image.width() == camera.width && image.height() == camera.height) return image;
    Image<T> result(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        const auto v = static_cast<int>((static_cast<long>(2 * y + 1) * image.height()) / (2L * camera.height));
        for (int x = 0; x < camera.width; ++x) {
            const auto u = static_cast<int>((static_cast<long>(2 * x + 1) * image.width()) / (2L * camera.width));
            result(x, y) = image(u, v);
        }
    }
    return result;
}

/// Turns a map to the photograph's orientation, still at its own resolution. A map without an orientation tag is turned
/// when it has the shape of the photograph as stored.
template <class T>
Image<T> matchOrientation(Image<T> map, const std::string& path, const Message& what, const Camera& camera,
                          int mapOrientation, int colorOrientation, const Message& colorPath) {
    if (fits(map.width(), map.height(), camera)) return map;
    if (mapOrientation == 1 && colorOrientation >= 5 && fits(map.height(), map.width(), camera))
        return applyOrientation(std::move(map), colorOrientation);
    throw Error(ErrorKind::Input,
                Message("messages",
                        "%1 size (%2) differs from colour image size (%3); expected the same size or a smaller image "
                        "of the same shape.")
                    .with(what, sizeText(map.width(), map.height()), sizeText(camera.width, camera.height)))
        .withContext(Message("messages", "While loading \"%1\" for \"%2\".").with(path, colorPath));
}

/// Focal lengths of 0.01 to 1000 image sides, a principal point within 10 image sides.
bool isSensible(const Camera& camera) {
    const auto near = [](float v, int size) {
        return std::isfinite(v) && std::abs(v) <= 10.0f * static_cast<float>(size);
    };
    const auto focal = [](float f, int size) {
        return std::isfinite(f) && f >= 0.01f * static_cast<float>(size) && f <= 1000.0f * static_cast<float>(size);
    };
    return focal(camera.fx, camera.width) && focal(camera.fy, camera.height) && near(camera.cx, camera.width) &&
           near(camera.cy, camera.height);
}

std::string intrinsicsText(const Camera& camera) {
    std::ostringstream text;
    text << "fx=" << camera.fx << ", fy=" << camera.fy << ", cx=" << camera.cx << ", cy=" << camera.cy;
    return text.str();
}

/// The requested camera, or the `stated` one of the photograph's file, or one from its focal length.
Camera chooseCamera(const PhotoRequest& request, const ImageInfo& info, const std::optional<Camera>& stated,
                    Notes* notes) {
    const int w = info.width;
    const int h = info.height;
    const std::string& path = request.source.color;
    if (request.intrinsics) {
        Camera camera = *request.intrinsics;
        camera.width = w;
        camera.height = h;
        if (!isSensible(camera))
            throw Error(ErrorKind::Usage,
                        Message("messages",
                                "The intrinsics %1 do not fit the colour image \"%2\" of %3 pixels: expected focal "
                                "lengths of 0.01 to 1000 image sides and a principal point within 10 image sides.")
                            .with(intrinsicsText(camera), path, sizeText(w, h)));
        return camera;
    }
    if (request.hfov) {
        if (!(*request.hfov > 0.001f && *request.hfov < 3.1f))
            throw Error(ErrorKind::Usage,
                        Message("messages", "The horizontal field of view is %1 degrees, expected 0.1 to 177.")
                            .with(std::to_string(*request.hfov * 180 / std::numbers::pi_v<float>)));
        return Camera::fromHorizontalFov(w, h, *request.hfov);
    }
    if (stated) {
        if (isSensible(*stated)) {
            note(notes,
                 Message("messages", "The intrinsics are taken from \"%1\": %2.").with(path, intrinsicsText(*stated)));
            return *stated;
        }
        note(notes, Message("messages", "The intrinsics in \"%1\" are ignored, because they fit no camera: %2.")
                        .with(path, intrinsicsText(*stated)));
    }
    if (info.focal35mm) {
        const double diagonal = std::hypot(w, h);
        const auto focal = static_cast<float>(static_cast<double>(*info.focal35mm) * diagonal / kFilmDiagonal);
        std::ostringstream text;
        text << *info.focal35mm;
        note(notes, Message("messages", "The focal length is taken from \"%1\": %2 mm (35 mm equivalent).")
                        .with(path, text.str()));
        return {w, h, focal, focal, 0.5f * static_cast<float>(w), 0.5f * static_cast<float>(h)};
    }
    note(notes,
         Message("messages",
                 "No focal length is given and \"%1\" does not state one: assuming a horizontal field of view of "
                 "60 degrees.")
             .with(path)
             .about(Setting::FieldOfView));
    return Camera::fromHorizontalFov(w, h, static_cast<float>(kDefaultFovDegrees * std::numbers::pi / 180));
}

std::optional<double> requestedUnit(const PhotoRequest& request) {
    if (request.depthUnit && (!(*request.depthUnit > 0) || !std::isfinite(*request.depthUnit)))
        throw Error(ErrorKind::Usage,
                    Message("messages", "The depth unit is %1, expected metres per stored unit, greater than 0.")
                        .with(std::to_string(*request.depthUnit)));
    return request.depthUnit;
}

double chooseUnit(const PhotoRequest& request, const std::string& depthPath, const StoredFormat& format) {
    if (const auto unit = requestedUnit(request)) return *unit;
    const bool length = request.source.depthKind == DepthKind::Z || request.source.depthKind == DepthKind::Distance;
    if (format.floating) return 1;
    if (format.bits == 16 && length) return 0.001;
    throw Error(ErrorKind::Usage,
                Message("messages",
                        "The depth image \"%1\" stores %2-bit integers, whose unit cannot be guessed: give the metres "
                        "per stored unit.")
                    .with(depthPath, format.bits)
                    .about(Setting::DepthUnit));
}

/// Stored values in the photograph's layout to planar z, still at their own resolution.
ImageF planarDepthInside(const Camera& camera, const ImageF& stored, DepthKind kind, double unit) {
    const float sx = static_cast<float>(stored.width()) / static_cast<float>(camera.width);
    const float sy = static_cast<float>(stored.height()) / static_cast<float>(camera.height);
    const Camera own{stored.width(), stored.height(), camera.fx * sx, camera.fy * sy, camera.cx * sx, camera.cy * sy};
    return planarDepth(stored, kind, unit, own);
}

/// Enlarges the depth to the photograph, along its outlines.
void enlargeDepth(Photo& photo, const std::string& path, Notes* notes, const Progress& progress) {
    const int width = photo.depth.width();
    const int height = photo.depth.height();
    const Camera& camera = photo.camera;
    if (width == camera.width && height == camera.height) return;
    note(notes, Message("messages", "The depth in \"%1\" (%2) is enlarged to the colour image (%3).")
                    .with(path, sizeText(width, height), sizeText(camera.width, camera.height)));
    photo.depth = upsampleDepth(photo.depth, camera.width, camera.height, &photo.color.image(), progress);
    photo.depthSampleSpacing = std::max({1.0f, static_cast<float>(camera.width) / static_cast<float>(width),
                                         static_cast<float>(camera.height) / static_cast<float>(height)});
}

/// A wrong unit shows in the median depth, which lies outside the range of any photograph.
void noteImplausibleDepth(const ImageF& depth, const std::string& path, double unit, Notes* notes) {
    constexpr float kMinMedian = 0.05f;
    constexpr float kMaxMedian = 1000;
    std::vector<float> valid;
    for (const float z : depth.pixels())
        if (z > 0) valid.push_back(z);
    const float middle = median(valid);
    if (middle >= kMinMedian && middle <= kMaxMedian) return;
    note(notes,
         Message("messages",
                 "The median depth in \"%1\" is %2 m with a unit of %3 m, expected %4 to %5 m: the unit is probably "
                 "wrong. Give the metres per stored unit (0.001 for millimetres, 1 for metres), or the right kind of "
                 "depth.")
             .with(path, middle, unit, kMinMedian, kMaxMedian)
             .about(Setting::DepthUnitOrKind));
}

ImageF readDepthFile(const std::string& path, const Camera& camera, int colorOrientation, const Message& colorPath,
                     const Message& what) {
    return matchOrientation(loadScalar(path), path, what, camera, readImageInfo(path).orientation, colorOrientation,
                            colorPath);
}

ImageInfo importedInfo(const ImportedPhoto& photo) {
    ImageInfo info;
    info.width = photo.color.width();
    info.height = photo.color.height();
    info.orientation = photo.orientation;
    info.focal35mm = photo.focal35mm;
    return info;
}

/// Photograph of a file that carries depth or that only an import format reads.
std::optional<ImportedPhoto> importPhoto(const PhotoSource& source) {
    if (!source.depth.empty() && isImageFile(source.color)) return std::nullopt;
    const ImportFile file(source.color);
    const ImportFormat* format = findImportFormat(file);
    if (format == nullptr) return std::nullopt;
    return format->read(file);
}

[[noreturn]] void refuseWithoutDepth(const std::string& path) {
    std::vector<Message> known;
    for (const ImportFormat* format : importFormats()) known.emplace_back("messages", format->name);
    throw Error(ErrorKind::Input, Message("messages", "\"%1\" contains no depth map (%2), and no depth image is given.")
                                      .with(path, listed(known)));
}

/// Removes the depth of pixels that surfaces cover only in part (antialiased, moving or out of focus), because it is a
/// mixture or that of one sample. Where most of the picture is not opaque, alpha is not coverage, and all depth stays.
ImageF withoutMixedDepth(ImageF depth, const ImageF& coverage) {
    constexpr float kOpaque = 0.99f;
    if (!coverage.sameSize(depth)) return depth;
    std::size_t opaque = 0, count = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (!(depth[i] > 0)) continue;
        ++count;
        if (coverage[i] >= kOpaque) ++opaque;
    }
    if (2 * opaque < count) return depth;
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (!(coverage[i] >= kOpaque)) depth[i] = 0;
    return depth;
}

/// Depth from inside the photograph's file; fills in the kind and unit that the file states.
ImageF importedDepth(const ImportedPhoto& imported, const PhotoRequest& request, PhotoSource& source,
                     const Camera& camera, Notes* notes) {
    if (imported.kind) {
        if (source.depthKind != DepthKind::Z && source.depthKind != *imported.kind)
            throw Error(ErrorKind::Usage,
                        Message("messages",
                                "The depth kind is \"%1\", but the file says that the depth inside \"%2\" is \"%3\".")
                            .with(wordOf(source.depthKind), source.color, wordOf(*imported.kind)));
        source.depthKind = *imported.kind;
    }
    const auto given = requestedUnit(request);
    source.depthUnit = given.value_or(imported.unit);
    if (!given && !imported.assumedUnit.empty()) note(notes, imported.assumedUnit);
    const ImageF stored = matchOrientation(withoutMixedDepth(imported.depth, imported.coverage), source.color,
                                           Message("messages", "Depth image"), camera, 1, 1, source.color);
    return planarDepthInside(camera, stored, source.depthKind, source.depthUnit);
}

void requireValidDepth(const ImageF& depth, const std::string& path) {
    for (const float z : depth.pixels())
        if (z > 0) return;
    throw Error(ErrorKind::Input,
                Message("messages",
                        "Depth image \"%1\" has no valid pixel: every value is zero, negative, not a number or beyond "
                        "%2 m.")
                    .with(path, static_cast<int>(kMaxDepth)));
}

}  // namespace

ImageF planarDepth(const ImageF& stored, DepthKind kind, double unit, const Camera& camera) {
    ImageF result(stored.width(), stored.height(), 0.0f);
    for (int y = 0; y < stored.height(); ++y)
        for (int x = 0; x < stored.width(); ++x) {
            const auto value = static_cast<double>(stored(x, y));
            if (!std::isfinite(value) || value <= 0) continue;
            double z = value * unit;
            if (kind == DepthKind::Distance) z /= static_cast<double>(camera.pixelRay(x, y).norm());
            if (kind == DepthKind::Disparity || kind == DepthKind::Inverse) z = unit / value;
            const auto metres = static_cast<float>(z);
            if (metres > 0 && metres <= kMaxDepth) result(x, y) = metres;
        }
    return result;
}

std::shared_ptr<const Photo> loadPhoto(const PhotoRequest& request, Notes* notes, const Progress& progress) {
    progress.checkpoint(0);
    auto photo = std::make_shared<Photo>();
    photo->source = request.source;
    PhotoSource& source = photo->source;
    std::optional<ImportedPhoto> imported = importPhoto(source);
    if (source.depth.empty() && (!imported || imported->depth.empty())) {
        if (!imported) (void)readImageInfo(source.color);  // reports what is wrong with a file that is not a picture
        refuseWithoutDepth(source.color);
    }
    const ImageInfo info = imported ? importedInfo(*imported) : readImageInfo(source.color);
    photo->camera = chooseCamera(request, info, imported ? imported->camera : std::nullopt, notes);
    const Camera& camera = photo->camera;
    if (source.depth.empty()) {
        photo->depth = importedDepth(*imported, request, source, camera, notes);
    } else {
        source.depthUnit = chooseUnit(request, source.depth, storedFormat(source.depth));
        photo->depth = planarDepthInside(
            camera,
            readDepthFile(source.depth, camera, info.orientation, source.color, Message("messages", "Depth image")),
            source.depthKind, source.depthUnit);
    }
    const std::string& depthPath = source.depth.empty() ? source.color : source.depth;
    requireValidDepth(photo->depth, depthPath);
    noteImplausibleDepth(photo->depth, depthPath, source.depthUnit, notes);
    const bool sameSize = photo->depth.width() == camera.width && photo->depth.height() == camera.height;
    const float importEnd = sameSize ? kEnlargeEnd : kImportEnd;
    progress.checkpoint(imported ? importEnd : kDepthEnd);
    photo->color = imported ? std::move(imported->color) : loadColor(source.color, notes);
    if (imported)
        photo->clipLevel = imported->clipLevel;
    else if (!info.format.floating)
        photo->clipLevel = 1;
    enlargeDepth(*photo, depthPath, notes, progress.part(importEnd, kEnlargeEnd));
    progress.checkpoint(kEnlargeEnd);
    if (imported)
        for (const Message& remark : imported->remarks) note(notes, remark);
    if (source.segments.empty()) {
        photo->labels = LabelImage(camera.width, camera.height, 0);
    } else {
        const ImageInfo labelInfo = readImageInfo(source.segments);
        photo->labels = enlarge(matchOrientation(loadLabels(source.segments, notes, request.maskEdges), source.segments,
                                                 Message("messages", "Label map"), camera, labelInfo.orientation,
                                                 info.orientation, source.color),
                                camera);
    }
    progress.checkpoint(1);
    return photo;
}

std::shared_ptr<const ImageRgb> loadEnvironment(const std::string& path) {
    auto image = std::make_shared<ImageRgb>(loadColor(path));
    if (image->width() != 2 * image->height())
        throw Error(
            ErrorKind::Input,
            Message("messages",
                    "Environment \"%1\" has %2 pixels, expected a latitude-longitude map, twice as wide as high.")
                .with(path, sizeText(image->width(), image->height())));
    return image;
}

LabelImage loadLabelMap(const std::string& path, const Camera& camera, Notes* notes) {
    return enlarge(matchOrientation(loadLabels(path, notes), path, Message("messages", "Label map"), camera,
                                    readImageInfo(path).orientation, 1, Message("messages", "the photograph")),
                   camera);
}

std::shared_ptr<const ImageF> loadBackDepth(const std::string& path, const Camera& camera) {
    const StoredFormat format = storedFormat(path);
    const ImageF depth = planarDepthInside(
        camera,
        readDepthFile(path, camera, 1, Message("messages", "the photograph"), Message("messages", "Back depth image")),
        DepthKind::Z, format.floating ? 1.0 : 0.001);
    requireValidDepth(depth, path);
    return std::make_shared<ImageF>(upsampleDepth(depth, camera.width, camera.height, nullptr));
}

}  // namespace core
