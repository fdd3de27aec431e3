// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/io/image_io.h"
#include "core/io/import/import_format.h"

namespace core {

namespace {

bool recognisesExrDepth(const ImportFile& file) {
    return file.head().starts_with("\x76\x2f\x31\x01") && readImageInfo(file.path()).hasDepthChannel;
}

/// A renderer's picture: depth in its own unit, metres unless the user says otherwise.
ImportedPhoto readExrDepth(const ImportFile& file) {
    ImportedPhoto photo;
    photo.color = loadColor(file.path(), &photo.remarks);
    photo.clipLevel = std::numeric_limits<float>::infinity();
    photo.depth = loadScalar(file.path(), &photo.remarks);
    photo.coverage = loadCoverage(file.path());
    const ImageInfo info = readImageInfo(file.path());
    photo.focal35mm = info.focal35mm;
    photo.pixelAspect = info.pixelAspect;
    return photo;
}

}  // namespace

const ImportFormat exrDepthFormat{MESSAGE_TEXT("messages", "depth channel of an EXR file"), recognisesExrDepth,
                                  readExrDepth};

}  // namespace core
