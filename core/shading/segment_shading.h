// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scene/scene.h"
#include "shaders/shared/path.h"

namespace core {

/// Shading of every label (index = label; label 0 and labels without a segment end paths). An edited segment uses its
/// material, a glossy unedited one GGX with its estimated width and ρ; both continue paths.
[[nodiscard]] std::vector<kernel::SegmentShading> buildSegmentShading(const Scene& scene, const Analysis& analysis);

/// 1 for every label whose segment is edited.
[[nodiscard]] std::vector<std::uint8_t> editedLabels(std::span<const kernel::SegmentShading> shading);

/// Specular colour of a segment when its material does not choose one: the user's ρ, the estimated one, or white.
[[nodiscard]] Vector3f specularOf(const Segment& segment, const Analysis& analysis);

/// Albedo of a translucent body for light reflected to other surfaces, at weight 1.
[[nodiscard]] Vector3f translucentAlbedo(const Translucency& translucency);

}  // namespace core
