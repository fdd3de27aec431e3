// SPDX-License-Identifier: GPL-3.0-or-later
// Google's depth maps in the XMP of a JPEG (Lens Blur, portrait modes): properties Format, Near, Far and Data.
#include "core/io/image_io.h"
#include "core/io/import/embedded_depth.h"
#include "core/io/import/import_format.h"
#include "core/io/import/xmp.h"

namespace core {

namespace {

constexpr const char* kGoogleDepth = "http://ns.google.com/photos/1.0/depthmap/";
constexpr const char* kImage = "http://ns.google.com/photos/1.0/image/";

bool recognisesGdepth(const ImportFile& file) {
    return file.head().starts_with("\xff\xd8\xff") && readJpegXmp(file.bytes()).text(kGoogleDepth, "Format");
}

/// The picture before the camera's artificial blur if stored, otherwise the picture of the JPEG.
ImageRgb readColor(const ImportFile& file, const Xmp& xmp, int orientation) {
    const auto sharp = xmp.text(kImage, "Data");
    if (!sharp) return loadColor(file.path());
    return loadSharpPicture(embeddedImage(file, *sharp, Message("messages", "the sharp picture")), orientation);
}

ImportedPhoto readGdepth(const ImportFile& file) {
    Message damage;
    const Xmp xmp = readJpegXmp(file.bytes(), &damage);
    const auto data = xmp.text(kGoogleDepth, "Data");
    if (!data)
        file.fail(
            damage.empty()
                ? Message("messages", "its XMP has no GDepth:Data, expected the depth map that GDepth:Format announces")
                : damage);
    const ImageInfo info = readImageInfo(file.path());
    ImportedPhoto photo;
    photo.orientation = info.orientation;
    photo.focal35mm = info.focal35mm;
    photo.color = readColor(file, xmp, info.orientation);
    photo.depth = decodeRange(file, embeddedImage(file, *data, Message("messages", "the depth map")),
                              {xmp.text(kGoogleDepth, "Format").value_or(""), xmp.number(kGoogleDepth, "Near"),
                               xmp.number(kGoogleDepth, "Far")},
                              info.orientation);
    photo.kind = measuredKind(xmp.text(kGoogleDepth, "MeasureType"));
    setLengthUnit(photo, file, xmp.text(kGoogleDepth, "Units"));
    return photo;
}

}  // namespace

const ImportFormat jpegGdepthFormat{MESSAGE_TEXT("messages", "a Google depth map (GDepth) in a JPEG"), recognisesGdepth,
                                    readGdepth};

}  // namespace core
