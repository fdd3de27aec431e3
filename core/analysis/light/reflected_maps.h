// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/light/mirror_rays.h"
#include "core/base/directional_map.h"

namespace core::analysis {

/// What the segment shows, averaged by mirrored direction. Coverage = sum of the pixels' sharpness.
struct ReflectedMaps {
    DirectionalMap all;               ///< L_S: pixels that mirror anything but the segment itself
    DirectionalMap missed;            ///< `SegmentReflections::missed`
    Image<std::uint8_t> overSupport;  ///< `SegmentReflections::overSupport`
    DirectionalMap pairReflected;     ///< unclipped pixels whose ray meets a true colour; coverage = their number
    DirectionalMap pairIncident;      ///< these true colours, in the same texels
};
[[nodiscard]] ReflectedMaps averageReflected(const ReflectanceInput& in, const TracedPixels& pixels,
                                             std::span<const Mirror> mirrors);

/// What arrives at the segment's centre, averaged by direction.
struct IncidentMaps {
    DirectionalMap known;    ///< true colours
    DirectionalMap guessed;  ///< back sides, glossy segments and outlines
};
[[nodiscard]] IncidentMaps averageIncident(const ReflectanceInput& in, std::span<const RayEnd> ends);

/// Copies the texels of `more` that are covered there and not in `map`.
/// Returns 1 where a texel was copied.
Image<std::uint8_t> addUnseen(const DirectionalMap& more, DirectionalMap& map);

}  // namespace core::analysis
