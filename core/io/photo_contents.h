// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/io/photo_files.h"
#include "core/scene/scene.h"

namespace core {

/// What a photograph's file says about itself, for people who are about to open it.
struct PhotoContents {
    int width = 0;
    int height = 0;
    std::string device;         ///< maker and model of the camera; "" = not stated
    std::optional<float> hfov;  ///< horizontal field of view [rad], from intrinsics or the 35 mm focal length
    /// Where the depth is, "the auxiliary depth image of a HEIC file"; empty = not inside the photograph.
    Message depthPlace;
    int depthWidth = 0;  ///< of stored depth, inside or in its own file; 0 = there is none
    int depthHeight = 0;
    std::optional<DepthKind> kind;  ///< as stated
    double unit = 1;                ///< metres per stored unit
    bool unitStated = false;        ///< false: an assumption
};

/// Focal length [px] of a picture of this size [px] from that of a 35 mm camera with the same diagonal field of view
/// [mm].
[[nodiscard]] double focalInPixels(float focal35mm, double width, double height);

/// What was found in files that have been read, with the depth inside the photograph or that of a separate map.
[[nodiscard]] PhotoContents contentsOf(const PhotoFiles& files);

/// Looks into a photograph: reads the picture and the depth inside it. Throws Error(Input) as core::loadPhoto does; a
/// picture without depth is none.
[[nodiscard]] PhotoContents inspectPhoto(const std::string& path);

}  // namespace core
