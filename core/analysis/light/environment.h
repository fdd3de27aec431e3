// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/light/reflectance.h"
#include "core/analysis/step_context.h"

namespace core::analysis {

/// The distant light ([BRD14] section 3.4): colours of all glossy segments whose mirrored ray hits nothing, divided by
/// the segment's ρ, and distant pixels at their view directions. Where several know a texel the sharper and better
/// known one counts more; then the lobes are taken out again (`deconvolve`: the paper's assumption of high gloss is not
/// needed) and gaps are filled by `params.fill`, or, with a map of the user's to complete, from that. Distant pixels
/// beside a pixel with depth mix with it and do not count; nor do segments that show more than they mirror. What lies
/// over a support's continuation (`SegmentReflections::overSupport`) fills the map there, with coverage 0. Where no
/// segment mirrors the light, its place is taken by `lightFromShading`, with coverage 0.
[[nodiscard]] DirectionalMap recoverEnvironment(const Scene& scene, const Surface& front,
                                                const Image<std::uint8_t>& distant,
                                                std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                                std::span<const std::shared_ptr<const SegmentReflections>> reflections,
                                                const StepContext& context);

/// A map given by the user: turned about the camera's y axis (a positive angle moves its content to the right),
/// scaled, resampled to width = 2·height where it is not, to `rows` rows by area averages. Coverage 1
/// everywhere.
[[nodiscard]] DirectionalMap userEnvironment(const ImageRgb& image, float rotation, float scale, int rows,
                                             const Progress& progress);

inline constexpr int kMaxUserRows = 1024;  ///< rows of a map that takes the place of the recovered one

}  // namespace core::analysis
