// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/apple_depth.h"

#include <cmath>

#include "core/io/image_io.h"
#include "core/io/import/embedded_depth.h"

namespace core {

namespace {

constexpr const char* kPixelDataNamespace = "http://ns.apple.com/pixeldatainfo/1.0/";
constexpr const char* kAppleDepth = "http://ns.apple.com/depthData/1.0/";

/// The matrix is stored column by column.
std::optional<Camera> readCamera(const Xmp& xmp) {
    const std::vector<double> m = xmp.numbers(kAppleDepth, "IntrinsicMatrix");
    const auto width = xmp.number(kAppleDepth, "IntrinsicMatrixReferenceWidth");
    const auto height = xmp.number(kAppleDepth, "IntrinsicMatrixReferenceHeight");
    if (m.size() != 9 || !width || !height) return std::nullopt;
    if (!(*width >= 1 && *width <= kMaxImageSide && *height >= 1 && *height <= kMaxImageSide)) return std::nullopt;
    return Camera{static_cast<int>(*width), static_cast<int>(*height), static_cast<float>(m[0]),
                  static_cast<float>(m[4]), static_cast<float>(m[6]),  static_cast<float>(m[7])};
}

}  // namespace

bool isAppleDepth(const Xmp& xmp) {
    const auto type = xmp.text(kPixelDataNamespace, "AuxiliaryImageType");
    return type == "disparity" || type == "depth";
}

std::optional<AppleDepth> readAppleDepth(const ImportFile& file, const Xmp& xmp) {
    if (!isAppleDepth(xmp)) return std::nullopt;
    const auto type = xmp.text(kPixelDataNamespace, "AuxiliaryImageType");
    AppleDepth apple;
    if (type == "depth") apple.kind = DepthKind::Z;
    const auto least = xmp.number(kPixelDataNamespace, "FloatMinValue");
    const auto most = xmp.number(kPixelDataNamespace, "FloatMaxValue");
    if (!least || !most || !std::isfinite(*least) || !std::isfinite(*most) || !(*most > *least))
        file.fail(Message("messages", "its %1 image has no range, expected FloatMinValue < FloatMaxValue in the XMP")
                      .with(*type));
    apple.least = *least;
    apple.most = *most;
    apple.leastStored = xmp.number(kPixelDataNamespace, "IntMinValue").value_or(0);
    apple.mostStored = xmp.number(kPixelDataNamespace, "IntMaxValue").value_or(255);
    if (!(apple.mostStored > apple.leastStored))
        file.fail(
            Message("messages", "its %1 image has integers from IntMinValue %2 to IntMaxValue %3, expected a range")
                .with(*type, apple.leastStored, apple.mostStored));
    apple.camera = readCamera(xmp);
    apple.relative = xmp.text(kAppleDepth, "Accuracy") == "relative";
    return apple;
}

void setAppleDepth(ImportedPhoto& photo, const ImportFile& file, const AppleDepth& apple, ImageF stored,
                   int orientation) {
    const double scale = (apple.most - apple.least) / (apple.mostStored - apple.leastStored);
    for (float& value : stored.pixels())
        value = static_cast<float>(apple.least + (static_cast<double>(value) - apple.leastStored) * scale);
    photo.depth = std::move(stored);
    photo.kind = apple.kind;
    if (apple.relative)
        photo.remarks.push_back(
            Message("messages", "The camera states the depth inside \"%1\" as \"relative\": its scale is approximate.")
                .with(file.path()));
    if (apple.camera) setStoredCamera(photo, *apple.camera, orientation);
}

}  // namespace core
