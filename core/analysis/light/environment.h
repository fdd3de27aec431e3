// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/light/reflectance.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// The distant light ([BRD14] section 3.4): colours of all glossy segments whose mirrored ray hits nothing, divided by
/// the segment's ρ, and distant pixels at their view directions. Where several sources observe a texel, the sharper one
/// with more observations weighs more. Then the lobes are taken out again (`deconvolve`: the paper's assumption of high
/// gloss is not needed), and gaps are filled by `params.fill` or completed from the user's map, if there is one.
///
/// Not counted are distant pixels beside a pixel with depth, which mix with it, and segments that show more than they
/// mirror. What lies over a support's continuation (`SegmentReflections::overSupport`) fills the map there, with
/// coverage 0. If no segment mirrors the light, `lightFromShading` fills the map, with coverage 0. Otherwise, and
/// without a user's map, the light is at least as strong as matt surfaces show it (`raiseToMattSurfaces`; `exactShape`:
/// the depth is exact and was not enlarged).
[[nodiscard]] DirectionalMap recoverEnvironment(const Scene& scene, const Surface& front,
                                                const Image<std::uint8_t>& distant, bool exactShape,
                                                std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                                std::span<const std::shared_ptr<const SegmentReflections>> reflections,
                                                const StepContext& context);

/// A map given by the user: turned about the camera's y axis by `rotation` [rad] (a positive angle moves its content to
/// the right), scaled, and resampled to `rows` rows and twice as many columns by area averages. Coverage 1 everywhere.
[[nodiscard]] DirectionalMap userEnvironment(const ImageRgb& image, float rotation, float scale, int rows,
                                             const Progress& progress);

/// Maximum number of rows of a user's map that replaces the recovered one.
inline constexpr int kMaxUserRows = 1024;

}  // namespace core::analysis
