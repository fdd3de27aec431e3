// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/io/import/import_format.h"
#include "core/io/import/xmp.h"

namespace core {

/// XMP of an auxiliary image of an Apple camera: pixeldatainfo and depthData.
struct AppleDepth {
    DepthKind kind = DepthKind::Disparity;  ///< Disparity [1/m] or Z [m]
    double leastStored = 0;                 ///< integers that stand for `least` and `most`
    double mostStored = 255;
    double least = 0;
    double most = 0;
    std::optional<Camera> camera;  ///< in the stored layout, at the size of the calibration
    bool relative = false;         ///< the camera does not vouch for the scale
};

/// Whether the XMP is that of a depth image.
[[nodiscard]] bool isAppleDepth(const Xmp& xmp);

/// nullopt when the XMP is not that of a depth image. Throws Error(Input) naming `file` when it is, but says nothing
/// usable.
[[nodiscard]] std::optional<AppleDepth> readAppleDepth(const ImportFile& file, const Xmp& xmp);

/// Completes `photo`, whose colour is there, by a depth image of stored integers. `orientation` turns the stored layout
/// into the displayed one, and has been applied to both images.
void setAppleDepth(ImportedPhoto& photo, const ImportFile& file, const AppleDepth& apple, ImageF stored,
                   int orientation);

}  // namespace core
