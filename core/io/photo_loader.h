// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace core {

/// What is known about a photograph before its files are read; from the command line or a project file.
struct PhotoRequest {
    PhotoSource source;                ///< paths as they can be opened; `depthUnit` is ignored
    std::optional<double> depthUnit;   ///< nullopt = by the file's format, as in CreateOptions
    std::optional<Camera> intrinsics;  ///< only fx, fy, cx, cy are read
    std::optional<float> hfov;         ///< [rad]
};

/// Reads and fits together colour, depth and labels. Throws Error(Input), and Error(Usage) for a unit that has to be
/// given or intrinsics that cannot be.
[[nodiscard]] std::shared_ptr<const Photo> loadPhoto(const PhotoRequest& request, Notes* notes,
                                                     const Progress& progress = {});

}  // namespace core
