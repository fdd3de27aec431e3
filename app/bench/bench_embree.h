// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/analysis.h"
#include "render/analysis/march_rays.h"

namespace render {

/// Repetitions of builds and marches, ours as well as Embree's. The shortest counts, because a run takes some
/// hundredths of a second and other programs disturb it.
inline constexpr int kTimedBuilds = 10;
inline constexpr int kTimedMarches = 50;

/// Performance of a triangle ray tracer on the same two layers, for comparison with marching.
struct EmbreeTimes {
    double buildSeconds = 0;   ///< for triangles and hierarchy
    double raysPerSecond = 0;  ///< nearest hits on all cores
    double hitShare = 0;       ///< share of rays that hit anything
};

/// Traces `rays` against both layers as triangles: neighbouring pixel centres of one segment are joined, outlines are
/// closed by walls between front and back. nullopt in a build without Embree.
[[nodiscard]] std::optional<EmbreeTimes> benchEmbree(const core::Surface& front, const core::Surface& back,
                                                     const core::LabelImage& labels, const std::vector<Ray>& rays);

}  // namespace render
