// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"

namespace core {

struct CreateOptions {
    std::string color;  ///< photograph
    std::string depth;  ///< "" = no separate depth file
    DepthKind depthKind = DepthKind::Z;
    std::optional<double> depthUnit;   ///< metres per stored unit; nullopt = 1 for float files, 0.001 for 16-bit PNG
    std::optional<Camera> intrinsics;  ///< fx, fy, cx, cy in pixels of the colour image
    std::optional<float> hfov;         ///< [rad]; with neither, a 35 mm equivalent from the file or 60 degrees
    std::string segments;              ///< label map, 8 or 16 bit; "" = none
    std::vector<std::string> glossy;   ///< labels or names
};

/// Loads colour, depth and labels into a scene. Throws Error(Input) naming the file, what was expected and what was
/// found.
[[nodiscard]] Scene createScene(const CreateOptions& options);

/// Reads a `.patina` project (JSON; format in docs/project-format.md). Image paths are relative to the project file.
/// Unknown keys, wrong types and out-of-range values are errors that name the key.
[[nodiscard]] Scene loadProject(const std::string& path);

/// Writes atomically: a temporary file beside the target, flushed, then renamed; the old file survives any failure.
void saveProject(const Scene& scene, const std::string& path);

/// One `--edit` value (DESIGN section 5) as JSON text to a material and back. Throws Error(Usage) naming the key.
[[nodiscard]] Material materialFromJson(const std::string& json);
[[nodiscard]] std::string materialToJson(const Material& material);

}  // namespace core
