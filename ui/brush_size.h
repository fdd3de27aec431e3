// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/scene/scene.h"

namespace ui {

/// Largest radius of a brush in a small picture, and without one [px].
inline constexpr float kLeastMaxBrushRadius = 500;

/// Largest radius of a brush [px]: half of the picture's longer side.
[[nodiscard]] inline float maxBrushRadius(const core::Scene& scene) {
    if (scene.photo == nullptr) return kLeastMaxBrushRadius;
    const core::Camera& camera = scene.photo->camera;
    return std::max(kLeastMaxBrushRadius, 0.5f * static_cast<float>(std::max(camera.width, camera.height)));
}

}  // namespace ui
