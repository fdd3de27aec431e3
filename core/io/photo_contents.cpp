// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/photo_contents.h"

#include <cmath>

#include "core/io/image_io.h"
#include "core/io/import/import_format.h"

namespace core {

namespace {

std::optional<float> fieldOfView(int width, int height, std::optional<float> focal35mm) {
    if (!focal35mm) return std::nullopt;
    const double focal = static_cast<double>(*focal35mm) * std::hypot(width, height) / kFilmDiagonal;
    return static_cast<float>(2 * std::atan(0.5 * width / focal));
}

}  // namespace

PhotoContents inspectPhoto(const std::string& path) {
    const ImportFile file(path);
    const ImportFormat* format = findImportFormat(file);
    PhotoContents contents;
    if (format == nullptr) {
        const ImageInfo info = readImageInfo(path);
        contents.width = info.width;
        contents.height = info.height;
        contents.device = info.device;
        contents.hfov = fieldOfView(info.width, info.height, info.focal35mm);
        return contents;
    }
    const ImportedPhoto photo = format->read(file);
    contents.width = photo.color.width();
    contents.height = photo.color.height();
    contents.device = photo.device.empty() && isImageFile(path) ? readImageInfo(path).device : photo.device;
    contents.hfov = fieldOfView(contents.width, contents.height, photo.focal35mm);
    if (photo.camera) contents.hfov = 2 * std::atan(0.5f * static_cast<float>(contents.width) / photo.camera->fx);
    if (photo.depth.empty()) return contents;
    contents.depthPlace = Message("messages", format->name);
    contents.depthWidth = photo.depth.width();
    contents.depthHeight = photo.depth.height();
    contents.kind = photo.kind;
    contents.unit = photo.unit;
    contents.unitStated = photo.assumedUnit.empty();
    return contents;
}

}  // namespace core
