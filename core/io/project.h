// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/io/moved_files.h"
#include "core/scene/scene.h"

namespace core {

struct PhotoFiles;
struct PhotoRequest;

struct CreateOptions {
    std::string color;                   ///< photograph
    std::string depth;                   ///< "" = inside the colour file (core/io/import/import_format.h), or none
    std::optional<DepthKind> depthKind;  ///< nullopt = as stated by the colour file, otherwise Z
    /// Metres per stored unit. nullopt = as stated by the colour file for depth inside it, otherwise 1 for floats and
    /// 0.001 for 16-bit integers. Required for 8-bit files and for integers that are not lengths (Disparity, Inverse).
    std::optional<double> depthUnit;
    std::optional<Camera> intrinsics;  ///< fx, fy, cx, cy in pixels of the colour image
    /// Horizontal field of view [rad]. With neither this nor intrinsics: the file's intrinsics, its 35 mm equivalent
    /// focal length, or 60°.
    std::optional<float> hfov;
    std::string segments;             ///< label map, 8 or 16 bit; "" = none
    std::vector<std::string> glossy;  ///< labels or names
};

/// Loads colour, depth and labels into a scene. Depth and labels may be smaller than the colour image if their shape
/// agrees within 2 %: labels are enlarged by nearest neighbour, depth as core/analysis/depth/upsample_depth.h says, so
/// that nothing is blended across an edge. A photograph without any depth becomes a scene whose depth is 0 everywhere.
/// Throws Error(Input) naming the file, what was expected and what was found,
/// and Error(Usage) for options that are out of range or name labels that do not occur. `notes` receives sentences for
/// the user about what was assumed.
[[nodiscard]] Scene createScene(const CreateOptions& options, Notes* notes = nullptr, const Progress& progress = {});
/// The same with the photograph's files already read, colour included. Only the labels are read.
[[nodiscard]] Scene createScene(const CreateOptions& options, const PhotoFiles& files, Notes* notes,
                                const Progress& progress = {});
/// What the options say about the photograph.
[[nodiscard]] PhotoRequest photoRequest(const CreateOptions& options);

/// Reads a `.patina` project (JSON; format in docs/project-format.md). Image paths are relative to the project file.
/// Unknown keys, wrong types and out-of-range values are errors that name the key. An edit whose BRDF's file cannot be
/// used is kept but shows the photograph (core::usable); a note says so. `moved` are files that are elsewhere by now.
[[nodiscard]] Scene loadProject(const std::string& path, Notes* notes = nullptr, const Progress& progress = {},
                                const MovedFiles& moved = {});
/// Larger files are refused.
inline constexpr std::size_t kMaxProjectBytes = std::size_t{64} << 20U;

/// Writes atomically: a temporary file beside the target, flushed, then renamed; the old file survives any failure.
/// Labels without a file and painted masks are written first (core/io/label_map.h, core/io/mask_io.h).
void saveProject(const Scene& scene, const std::string& path);

}  // namespace core
