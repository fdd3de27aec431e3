// SPDX-License-Identifier: GPL-3.0-or-later
// Dynamic Depth 1.0 (Android): pictures appended to a JPEG, listed in its XMP, one of them the depth map of a camera.
#include <cmath>
#include <string_view>

#include "core/io/image_io.h"
#include "core/io/import/embedded_depth.h"
#include "core/io/import/import_format.h"
#include "core/io/import/jpeg_segments.h"
#include "core/io/import/xmp.h"

namespace core {

namespace {

constexpr const char* kDynamicDevice = "http://ns.google.com/photos/dd/1.0/device/";
constexpr const char* kDynamicContainer = "http://ns.google.com/photos/dd/1.0/container/";
constexpr const char* kDynamicItem = "http://ns.google.com/photos/dd/1.0/item/";
constexpr const char* kDynamicCamera = "http://ns.google.com/photos/dd/1.0/camera/";
constexpr const char* kDynamicDepth = "http://ns.google.com/photos/dd/1.0/depthmap/";
constexpr const char* kDynamicImage = "http://ns.google.com/photos/dd/1.0/image/";
constexpr const char* kImagingModel = "http://ns.google.com/photos/dd/1.0/imagingmodel/";

std::vector<XmpNode> dynamicCameras(const Xmp& xmp) {
    std::vector<XmpNode> cameras;
    for (const XmpNode& item : xmp.items(kDynamicDevice, "Cameras"))
        cameras.push_back(item.child(kDynamicDevice, "Camera").value_or(item));
    return cameras;
}

bool recognisesDynamicDepth(const ImportFile& file) {
    if (!file.head().starts_with("\xff\xd8\xff")) return false;
    Message damage;
    const Xmp xmp = readJpegXmp(file.bytes(), &damage);
    for (const XmpNode& camera : dynamicCameras(xmp))
        if (camera.child(kDynamicCamera, "DepthMap")) return true;
    return !damage.empty() && xmp.has(kDynamicDevice, "Container");
}

/// A number of bytes, 0 when it is not given.
std::size_t byteCount(const ImportFile& file, const XmpNode& item, const char* name) {
    if (!item.text(kDynamicItem, name)) return 0;
    const double count = item.number(kDynamicItem, name).value_or(-1);
    if (!(count >= 0 && count <= static_cast<double>(file.bytes().size()) && std::floor(count) == count))
        file.fail(Message("messages", "Item:%1 in its XMP is \"%2\", expected a number of bytes within the file")
                      .with(name, item.text(kDynamicItem, name).value_or("")));
    return static_cast<std::size_t>(count);
}

/// The item `uri` of the container. The items follow the photograph one by one; those of length 0 share the bytes of
/// the item before.
EmbeddedImage containerImage(const ImportFile& file, const Xmp& xmp, const std::string& uri, const Message& what) {
    const std::string_view stream = file.bytes();
    const auto container = xmp.child(kDynamicDevice, "Container");
    const auto items = container ? container->items(kDynamicContainer, "Directory") : std::vector<XmpNode>();
    const auto end = jpegPictureEnd(stream);
    if (!end) file.fail(Message("messages", "the file is truncated: the photograph has no end"));
    std::size_t begin = 0;
    std::size_t length = *end;
    std::size_t next = *end;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const XmpNode item = items[i].child(kDynamicContainer, "Item").value_or(items[i]);
        const std::size_t stated = byteCount(file, item, "Length");
        if (i > 0 && stated > 0) {
            begin = next;
            length = stated;
            next += stated;
        }
        next += byteCount(file, item, "Padding");
        if (item.text(kDynamicItem, "DataURI") != uri) continue;
        if (begin > stream.size() || length > stream.size() - begin)
            file.fail(Message("messages", "the file is truncated: %1 lies beyond the end").with(what));
        const std::string_view picture = stream.substr(begin, length);
        const bool jpeg = picture.starts_with("\xff\xd8\xff");
        if (!(jpeg ? jpegPictureEnd(picture).has_value() : picture.starts_with("\x89PNG\r\n\x1a\n")))
            file.fail(Message("messages",
                              "%1 is not where the list in its XMP puts it, expected a whole JPEG or PNG picture in "
                              "%2 bytes from byte %3")
                          .with(what, length, begin));
        return {std::string(picture), Message("messages", "%1 inside \"%2\"").with(what, file.path())};
    }
    file.fail(Message("messages", "the list of pictures in its XMP has no \"%1\", expected %2").with(uri, what));
}

/// The picture before the camera's artificial blur if there is one, otherwise the picture of the JPEG.
ImageRgb dynamicColor(const ImportFile& file, const Xmp& xmp, int orientation) {
    for (const XmpNode& camera : dynamicCameras(xmp)) {
        const auto image = camera.child(kDynamicCamera, "Image");
        if (!image || image->text(kDynamicImage, "ItemSemantic") != "Original") continue;
        return loadSharpPicture(containerImage(file, xmp, image->text(kDynamicImage, "ItemURI").value_or(""),
                                               Message("messages", "the sharp picture")),
                                orientation);
    }
    return loadColor(file.path());
}

/// Intrinsics in pixels of a picture of the stated size, which need not be that of the file.
std::optional<Camera> imagingModel(const XmpNode& camera) {
    const auto model = camera.child(kDynamicCamera, "ImagingModel");
    if (!model) return std::nullopt;
    const auto width = model->number(kImagingModel, "ImageWidth");
    const auto height = model->number(kImagingModel, "ImageHeight");
    const auto fx = model->number(kImagingModel, "FocalLengthX");
    const auto fy = model->number(kImagingModel, "FocalLengthY");
    const auto cx = model->number(kImagingModel, "PrincipalPointX");
    const auto cy = model->number(kImagingModel, "PrincipalPointY");
    if (!width || !height || !fx || !fy || !cx || !cy) return std::nullopt;
    if (!(*width >= 1 && *width <= kMaxImageSide && *height >= 1 && *height <= kMaxImageSide)) return std::nullopt;
    return Camera{static_cast<int>(*width), static_cast<int>(*height), static_cast<float>(*fx),
                  static_cast<float>(*fy),  static_cast<float>(*cx),   static_cast<float>(*cy)};
}

ImportedPhoto readDynamicDepth(const ImportFile& file) {
    Message damage;
    const Xmp xmp = readJpegXmp(file.bytes(), &damage);
    bool segmentation = false;
    for (const XmpNode& camera : dynamicCameras(xmp)) {
        const auto map = camera.child(kDynamicCamera, "DepthMap");
        if (!map) continue;
        if (map->text(kDynamicDepth, "ItemSemantic") == "Segmentation") {
            segmentation = true;
            continue;
        }
        const ImageInfo info = readImageInfo(file.path());
        ImportedPhoto photo;
        photo.orientation = info.orientation;
        photo.focal35mm = info.focal35mm;
        photo.color = dynamicColor(file, xmp, info.orientation);
        photo.depth = decodeRange(file,
                                  containerImage(file, xmp, map->text(kDynamicDepth, "DepthURI").value_or(""),
                                                 Message("messages", "the depth map")),
                                  {map->text(kDynamicDepth, "Format").value_or(""), map->number(kDynamicDepth, "Near"),
                                   map->number(kDynamicDepth, "Far")},
                                  info.orientation);
        photo.kind = measuredKind(map->text(kDynamicDepth, "MeasureType"));
        setLengthUnit(photo, file, map->text(kDynamicDepth, "Units"));
        if (const auto stored = imagingModel(camera)) setStoredCamera(photo, *stored, info.orientation);
        return photo;
    }
    if (!damage.empty()) file.fail(damage);
    file.fail(segmentation
                  ? Message("messages",
                            "its depth map (Dynamic Depth) is a mask of the person in front (Segmentation), not depth")
                  : Message("messages", "none of the cameras in its XMP (Dynamic Depth) has a depth map"));
}

}  // namespace

const ImportFormat jpegDynamicDepthFormat{MESSAGE_TEXT("messages", "a depth map of Android (Dynamic Depth) in a JPEG"),
                                          recognisesDynamicDepth, readDynamicDepth};

}  // namespace core
