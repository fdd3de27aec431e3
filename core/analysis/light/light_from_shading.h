// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/analysis/analysis.h"
#include "core/analysis/step.h"

namespace core::analysis {

/// A light estimated from the shading, without colour: broad, of radiance B(d) = mean·κ/sinh κ·exp(κ a·d). Where that
/// is more than `limit`, surroundings of radiance `limit` and a small lamp around a share it instead: what is diffuse
/// receives about the same, while a mirror shows surroundings as bright as the photograph and a highlight.
struct ShadingLight {
    Vector3f axis{0, -1, 0};                               ///< a: unit, towards the light, camera frame
    float concentration = 0;                               ///< κ ≥ 0; 0 = the same from everywhere
    float mean = 1;                                        ///< radiance averaged over the sphere
    float limit = std::numeric_limits<float>::infinity();  ///< ≥ mean

    /// Radiance from the unit direction `d`.
    [[nodiscard]] float radiance(const Vector3f& d) const;
};

/// The light where nothing in the photograph mirrors it. Pixels of one segment are taken to differ by their irradiance
/// E(n)/π = mean·(1 + v·n) and by texture, so v is fitted to log luminance with an unknown albedo per segment. The fit
/// is robust, and drawn weakly towards a light from above, which is all that is left when no segment is curved.
/// Brightness: the surfaces in a photograph reflect 18 % on average, as cameras meter it, and none reflects more than
/// 80 % of what falls on it. The surroundings are no brighter than the brightest surfaces. The light is white, because
/// photographs are white balanced. Radiance 1 from everywhere when the photograph has no light or no depth.
[[nodiscard]] ShadingLight lightFromShading(const Photo& photo, const Surface& front, const Progress& progress);

}  // namespace core::analysis
