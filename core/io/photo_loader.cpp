// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/photo_loader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/analysis/depth/upsample_depth.h"
#include "core/io/image_io.h"
#include "core/io/import/import_format.h"
#include "core/io/orientation.h"
#include "core/io/project.h"

namespace core {

namespace {

constexpr double kDefaultFovDegrees = 60;
constexpr double kFilmDiagonal = 43.266615;  // of a 36 mm x 24 mm frame [mm]
constexpr double kShapeTolerance = 0.02;     // of width / height
constexpr std::array<const char*, 4> kDepthKinds{"z", "distance", "disparity", "inverse"};

void note(std::vector<std::string>* notes, const std::string& sentence) {
    if (notes != nullptr) notes->push_back(sentence);
}

std::string sizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// Same shape within the tolerance, and not larger: what can be enlarged to the photograph.
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

/// Brings a map to the photograph's raster, still at its own resolution. A map that says nothing about its orientation
/// but has the shape of the photograph as it is stored is turned with it.
template <class T>
Image<T> matchOrientation(Image<T> map, const std::string& path, const char* what, const Camera& camera,
                          int mapOrientation, int colorOrientation, const std::string& colorPath) {
    if (fits(map.width(), map.height(), camera)) return map;
    if (mapOrientation == 1 && colorOrientation >= 5 && fits(map.height(), map.width(), camera))
        return applyOrientation(std::move(map), colorOrientation);
    throw Error(ErrorKind::Input,
                std::string(what) + " size (" + sizeText(map.width(), map.height()) +
                    ") differs from colour image size (" + sizeText(camera.width, camera.height) +
                    "); expected the same size or a smaller image of the same shape. While loading \"" + path +
                    "\" for \"" + colorPath + "\".");
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

/// `stated`: what the file of the photograph says.
Camera chooseCamera(const PhotoRequest& request, const ImageInfo& info, const std::optional<Camera>& stated,
                    std::vector<std::string>* notes) {
    const int w = info.width;
    const int h = info.height;
    const std::string& path = request.source.color;
    if (request.intrinsics) {
        Camera camera = *request.intrinsics;
        camera.width = w;
        camera.height = h;
        if (!isSensible(camera))
            throw Error(ErrorKind::Usage,
                        "The intrinsics " + intrinsicsText(camera) + " do not fit the colour image \"" + path +
                            "\" of " + sizeText(w, h) +
                            " pixels: expected focal lengths of 0.01 to 1000 image sides and a principal point "
                            "within 10 image sides.");
        return camera;
    }
    if (request.hfov) {
        if (!(*request.hfov > 0.001f && *request.hfov < 3.1f))
            throw Error(ErrorKind::Usage, "The horizontal field of view is " +
                                              std::to_string(*request.hfov * 180 / std::numbers::pi_v<float>) +
                                              " degrees, expected 0.1 to 177.");
        return Camera::fromHorizontalFov(w, h, *request.hfov);
    }
    if (stated) {
        if (isSensible(*stated)) {
            note(notes, "The intrinsics are taken from \"" + path + "\": " + intrinsicsText(*stated) + ".");
            return *stated;
        }
        note(notes, "The intrinsics in \"" + path +
                        "\" are ignored, because they fit no camera: " + intrinsicsText(*stated) + ".");
    }
    if (info.focal35mm) {
        const double diagonal = std::hypot(w, h);
        const auto focal = static_cast<float>(static_cast<double>(*info.focal35mm) * diagonal / kFilmDiagonal);
        std::ostringstream text;
        text << "The focal length is taken from \"" << path << "\": " << *info.focal35mm << " mm (35 mm equivalent).";
        note(notes, text.str());
        return {w, h, focal, focal, 0.5f * static_cast<float>(w), 0.5f * static_cast<float>(h)};
    }
    note(notes, "No focal length is given and \"" + path +
                    "\" does not state one: assuming a horizontal field of view of 60 degrees.");
    return Camera::fromHorizontalFov(w, h, static_cast<float>(kDefaultFovDegrees * std::numbers::pi / 180));
}

std::optional<double> requestedUnit(const PhotoRequest& request) {
    if (request.depthUnit && (!(*request.depthUnit > 0) || !std::isfinite(*request.depthUnit)))
        throw Error(ErrorKind::Usage, "The depth unit is " + std::to_string(*request.depthUnit) +
                                          ", expected metres per stored unit, greater than 0.");
    return request.depthUnit;
}

double chooseUnit(const PhotoRequest& request, const std::string& depthPath, const StoredFormat& format) {
    if (const auto unit = requestedUnit(request)) return *unit;
    const bool length = request.source.depthKind == DepthKind::Z || request.source.depthKind == DepthKind::Distance;
    if (format.floating) return 1;
    if (format.bits == 16 && length) return 0.001;
    throw Error(ErrorKind::Usage, "The depth image \"" + depthPath + "\" stores " + std::to_string(format.bits) +
                                      "-bit integers, whose unit cannot be guessed: give the metres per stored unit "
                                      "(--depth-unit).");
}

/// Stored values in the photograph's layout to planar z, still at their own resolution.
ImageF planarDepthInside(const Camera& camera, const ImageF& stored, DepthKind kind, double unit) {
    const float sx = static_cast<float>(stored.width()) / static_cast<float>(camera.width);
    const float sy = static_cast<float>(stored.height()) / static_cast<float>(camera.height);
    const Camera own{stored.width(), stored.height(), camera.fx * sx, camera.fy * sy, camera.cx * sx, camera.cy * sy};
    return planarDepth(stored, kind, unit, own);
}

/// To the photograph's raster, with its outlines.
void enlargeDepth(Photo& photo, const std::string& path, std::vector<std::string>* notes) {
    const int width = photo.depth.width();
    const int height = photo.depth.height();
    const Camera& camera = photo.camera;
    if (width == camera.width && height == camera.height) return;
    note(notes, "The depth in \"" + path + "\" (" + sizeText(width, height) + ") is enlarged to the colour image (" +
                    sizeText(camera.width, camera.height) + ").");
    photo.depth = upsampleDepth(photo.depth, camera.width, camera.height, &photo.color);
    photo.depthSampleSpacing = std::max({1.0f, static_cast<float>(camera.width) / static_cast<float>(width),
                                         static_cast<float>(camera.height) / static_cast<float>(height)});
}

/// A wrong unit shows in the median: no photograph is of things nearer or farther than this.
void noteImplausibleDepth(const ImageF& depth, const std::string& path, double unit, std::vector<std::string>* notes) {
    constexpr float kNearest = 0.05f;
    constexpr float kFarthest = 1000;
    std::vector<float> valid;
    for (const float z : depth.pixels())
        if (z > 0) valid.push_back(z);
    const auto middle = valid.begin() + static_cast<std::ptrdiff_t>(valid.size() / 2);
    std::ranges::nth_element(valid, middle);
    if (*middle >= kNearest && *middle <= kFarthest) return;
    std::ostringstream text;
    text << "The median depth in \"" << path << "\" is " << *middle << " m with a unit of " << unit << " m, expected "
         << kNearest << " to " << kFarthest
         << " m: the unit is probably wrong. Give the metres per stored unit, 0.001 for millimetres and 1 for metres "
            "(--depth-unit), or the right kind of depth (--depth-kind).";
    note(notes, text.str());
}

ImageF readDepthFile(const std::string& path, const Camera& camera, int colorOrientation, const std::string& colorPath,
                     const char* what) {
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

/// The photograph when it is in a file with depth, or in one that only an import format reads.
std::optional<ImportedPhoto> importPhoto(const PhotoSource& source) {
    if (!source.depth.empty() && isImageFile(source.color)) return std::nullopt;
    const ImportFile file(source.color);
    const ImportFormat* format = findImportFormat(file);
    if (format == nullptr) return std::nullopt;
    return format->read(file);
}

[[noreturn]] void refuseWithoutDepth(const std::string& path) {
    std::string known;
    for (const ImportFormat* format : importFormats()) known += (known.empty() ? "" : ", ") + std::string(format->name);
    throw Error(ErrorKind::Input,
                "\"" + path + "\" contains no depth map (" + known + "), and no depth image is given.");
}

/// Takes the depth from pixels that surfaces cover only in part (antialiased, moving or out of focus ones): it is a
/// mixture or of one sample. Where most of the picture is not opaque, alpha is no coverage, and all depth stays.
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

/// Depth from inside the photograph's file; completes `source` by what the file says.
ImageF importedDepth(const ImportedPhoto& imported, const PhotoRequest& request, PhotoSource& source,
                     const Camera& camera, std::vector<std::string>* notes) {
    if (imported.kind) {
        if (source.depthKind != DepthKind::Z && source.depthKind != *imported.kind)
            throw Error(ErrorKind::Usage, "The depth kind is \"" + std::string(depthKindKey(source.depthKind)) +
                                              "\", but the file says that the depth inside \"" + source.color +
                                              "\" is \"" + depthKindKey(*imported.kind) + "\".");
        source.depthKind = *imported.kind;
    }
    const auto given = requestedUnit(request);
    source.depthUnit = given.value_or(imported.unit);
    if (!given && !imported.assumedUnit.empty()) note(notes, imported.assumedUnit);
    const ImageF stored = matchOrientation(withoutMixedDepth(imported.depth, imported.coverage), source.color,
                                           "Depth image", camera, 1, 1, source.color);
    return planarDepthInside(camera, stored, source.depthKind, source.depthUnit);
}

void requireValidDepth(const ImageF& depth, const std::string& path) {
    for (const float z : depth.pixels())
        if (z > 0) return;
    throw Error(ErrorKind::Input, "Depth image \"" + path +
                                      "\" has no valid pixel: every value is zero, negative, not a number or beyond " +
                                      std::to_string(static_cast<int>(kMaxDepth)) + " m.");
}

}  // namespace

const char* depthKindKey(DepthKind kind) { return kDepthKinds[static_cast<std::size_t>(kind)]; }

std::optional<DepthKind> findDepthKind(std::string_view key) {
    for (std::size_t i = 0; i < kDepthKinds.size(); ++i)
        if (key == kDepthKinds[i]) return static_cast<DepthKind>(i);
    return std::nullopt;
}

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

std::shared_ptr<const Photo> loadPhoto(const PhotoRequest& request, std::vector<std::string>* notes) {
    auto photo = std::make_shared<Photo>();
    photo->source = request.source;
    PhotoSource& source = photo->source;
    std::optional<ImportedPhoto> imported = importPhoto(source);
    if (source.depth.empty() && (!imported || imported->depth.empty())) {
        if (!imported) (void)readImageInfo(source.color);  // says what is wrong with a file that is no picture
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
            camera, readDepthFile(source.depth, camera, info.orientation, source.color, "Depth image"),
            source.depthKind, source.depthUnit);
    }
    const std::string& depthPath = source.depth.empty() ? source.color : source.depth;
    requireValidDepth(photo->depth, depthPath);
    noteImplausibleDepth(photo->depth, depthPath, source.depthUnit, notes);
    photo->color = imported ? std::move(imported->color) : loadColor(source.color, notes);
    if (imported)
        photo->clipLevel = imported->clipLevel;
    else if (!info.format.floating)
        photo->clipLevel = 1;
    enlargeDepth(*photo, depthPath, notes);
    if (imported)
        for (const std::string& remark : imported->remarks) note(notes, remark);
    if (source.segments.empty()) {
        photo->labels = LabelImage(camera.width, camera.height, 0);
    } else {
        const ImageInfo labelInfo = readImageInfo(source.segments);
        photo->labels = enlarge(matchOrientation(loadLabels(source.segments), source.segments, "Label map", camera,
                                                 labelInfo.orientation, info.orientation, source.color),
                                camera);
    }
    return photo;
}

std::shared_ptr<const ImageRgb> loadEnvironment(const std::string& path) {
    auto image = std::make_shared<ImageRgb>(loadColor(path));
    if (image->width() != 2 * image->height())
        throw Error(ErrorKind::Input, "Environment \"" + path + "\" has " + sizeText(image->width(), image->height()) +
                                          " pixels, expected a latitude-longitude map, twice as wide as high.");
    return image;
}

std::shared_ptr<const ImageF> loadBackDepth(const std::string& path, const Camera& camera) {
    const StoredFormat format = storedFormat(path);
    const ImageF depth = planarDepthInside(camera, readDepthFile(path, camera, 1, "the photograph", "Back depth image"),
                                           DepthKind::Z, format.floating ? 1.0 : 0.001);
    requireValidDepth(depth, path);
    return std::make_shared<ImageF>(upsampleDepth(depth, camera.width, camera.height, nullptr));
}

}  // namespace core
