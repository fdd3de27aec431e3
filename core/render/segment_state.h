// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/drives.h"
#include "core/material.h"
#include "core/render/passes/filter_pass.h"
#include "core/render/passes/segment_targets.h"
#include "core/render/passes/translucency_pass.h"
#include "shaders/shared/path.h"

namespace render {

/// A drive as far as sums depend on it: not where its values lie on the device.
struct DriveKey {
    std::uint16_t label = 0;
    kernel::Drive drive;
    std::shared_ptr<const void> source;  ///< mask or detail
};

/// Of all segments, or with `only` those its own paths follow; `shading` by label, with the ranges of `table`.
[[nodiscard]] std::vector<DriveKey> driveKeys(const core::Scene& scene, std::span<const kernel::SegmentShading> shading,
                                              const core::DriveTable& table, const core::Segment* only);

/// Everything a sum depends on. A sum is restarted exactly when the key it was begun with is no longer the key.
struct SumKey {
    std::vector<kernel::SegmentShading> shading;  ///< own BRDF only with one bounce, all segments with more
    std::vector<DriveKey> drives;                 ///< of the same segments
    std::uint32_t seed = 0;
    int bounces = 0;
    int surfaceSamples = 0;     ///< light on surface samples only
    int irradianceSamples = 0;  ///< light on surface samples only
    float eta = 0;              ///< light on surface samples only
    [[nodiscard]] bool same(const SumKey& other) const;
};

/// How far the work on one edited segment has come.
struct SegmentState {
    std::uint16_t label = 0;
    core::Material material;
    PixelList pixels;

    // Re-shading: whole sweeps over the pixels, and a partial one.
    SumKey reshadeKey;
    bool reshadeFresh = true;  ///< the sum has to be cleared first
    std::uint32_t samples = 0;
    std::uint32_t cursor = 0;  ///< pixels of the next sweep that are done
    gpu::BindGroup reshadeGroup;

    // Translucency: samples are lit first, then gathered in chunks; a chunk is swept over the pixels.
    SumKey irradianceKey;
    bool pointsStale = true;
    SurfacePoints points;
    gpu::Buffer dipole;
    kernel::DipoleParams dipoleParams;
    bool gatherFresh = true;
    std::uint32_t litPoints = 0;
    std::uint32_t litRays = 0;  ///< rays done for the slice of points in work
    std::uint32_t gathered = 0;
    std::uint32_t gatherCursor = 0;  ///< pixels of the next chunk that are done
    gpu::BindGroup irradianceGroup, gatherGroup;

    // Filter: steps over the pixels of a picture that stands still meanwhile.
    FilterPass::Groups filterGroups;
    bool filterBound = false;
    std::uint32_t filteredSamples = 0;  ///< samples in the filtered picture; 0 = none
    int filterStep = -1;                ///< -1: not filtering
    std::uint32_t filterCursor = 0;

    // Outline: pixels that show the segment in part.
    PixelList silhouette;
    gpu::BindGroup silhouetteGroup;

    gpu::BindGroup compositeGroup;
    bool compositeStale = true;

    [[nodiscard]] bool translucent() const { return material.translucency.has_value(); }
};

[[nodiscard]] bool same(const kernel::DipoleParams& a, const kernel::DipoleParams& b);

}  // namespace render
