// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/photo_loader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/analysis/depth/unround_depth.h"
#include "core/analysis/depth/upsample_depth.h"
#include "core/base/statistics.h"
#include "core/io/image_io.h"
#include "core/io/photo_contents.h"
#include "core/io/photo_files.h"

namespace core {

namespace {

// Shares of the time to load a photograph of 12 megapixels whose depth is smaller.
/// Reading the depth.
constexpr float kDepthEnd = 0.05f;
/// Reading depth and colour.
constexpr float kImportEnd = 0.35f;
/// The same when the depth need not be enlarged; the labels take the rest.
constexpr float kSameSizeEnd = 0.92f;
/// Of what follows reading: enlarging the depth.
constexpr float kEnlargeEnd = 0.88f;
/// Of enlarging: freeing the map of its rounding.
constexpr float kUnroundEnd = 0.4f;

constexpr double kDefaultFovDegrees = 60;

void note(Notes* notes, Message sentence) {
    if (notes != nullptr) notes->push_back(std::move(sentence));
}

std::string sizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

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

/// A camera whose fx is right for pixels that are not square: fy in pixels differs by their aspect.
Camera withPixelAspect(Camera camera, const ImageInfo& info, const std::string& path, Notes* notes) {
    if (info.pixelAspect == 1) return camera;
    note(notes, Message("messages", "The pixels of \"%1\" are %2 times as wide as high; the camera accounts for it.")
                    .with(path, info.pixelAspect));
    camera.fy *= info.pixelAspect;
    return camera;
}

/// The requested camera, or the `stated` one of the file `statedBy`, or one from its focal length.
Camera chooseCamera(const PhotoRequest& request, const ImageInfo& info, const std::optional<Camera>& stated,
                    const std::string& statedBy, Notes* notes) {
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
        return withPixelAspect(Camera::fromHorizontalFov(w, h, *request.hfov), info, path, notes);
    }
    if (stated) {
        if (isSensible(*stated)) {
            note(notes, Message("messages", "The intrinsics are taken from \"%1\": %2.")
                            .with(statedBy, intrinsicsText(*stated)));
            return *stated;
        }
        note(notes, Message("messages", "The intrinsics in \"%1\" are ignored, because they fit no camera: %2.")
                        .with(statedBy, intrinsicsText(*stated)));
    }
    if (info.focal35mm) {
        const auto aspect = static_cast<double>(info.pixelAspect);
        const auto focal = static_cast<float>(focalInPixels(*info.focal35mm, w * aspect, h) / aspect);
        std::ostringstream text;
        text << *info.focal35mm;
        note(notes, Message("messages", "The focal length is taken from \"%1\": %2 mm (35 mm equivalent).")
                        .with(path, text.str()));
        return withPixelAspect({w, h, focal, focal, 0.5f * static_cast<float>(w), 0.5f * static_cast<float>(h)}, info,
                               path, notes);
    }
    note(notes,
         Message("messages",
                 "No focal length is given and \"%1\" does not state one: assuming a horizontal field of view of "
                 "60 degrees.")
             .with(path)
             .about(Setting::FieldOfView));
    const auto fov = static_cast<float>(kDefaultFovDegrees * std::numbers::pi / 180);
    return withPixelAspect(Camera::fromHorizontalFov(w, h, fov), info, path, notes);
}

std::optional<double> requestedUnit(const PhotoRequest& request) {
    if (request.depthUnit && (!(*request.depthUnit > 0) || !std::isfinite(*request.depthUnit)))
        throw Error(ErrorKind::Usage,
                    Message("messages", "The depth unit is %1, expected metres per stored unit, greater than 0.")
                        .with(std::to_string(*request.depthUnit)));
    return request.depthUnit;
}

double chooseUnit(const PhotoRequest& request, const PhotoFiles& files, DepthKind kind) {
    if (const auto unit = requestedUnit(request)) return *unit;
    if (!needsUnit(files, kind)) return files.depthFormat.floating ? 1 : 0.001;
    throw Error(ErrorKind::Usage,
                Message("messages",
                        "The depth image \"%1\" stores %2-bit integers, whose unit cannot be guessed: give the metres "
                        "per stored unit.")
                    .with(files.depthPath, files.depthFormat.bits)
                    .about(Setting::DepthUnit));
}

/// Stored values in the photograph's layout to planar z, still at their own resolution.
ImageF planarDepthInside(const Camera& camera, const ImageF& stored, DepthKind kind, double unit) {
    const float sx = static_cast<float>(stored.width()) / static_cast<float>(camera.width);
    const float sy = static_cast<float>(stored.height()) / static_cast<float>(camera.height);
    const Camera own{stored.width(), stored.height(), camera.fx * sx, camera.fy * sy, camera.cx * sx, camera.cy * sy};
    return planarDepth(stored, kind, unit, own);
}

/// Frees the depth of coarse rounding and enlarges it to the photograph, along its outlines.
void enlargeDepth(Photo& photo, const std::string& path, Notes* notes, const Progress& progress) {
    const int width = photo.depth.width();
    const int height = photo.depth.height();
    const Camera& camera = photo.camera;
    note(notes, Message("messages", "The depth in \"%1\" (%2) is enlarged to the colour image (%3).")
                    .with(path, sizeText(width, height), sizeText(camera.width, camera.height)));
    const ImageF smooth = analysis::unroundDepth(photo.depth, progress.part(0, kUnroundEnd));
    photo.depth =
        upsampleDepth(smooth, camera.width, camera.height, &photo.color.image(), progress.part(kUnroundEnd, 1));
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

/// Depth maps of 16 bits without the largest number, where that stands for "not measured": no value comes near it.
ImageF withoutInvalidCode(const PhotoFiles& files, DepthKind kind, Notes* notes) {
    constexpr float kCode = 65535;
    constexpr float kFarBelow = 0.75f * kCode;
    const bool lengths = kind == DepthKind::Z || kind == DepthKind::Distance;
    if (files.depthStatements() != nullptr || files.depthPath.empty() || files.depthFormat.floating ||
        files.depthFormat.bits != 16 || !lengths)
        return files.depth;
    std::size_t codes = 0;
    for (const float value : files.depth.pixels()) {
        if (value == kCode)
            ++codes;
        else if (value > kFarBelow)
            return files.depth;
    }
    if (codes == 0) return files.depth;
    ImageF valid = files.depth;
    for (float& value : valid.pixels())
        if (value == kCode) value = 0;
    const double share = 100.0 * static_cast<double>(codes) / static_cast<double>(valid.size());
    note(notes,
         Message("messages", "%1 % of the values in \"%2\" are 65535, far from all others: they count as not measured.")
             .with(std::lround(share), files.depthPath));
    return valid;
}

/// Networks stretch relative depth over the full range of the file.
void noteRelativeDepth(const PhotoFiles& files, const ImageF& stored, DepthKind kind, Notes* notes) {
    if (files.depthStatements() != nullptr || files.depthPath.empty() || stored.empty() ||
        (kind != DepthKind::Z && kind != DepthKind::Distance))
        return;
    const float largest = files.depthFormat.floating ? 1.0f : std::exp2(static_cast<float>(files.depthFormat.bits)) - 1;
    const auto [least, most] = std::ranges::minmax(stored.pixels());
    if (least != 0 || most != largest) return;
    note(notes,
         Message("messages",
                 "The values of \"%1\" fill the range from 0 to %2 exactly, so this is probably relative depth, as "
                 "networks give it, often with the largest value nearest. For that, give the kind \"inverse\" "
                 "and a unit.")
             .with(files.depthPath, largest)
             .about(Setting::DepthUnitOrKind));
}

void noteMissingDepth(const std::string& path, Notes* notes) {
    std::vector<Message> known;
    for (const ImportFormat* format : importFormats()) known.emplace_back("messages", format->name);
    note(notes, Message("messages",
                        "\"%1\" contains no depth map (%2), and no depth image is given. Objects can be selected by "
                        "their colour, but materials cannot be changed: that needs a depth map.")
                    .with(path, listed(known)));
}

/// Kind and unit of depth inside the photograph's file, as the user or the file says.
void chooseMeaning(const ImportedPhoto& imported, const PhotoRequest& request, PhotoSource& source, Notes* notes) {
    const std::string& path = source.depth.empty() ? source.color : source.depth;
    source.depthKind = request.depthKind.value_or(imported.kind.value_or(DepthKind::Z));
    if (imported.kind && source.depthKind != *imported.kind)
        note(notes,
             Message("messages", "The depth inside \"%1\" is read as \"%2\", although the file says that it is \"%3\".")
                 .with(path, wordOf(source.depthKind), wordOf(*imported.kind))
                 .about(Setting::DepthUnitOrKind));
    const auto given = requestedUnit(request);
    source.depthUnit = given.value_or(imported.unit);
    if (!given && !imported.assumedUnit.empty()) note(notes, imported.assumedUnit);
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

bool needsEnlarging(const PhotoReading& reading) {
    const Camera& camera = reading.camera;
    return !reading.depth.empty() && (reading.depth.width() != camera.width || reading.depth.height() != camera.height);
}

/// Fits depth and labels to the colour, which has been read.
std::shared_ptr<const Photo> finishPhoto(const PhotoFiles& files, const PhotoRequest& request, PhotoReading reading,
                                         Notes* notes, const Progress& progress) {
    progress.checkpoint(0);
    const bool enlarged = needsEnlarging(reading);
    auto photo = std::make_shared<Photo>();
    photo->source = std::move(reading.source);
    photo->camera = reading.camera;
    photo->color = files.color;
    for (const Message& remark : files.colorRemarks) note(notes, remark);
    if (files.imported)
        photo->clipLevel = files.imported->clipLevel;
    else if (!files.info.format.floating)
        photo->clipLevel = 1;
    const Camera& camera = photo->camera;
    photo->depth = reading.depth.empty() ? ImageF(camera.width, camera.height, 0.0f) : std::move(reading.depth);
    const float enlargeEnd = enlarged ? kEnlargeEnd : 0.0f;
    if (enlarged) enlargeDepth(*photo, files.depthFile(), notes, progress.part(0, enlargeEnd));
    progress.checkpoint(enlargeEnd);
    for (const auto* photograph : {&files.imported, &files.depthImported})
        if (*photograph)
            for (const Message& remark : (*photograph)->remarks) note(notes, remark);
    const PhotoSource& source = photo->source;
    if (source.segments.empty()) {
        photo->labels = LabelImage(camera.width, camera.height, 0);
    } else {
        const ImageInfo labelInfo = readImageInfo(source.segments);
        photo->labels = resampleNearest(matchOrientation(loadLabels(source.segments, notes, request.maskEdges),
                                                         source.segments, Message("messages", "Label map"), camera,
                                                         labelInfo.orientation, files.info.orientation, source.color),
                                        camera);
    }
    progress.checkpoint(1);
    return photo;
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

PhotoReading interpretPhoto(const PhotoFiles& files, const PhotoRequest& request, Notes* notes) {
    PhotoReading reading;
    reading.source = request.source;
    PhotoSource& source = reading.source;
    source.depthKind = request.depthKind.value_or(DepthKind::Z);
    const bool fromDepth = files.depthImported && files.depthImported->camera;
    const std::optional<Camera> stated = fromDepth        ? files.depthImported->camera
                                         : files.imported ? files.imported->camera
                                                          : std::nullopt;
    reading.camera = chooseCamera(request, files.info, stated, fromDepth ? source.depth : source.color, notes);
    if (!files.hasDepth()) {
        noteMissingDepth(source.color, notes);
        return reading;
    }
    if (const ImportedPhoto* statements = files.depthStatements())
        chooseMeaning(*statements, request, source, notes);
    else
        source.depthUnit = chooseUnit(request, files, source.depthKind);
    for (const Message& remark : files.depthRemarks) note(notes, remark);
    const ImageF stored = withoutInvalidCode(files, source.depthKind, notes);
    noteRelativeDepth(files, stored, source.depthKind, notes);
    reading.depth = planarDepthInside(reading.camera, stored, source.depthKind, source.depthUnit);
    requireValidDepth(reading.depth, files.depthFile());
    noteImplausibleDepth(reading.depth, files.depthFile(), source.depthUnit, notes);
    return reading;
}

std::shared_ptr<const Photo> loadPhoto(const PhotoRequest& request, Notes* notes, const Progress& progress) {
    progress.checkpoint(0);
    PhotoFiles files = readStoredDepth(request.source.color, request.source.depth);
    PhotoReading reading = interpretPhoto(files, request, notes);
    const float readEnd = needsEnlarging(reading) ? kImportEnd : kSameSizeEnd;
    progress.checkpoint(files.imported ? readEnd : kDepthEnd);
    readColor(files);
    return finishPhoto(files, request, std::move(reading), notes, progress.part(readEnd, 1));
}

std::shared_ptr<const Photo> loadPhoto(const PhotoFiles& files, const PhotoRequest& request, Notes* notes,
                                       const Progress& progress) {
    CORE_ASSERT(!files.color.empty(), "the colour has to be read first");
    return finishPhoto(files, request, interpretPhoto(files, request, notes), notes, progress);
}

std::shared_ptr<const ImageRgb> loadEnvironment(const std::string& path, Notes* notes) {
    auto image = std::make_shared<ImageRgb>(loadColor(path, notes));
    if (image->width() != 2 * image->height())
        throw Error(
            ErrorKind::Input,
            Message("messages",
                    "Environment \"%1\" has %2 pixels, expected a latitude-longitude map, twice as wide as high.")
                .with(path, sizeText(image->width(), image->height())));
    return image;
}

LabelImage loadLabelMap(const std::string& path, const Camera& camera, Notes* notes) {
    return resampleNearest(matchOrientation(loadLabels(path, notes), path, Message("messages", "Label map"), camera,
                                            readImageInfo(path).orientation, 1, Message("messages", "the photograph")),
                           camera);
}

std::shared_ptr<const ImageF> loadBackDepth(const std::string& path, const Camera& camera) {
    const StoredFormat format = storedFormat(path);
    const ImageF depth = planarDepthInside(
        camera,
        readMapFile(path, camera, 1, Message("messages", "the photograph"), Message("messages", "Back depth image")),
        DepthKind::Z, format.floating ? 1.0 : 0.001);
    requireValidDepth(depth, path);
    return std::make_shared<ImageF>(upsampleDepth(depth, camera.width, camera.height, nullptr));
}

}  // namespace core
