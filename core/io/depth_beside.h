// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace core {

/// A depth map that lies beside a photograph and is named after it.
struct DepthBeside {
    std::string path;
    std::optional<DepthKind> kind;  ///< Disparity where the name says so
};

/// Looks in the photograph's folder: "vase_depth.png" or "depth_vase.exr" for "vase.jpg", "depth.png" for "rgb.png",
/// "7-depth.exr" for "7-color.jpg", and "depth.png" for the only photograph of a folder. EXR comes first, JPEG last.
/// nullopt when there is none, and for a photograph that is itself called a depth map. Reads names, no files.
[[nodiscard]] std::optional<DepthBeside> findDepthBeside(const std::string& color);

}  // namespace core
