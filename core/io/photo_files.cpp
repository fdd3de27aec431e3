// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/photo_files.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/statistics.h"
#include "core/io/import/camera_raw.h"
#include "core/io/orientation.h"

namespace core {

namespace {

constexpr double kShapeTolerance = 0.02;  ///< relative difference of width / height

std::string dimensions(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// True if a map can be scaled to the photograph: same shape within the tolerance.
bool fits(int width, int height, const Camera& camera) {
    const double ratio = static_cast<double>(width) * camera.height / (static_cast<double>(height) * camera.width);
    return std::abs(ratio - 1) <= kShapeTolerance;
}

ImageInfo importedInfo(const ImportedPhoto& photo) {
    ImageInfo info;
    info.width = photo.color.width();
    info.height = photo.color.height();
    info.orientation = photo.orientation;
    info.focal35mm = photo.focal35mm;
    info.pixelAspect = photo.pixelAspect;
    return info;
}

/// Photograph of a file that carries depth or that only an import format reads.
std::optional<ImportedPhoto> importPhoto(const std::string& color, const std::string& depth) {
    refuseCameraRaw(color);
    if (!depth.empty() && isImageFile(color)) return std::nullopt;
    const ImportFile file(color);
    const ImportFormat* format = findImportFormat(file);
    if (format == nullptr) return std::nullopt;
    return format->read(file);
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

/// The depth of another photograph, in the layout in which both are displayed. nullopt when `path` is a plain map; an
/// EXR file is read as one.
std::optional<ImportedPhoto> importDepth(const std::string& path) {
    const ImportFile file(path);
    const ImportFormat* format = findImportFormat(file);
    if (format == nullptr || format == &exrDepthFormat) return std::nullopt;
    ImportedPhoto photo = format->read(file);
    if (photo.depth.empty())
        file.fail(photo.remarks.empty()
                      ? Message("messages", "it is a photograph without depth, expected a depth map")
                      : Message("messages", "it is a photograph whose depth another program dropped"));
    photo.depth = withoutMixedDepth(std::move(photo.depth), photo.coverage);
    return photo;
}

/// The camera of a photograph whose pixels were resampled to this size.
Camera resized(const Camera& camera, int width, int height) {
    const float sx = static_cast<float>(width) / static_cast<float>(camera.width);
    const float sy = static_cast<float>(height) / static_cast<float>(camera.height);
    return {width, height, camera.fx * sx, camera.fy * sy, camera.cx * sx, camera.cy * sy};
}

bool isLength(DepthKind kind) { return kind == DepthKind::Z || kind == DepthKind::Distance; }

}  // namespace

template <class T>
Image<T> matchOrientation(Image<T> map, const std::string& path, const Message& what, const Camera& camera,
                          int mapOrientation, int colorOrientation, const Message& colorPath) {
    if (fits(map.width(), map.height(), camera)) return map;
    if (mapOrientation == 1 && colorOrientation >= 5 && fits(map.height(), map.width(), camera))
        return applyOrientation(std::move(map), colorOrientation);
    throw Error(
        ErrorKind::Input,
        Message("messages",
                "%1 size (%2) differs in shape from colour image size (%3); expected the same ratio of width to "
                "height.")
            .with(what, dimensions(map.width(), map.height()), dimensions(camera.width, camera.height)))
        .withContext(Message("messages", "While loading \"%1\" for \"%2\".").with(path, colorPath));
}
template ImageF matchOrientation(ImageF, const std::string&, const Message&, const Camera&, int, int, const Message&);
template LabelImage matchOrientation(LabelImage, const std::string&, const Message&, const Camera&, int, int,
                                     const Message&);

template <class T>
Image<T> resampleNearest(Image<T> image, const Camera& camera) {
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
template ImageF resampleNearest(ImageF, const Camera&);
template LabelImage resampleNearest(LabelImage, const Camera&);

namespace {

/// Nothing is left of a map's pixels between those of a smaller photograph.
ImageF reduceLarger(ImageF map, const std::string& path, const Camera& camera, Notes* remarks) {
    if (map.width() <= camera.width && map.height() <= camera.height) return map;
    if (remarks != nullptr)
        remarks->push_back(
            Message("messages", "\"%1\" (%2) is reduced to the colour image (%3).")
                .with(path, dimensions(map.width(), map.height()), dimensions(camera.width, camera.height)));
    return resampleNearest(std::move(map), camera);
}

}  // namespace

ImageF readMapFile(const std::string& path, const Camera& camera, int colorOrientation, const Message& colorPath,
                   const Message& what, Notes* remarks) {
    ImageF map = matchOrientation(loadScalar(path, remarks), path, what, camera, readImageInfo(path).orientation,
                                  colorOrientation, colorPath);
    return reduceLarger(std::move(map), path, camera, remarks);
}

PhotoFiles readStoredDepth(const std::string& color, const std::string& depth) {
    PhotoFiles files;
    files.colorPath = color;
    files.depthPath = depth;
    files.imported = importPhoto(color, depth);
    files.info = files.imported ? importedInfo(*files.imported) : readImageInfo(color);
    Camera camera;
    camera.width = files.info.width;
    camera.height = files.info.height;
    const Message what("messages", "Depth image");
    if (!depth.empty()) files.depthImported = importDepth(depth);
    if (files.depthImported) {
        ImportedPhoto& other = *files.depthImported;
        files.depth = reduceLarger(matchOrientation(std::move(other.depth), depth, what, camera, 1, 1, color), depth,
                                   camera, &files.depthRemarks);
        if (other.camera) other.camera = resized(*other.camera, camera.width, camera.height);
        other.color = {};
        other.depth = {};
        other.coverage = {};
    } else if (!depth.empty()) {
        files.depthFormat = storedFormat(depth);
        files.depth = readMapFile(depth, camera, files.info.orientation, color, what, &files.depthRemarks);
    } else if (files.imported && !files.imported->depth.empty()) {
        files.depth = matchOrientation(withoutMixedDepth(std::move(files.imported->depth), files.imported->coverage),
                                       color, what, camera, 1, 1, color);
        files.depth = reduceLarger(std::move(files.depth), color, camera, &files.depthRemarks);
    }
    if (!files.imported) return files;
    files.color = std::exchange(files.imported->color, {});
    files.imported->depth = {};
    files.imported->coverage = {};
    return files;
}

void readColor(PhotoFiles& files) {
    if (files.color.empty()) files.color = loadColor(files.colorPath, &files.colorRemarks);
}

bool needsUnit(const PhotoFiles& files, DepthKind kind) {
    if (files.depthPath.empty() || files.depthImported || files.depthFormat.floating) return false;
    return files.depthFormat.bits != 16 || !isLength(kind);
}

double unitForMedian(const PhotoFiles& files, DepthKind kind, double metres) {
    std::vector<float> values;
    for (const float value : files.depth.pixels())
        if (std::isfinite(value) && value > 0) values.push_back(value);
    if (values.empty()) return 1;
    const auto middle = static_cast<double>(median(values));
    return isLength(kind) ? metres / middle : metres * middle;
}

}  // namespace core
