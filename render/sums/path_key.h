// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "render/shaded_scene.h"
#include "shaders/shared/drive.h"
#include "shaders/shared/path.h"

namespace render {

/// A drive as far as sums depend on it, regardless of where its values lie on the device.
struct DriveKey {
    std::uint16_t label = 0;
    kernel::Drive drive;
    std::shared_ptr<const void> source;  ///< mask or detail
    friend bool operator==(const DriveKey& a, const DriveKey& b);
};

/// Everything a sum over paths depends on.
struct PathKey {
    std::vector<kernel::SegmentShading> shading;  ///< of all segments the paths may meet or start on
    std::vector<DriveKey> drives;                 ///< of the same segments
    std::uint32_t seed = 0;
    int bounces = 0;
    friend bool operator==(const PathKey& a, const PathKey& b);
};

/// Key of paths that start on `segment` as the camera sees it. Weights of the camera's own surface do not matter to
/// paths of one bounce; they belong to the composite.
[[nodiscard]] PathKey cameraPathKey(const ShadedScene& scene, const core::Segment& segment);

/// Key of paths along which light enters the surface of a translucent segment. Its own BRDF does not matter to paths of
/// one bounce.
[[nodiscard]] PathKey enteringPathKey(const ShadedScene& scene);

/// The weights of `segment` that vary over its pixels.
[[nodiscard]] std::vector<DriveKey> blendDriveKeys(const ShadedScene& scene, const core::Segment& segment);

}  // namespace render
