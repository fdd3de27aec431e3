// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/analysis.h"
#include "render/analysis/march_rays.h"

namespace render {

/// How often builds and marches are timed, ours as well as Embree's; the least counts: a run takes some hundredths of a
/// second, and other programs have times of their own.
inline constexpr int kTimedBuilds = 10;
inline constexpr int kTimedMarches = 50;

/// A triangle ray tracer over the same two layers: what the marching is compared with.
struct EmbreeTimes {
    double buildSeconds = 0;   ///< triangles and hierarchy
    double raysPerSecond = 0;  ///< all cores, nearest hits
    double hitShare = 0;       ///< of the rays that hit anything
};

/// Traces `rays` against both layers as triangles: neighbouring pixel centres of one segment are joined, outlines are
/// closed by walls between front and back. nullopt in a build without Embree.
[[nodiscard]] std::optional<EmbreeTimes> benchEmbree(const core::Surface& front, const core::Surface& back,
                                                     const core::LabelImage& labels, const std::vector<Ray>& rays);

}  // namespace render
