// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/steps/reflectance.h"

namespace core::steps {

/// The distant light ([BRD14] section 3.4): colours of all glossy segments whose mirrored ray hits nothing, divided by
/// the segment's ρ, and distant pixels at their view directions; averaged, gaps filled by Shepard interpolation.
/// Distant pixels beside a pixel with depth mix with it and do not count. With nothing observed the map is the photo's
/// mean colour with coverage 0.
[[nodiscard]] DirectionalMap recoverEnvironment(const Photo& photo, const ImageF& depth, int mapHeight,
                                                std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                                std::span<const std::shared_ptr<const SegmentReflections>> reflections,
                                                const StepContext& context);

/// A map given by the user: turned about the camera's y axis (a positive angle moves its content to the right),
/// scaled, resampled to width = 2·height where it is not, and to at most 1024 rows by area averages. Coverage 1
/// everywhere.
[[nodiscard]] DirectionalMap userEnvironment(const ImageRgb& image, float rotation, float scale,
                                             const StepContext& context);

}  // namespace core::steps
