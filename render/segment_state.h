// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <span>
#include <vector>

#include "core/material/material.h"
#include "core/shading/drive_table.h"
#include "core/shading/silhouette.h"
#include "core/shading/surface_samples.h"
#include "render/passes/diffusion_pass.h"
#include "render/passes/filter_pass.h"
#include "render/passes/segment_targets.h"
#include "render/passes/translucency_pass.h"
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
    int surfaceSamples = 0;                                             ///< light on surface samples only
    int irradianceSamples = 0;                                          ///< light on surface samples only
    core::DiffusionQuality quality = core::DiffusionQuality::Standard;  ///< light on surface samples only
    float eta = 0;                                                      ///< light on surface samples only
    [[nodiscard]] bool same(const SumKey& other) const;
};

/// What a translucent segment needs before light enters it.
struct SurfaceGrids {
    core::SurfaceSamples surface;
    core::DiffusionGrid grid;
};
[[nodiscard]] SurfaceGrids makeSurfaceGrids(const core::Photo& photo, const core::Analysis& analysis,
                                            std::uint16_t label, const core::RenderParams& params);

/// What has to be found of a segment before its first slice.
struct SegmentPixels {
    std::vector<std::uint32_t> list;  ///< x | y << 16, in the order of a sweep
    PixelBounds bounds;
    std::vector<core::SilhouettePixel> outline;
};
/// `edited`: as core::findSilhouette.
[[nodiscard]] SegmentPixels findSegmentPixels(const core::Photo& photo, const core::ImageF& depth, std::uint16_t label,
                                              const std::vector<std::uint8_t>& edited, core::CoverageFrom from);

/// Part of a pixel list.
struct PixelRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// How far the work on one edited segment has come.
struct SegmentState {
    std::uint16_t label = 0;
    core::Material material;

    // Found on another thread.
    bool pixelsStale = true;
    std::future<SegmentPixels> pendingPixels;  ///< valid while that lasts
    PixelList pixels;

    // Re-shading: whole sweeps over the pixels, and a partial one.
    SumKey reshadeKey;
    std::uint32_t samples = 0;
    std::uint32_t sweepStart = 0;  ///< where in the list the sweep in work began; it goes on at the list's begin
    std::uint32_t cursor = 0;      ///< pixels of the sweep in work that are done
    std::uint32_t reached =
        0;  ///< pixels, from the list's begin on, that have ever had a sum; others show the photograph
    gpu::BindGroup reshadeGroup;

    // Translucency: samples are lit in order. With a 64th, an eighth and all of them the grids take in their light
    // and it is summed onto all pixels.
    SumKey irradianceKey;
    bool pointsStale = true;
    std::future<SurfaceGrids> pendingPoints;  ///< valid while they are being made, on another thread
    SurfacePoints points;                     ///< none meanwhile
    core::Translucency scattering;            ///< what the sum depends on: the material's without its weight
    core::SurfaceSamples surface;
    DiffusionGrids grids;
    core::DiffusionKernel diffusionKernel;
    gpu::BindGroup irradianceGroup;
    bool diffusionFresh = true;  ///< what is in the picture is of other light and has to be cleared first
    std::uint32_t litPoints = 0;
    std::uint32_t litRays = 0;               ///< rays done for the slice of points in work
    std::uint32_t gridPoints = 0;            ///< samples whose light is in the grids
    std::size_t smoothedFrom = 0;            ///< levels from this one on are smooth
    std::uint32_t gatherTarget = 0;          ///< samples in the sum in work; 0 = none in work
    std::vector<DiffusionStep> gatherSteps;  ///< of it
    std::size_t lightSteps = 0;              ///< the first of them: they take in light
    std::size_t smoothSteps = 0;             ///< with the following, which smooth it
    std::size_t gatherStep = 0;
    std::uint32_t gatherCursor = 0;  ///< items of the step that are done
    std::uint32_t gathered = 0;      ///< samples in the complete sum on show

    // Filter: steps over the pixels of a picture that stands still meanwhile.
    FilterPass::Groups filterGroups;
    bool filterBound = false;
    std::uint32_t filteredSamples = 0;  ///< samples in the filtered picture; 0 = none
    int filterStep = -1;                ///< -1: not filtering
    std::uint32_t filterCursor = 0;

    // Outline: pixels that show the segment in part.
    bool glossy = false;  ///< what they were found by
    PixelList silhouette;
    gpu::BindGroup silhouetteGroup;

    gpu::BindGroup compositeGroup;
    bool compositeStale = true;        ///< of all pixels
    std::vector<PixelRange> advanced;  ///< of these only: new since the last composite

    /// Begins a new sum. The sweep goes on where it stands, so that every pixel has its turn however often this
    /// happens; until then a pixel keeps the old sum.
    void restartReshade();
    /// Up to `units` pixels that the sweep in work takes next.
    [[nodiscard]] PixelRange nextPixels(std::uint64_t units) const;
    [[nodiscard]] bool translucent() const { return material.translucency.has_value(); }
    /// Samples a sum could have now that is worth showing; 0 = too few are lit.
    [[nodiscard]] std::uint32_t gatherable() const;
    /// Ends the sum in work, and makes the one on show old.
    void restartGather() { gatherTarget = gathered = 0; }
    /// Lights the samples anew.
    void restartLight();
};

}  // namespace render
