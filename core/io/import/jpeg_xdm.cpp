// SPDX-License-Identifier: GPL-3.0-or-later
// eXtensible Device Metadata 1.0 in the XMP of a JPEG (Intel RealSense): cameras with depth maps and intrinsics.
#include <algorithm>
#include <cmath>

#include "core/io/image_io.h"
#include "core/io/import/embedded_depth.h"
#include "core/io/import/import_format.h"
#include "core/io/import/xmp.h"
#include "core/io/orientation.h"

namespace core {

namespace {

constexpr const char* kDevice = "http://ns.xdm.org/photos/1.0/device/";
constexpr const char* kCamera = "http://ns.xdm.org/photos/1.0/camera/";
constexpr const char* kXdmDepth = "http://ns.xdm.org/photos/1.0/depthmap/";
constexpr const char* kPerspective = "http://ns.xdm.org/photos/1.0/perspectivemodel/";
constexpr float kSaturated = 65535;  // RealSense: nothing measured

bool recognisesXdm(const ImportFile& file) {
    if (!file.head().starts_with("\xff\xd8\xff")) return false;
    const Xmp xmp = readJpegXmp(file.bytes());
    return !xmp.items(kDevice, "Cameras").empty() || xmp.has(kDevice, "Revision");
}

/// Focal lengths are in units of the longer image side, the principal point in those of each side.
std::optional<Camera> readCamera(const XmpNode& node, int width, int height) {
    const auto model = node.child(kCamera, "ImagingModel");
    if (!model) return std::nullopt;
    const auto fx = model->number(kPerspective, "FocalLengthX");
    const auto fy = model->number(kPerspective, "FocalLengthY");
    const auto cx = model->number(kPerspective, "PrincipalPointX");
    const auto cy = model->number(kPerspective, "PrincipalPointY");
    if (!fx || !fy || !cx || !cy) return std::nullopt;
    const double side = std::max(width, height);
    return Camera{width,
                  height,
                  static_cast<float>(*fx * side),
                  static_cast<float>(*fy * side),
                  static_cast<float>(*cx * width),
                  static_cast<float>(*cy * height)};
}

ImportedPhoto readXdm(const ImportFile& file) {
    Message damage;
    const Xmp xmp = readJpegXmp(file.bytes(), &damage);
    for (const XmpNode& camera : xmp.items(kDevice, "Cameras")) {
        const auto map = camera.child(kCamera, "DepthMap");
        const auto data = map ? map->text(kXdmDepth, "Data") : std::nullopt;
        if (!data) continue;
        const ImageInfo info = readImageInfo(file.path());
        ImportedPhoto photo;
        photo.orientation = info.orientation;
        photo.focal35mm = info.focal35mm;
        photo.color = loadColor(file.path());
        const DepthRange range{map->text(kXdmDepth, "Format").value_or(""), map->number(kXdmDepth, "Near"),
                               map->number(kXdmDepth, "Far")};
        photo.depth = decodeRange(file, embeddedImage(file, *data, Message("messages", "the depth map")), range,
                                  info.orientation);
        photo.kind = DepthKind::Z;
        const std::string metric = map->text(kXdmDepth, "Metric").value_or("");
        if (metric != "True" && metric != "true" && metric != "1") {
            const bool millimetres = range.near == 0.0 && range.far == static_cast<double>(kSaturated);
            if (millimetres) {
                photo.unit = 0.001;
                std::ranges::replace(photo.depth.pixels(), kSaturated, 0.0f);
            }
            photo.assumedUnit =
                (millimetres
                     ? Message("messages",
                               "The depth inside \"%1\" has no metric unit: 1 is taken as a millimetre. Give the "
                               "metres per unit to set another scale.")
                           .with(file.path())
                     : Message("messages",
                               "The depth inside \"%1\" has no metric unit: 1 is taken as a metre. Give the "
                               "metres per unit to set another scale.")
                           .with(file.path()))
                    .about(Setting::DepthUnit);
        }
        const bool transposed = info.orientation >= 5;
        if (const auto stored =
                readCamera(camera, transposed ? info.height : info.width, transposed ? info.width : info.height))
            photo.camera = orientCamera(*stored, info.orientation);
        return photo;
    }
    file.fail(damage.empty() ? Message("messages", "none of the cameras in its XMP (XDM) has a depth map") : damage);
}

}  // namespace

const ImportFormat jpegXdmFormat{MESSAGE_TEXT("messages", "a depth map of extensible device metadata (XDM) in a JPEG"),
                                 recognisesXdm, readXdm};

}  // namespace core
