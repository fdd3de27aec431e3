// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/photo_contents.h"

#include <cmath>

#include "core/io/image_io.h"
#include "core/io/import/import_format.h"

namespace core {

namespace {

std::optional<float> fieldOfView(const ImageInfo& info) {
    if (!info.focal35mm) return std::nullopt;
    const double width = info.width * static_cast<double>(info.pixelAspect);
    return static_cast<float>(2 * std::atan(0.5 * width / focalInPixels(*info.focal35mm, width, info.height)));
}

}  // namespace

double focalInPixels(float focal35mm, double width, double height) {
    return static_cast<double>(focal35mm) * std::hypot(width, height) / kFilmDiagonal;
}

PhotoContents contentsOf(const PhotoFiles& files) {
    PhotoContents contents;
    contents.width = files.info.width;
    contents.height = files.info.height;
    contents.device = files.info.device;
    contents.hfov = fieldOfView(files.info);
    contents.depthWidth = files.depth.width();
    contents.depthHeight = files.depth.height();
    if (files.depthImported) {
        const ImportedPhoto& other = *files.depthImported;
        if (other.camera) contents.hfov = 2 * std::atan(0.5f * static_cast<float>(contents.width) / other.camera->fx);
        contents.kind = other.kind;
        contents.unit = other.unit;
        contents.unitStated = other.assumedUnit.empty();
    }
    if (!files.imported) return contents;
    const ImportedPhoto& photo = *files.imported;
    contents.device =
        photo.device.empty() && isImageFile(files.colorPath) ? readImageInfo(files.colorPath).device : photo.device;
    if (photo.camera) contents.hfov = 2 * std::atan(0.5f * static_cast<float>(contents.width) / photo.camera->fx);
    if (!files.hasDepth() || !files.depthPath.empty()) return contents;
    contents.depthPlace = Message("messages", findImportFormat(ImportFile(files.colorPath))->name);
    contents.kind = photo.kind;
    contents.unit = photo.unit;
    contents.unitStated = photo.assumedUnit.empty();
    return contents;
}

PhotoContents inspectPhoto(const std::string& path) { return contentsOf(readStoredDepth(path, {})); }

}  // namespace core
