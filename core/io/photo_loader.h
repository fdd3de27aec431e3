// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/io/image_io.h"
#include "core/io/photo_files.h"
#include "core/scene/scene.h"

namespace core {

/// What the command line or a project file says about a photograph before its files are read.
struct PhotoRequest {
    PhotoSource source;                  ///< paths as they can be opened; kind and unit in it are ignored
    std::optional<DepthKind> depthKind;  ///< nullopt = as the file states, otherwise Z
    std::optional<double> depthUnit;     ///< nullopt = by the file's format, as in CreateOptions (project.h)
    std::optional<Camera> intrinsics;    ///< only fx, fy, cx, cy are read
    std::optional<float> hfov;           ///< [rad]
    /// Keep: each value of a mask with soft edges is a segment, as in projects of versions that did not know them.
    MaskEdges maskEdges = MaskEdges::Harden;
};

/// What the numbers of a photograph's files mean.
struct PhotoReading {
    PhotoSource source;  ///< with the kind and unit that were chosen
    Camera camera;       ///< of the colour
    ImageF depth;        ///< planar z [m] in the photograph's layout, at the stored resolution; empty = there is none
};

/// The first step of loading. `notes` receives what was assumed. Throws Error(Input) for depth without a valid pixel,
/// Error(Usage) for a unit that has to be given or intrinsics that cannot be.
[[nodiscard]] PhotoReading interpretPhoto(const PhotoFiles& files, const PhotoRequest& request, Notes* notes);

/// Reads and fits together colour, depth and labels. Throws Error(Input), and Error(Usage) as interpretPhoto does.
/// Without any depth all of it is 0, and a note says so.
[[nodiscard]] std::shared_ptr<const Photo> loadPhoto(const PhotoRequest& request, Notes* notes,
                                                     const Progress& progress = {});
/// The same with files that have been read, colour included; only the labels are read.
[[nodiscard]] std::shared_ptr<const Photo> loadPhoto(const PhotoFiles& files, const PhotoRequest& request, Notes* notes,
                                                     const Progress& progress = {});

/// Stored depth values to planar z [m]; 0 where there is none: not finite, ≤ 0, or beyond kMaxDepth. `camera` has the
/// stored image's size. Kinds: see DepthKind; `unit` in metres.
[[nodiscard]] ImageF planarDepth(const ImageF& stored, DepthKind kind, double unit, const Camera& camera);
/// Larger values [m] are not measurements: renderers write 1e10 for the sky.
inline constexpr float kMaxDepth = 10000.0f;

/// An environment for EnvironmentParams::image; latitude-longitude, width = 2·height. `notes` receives what was
/// repaired. Throws Error(Input).
[[nodiscard]] std::shared_ptr<const ImageRgb> loadEnvironment(const std::string& path, Notes* notes = nullptr);

/// Measured back sides for Scene::backDepth: planar z in metres (16-bit integers: millimetres), 0 = none, of the
/// photograph's size or smaller. Throws Error(Input).
[[nodiscard]] std::shared_ptr<const ImageF> loadBackDepth(const std::string& path, const Camera& camera);

/// A label map or mask for a photograph that is open already, of its size or smaller and of its shape. Throws
/// Error(Input).
[[nodiscard]] LabelImage loadLabelMap(const std::string& path, const Camera& camera, Notes* notes = nullptr);

}  // namespace core
