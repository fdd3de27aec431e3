// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace core {

struct CreateOptions {
    std::string color;                   ///< photograph
    std::string depth;                   ///< "" = inside the colour file (core/io/import/import_format.h)
    DepthKind depthKind = DepthKind::Z;  ///< Z also where the colour file says what the depth inside it is
    /// Metres per stored unit; nullopt = as the colour file says of the depth inside it, else 1 for float files, 0.001
    /// for 16-bit integers. Other 8-bit files and integers that are no lengths (Disparity, Inverse) need it.
    std::optional<double> depthUnit;
    std::optional<Camera> intrinsics;  ///< fx, fy, cx, cy in pixels of the colour image
    std::optional<float> hfov;  ///< [rad]; with neither, as the file says: intrinsics, 35 mm equivalent; else 60°
    std::string segments;       ///< label map, 8 or 16 bit; "" = none
    std::vector<std::string> glossy;  ///< labels or names
};

/// Loads colour, depth and labels into a scene. Depth and labels may be smaller than the colour image if the shape
/// agrees within 2 %: they are enlarged by nearest neighbour, so that nothing is blended across an edge. Throws
/// Error(Input) naming the file, what was expected and what was found, and Error(Usage) for options that are out of
/// range or name labels that do not occur. `notes` receives sentences for the user about what was assumed.
[[nodiscard]] Scene createScene(const CreateOptions& options, Notes* notes = nullptr, const Progress& progress = {});

/// Stored depth values to planar z [m]; 0 where there is none: not finite, ≤ 0, or beyond kMaxDepth. `camera` has the
/// stored image's size. Kinds: see DepthKind; `unit` in metres.
[[nodiscard]] ImageF planarDepth(const ImageF& stored, DepthKind kind, double unit, const Camera& camera);
/// Farther than this [m] is no measurement: renderers write 1e10 for the sky.
inline constexpr float kMaxDepth = 10000.0f;

/// An environment for EnvironmentParams::image; latitude-longitude, width = 2·height. Throws Error(Input).
[[nodiscard]] std::shared_ptr<const ImageRgb> loadEnvironment(const std::string& path);
/// Measured back sides for Scene::backDepth: planar z in metres (16-bit integers: millimetres), 0 = none, of the
/// photograph's size or smaller. Throws Error(Input).
[[nodiscard]] std::shared_ptr<const ImageF> loadBackDepth(const std::string& path, const Camera& camera);

/// "z", "distance", "disparity", "inverse": the words of files and command line.
[[nodiscard]] const char* depthKindKey(DepthKind kind);
[[nodiscard]] std::optional<DepthKind> findDepthKind(std::string_view key);
/// "automatic", "offset", "parallel_mirror", ...: the word of project files and command line.
[[nodiscard]] const std::string& backSideMethodKey(BackSideMethod method);

/// Reads a `.patina` project (JSON; format in docs/project-format.md). Image paths are relative to the project file.
/// Unknown keys, wrong types and out-of-range values are errors that name the key. An edit whose BRDF's file cannot be
/// used is kept but shows the photograph (core::usable); a note says so.
[[nodiscard]] Scene loadProject(const std::string& path, Notes* notes = nullptr, const Progress& progress = {});

/// Writes atomically: a temporary file beside the target, flushed, then renamed; the old file survives any failure.
/// Painted masks are written first (core/io/mask_io.h).
void saveProject(const Scene& scene, const std::string& path);

/// One `--edit` value (docs/command-line.md) as JSON text to a material and back. Throws Error(Usage) naming the key.
[[nodiscard]] Material materialFromJson(const std::string& json);
[[nodiscard]] std::string materialToJson(const Material& material);

}  // namespace core
