// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/shading/diffusion_grid.h"
#include "gpu/device.h"
#include "render/passes/segment_targets.h"
#include "render/scene_geometry.h"
#include "shaders/shared/diffusion_blocks.h"

namespace render {

/// The grids of one segment on the device.
struct DiffusionGrids {
    core::DiffusionGrid grid;  ///< without its lists, which are on the device
    std::uint32_t pixelCount = 0;
    gpu::Buffer places;  ///< vec4 per sample: place, area
    gpu::BindGroup splat, restrict, toNarrow, toWide, combine, gather;
};

/// One step of a sum: a kernel over a range of items.
struct DiffusionStep {
    enum class Kernel : std::uint8_t { Splat, Restrict, Smooth, Combine, Gather };
    Kernel kernel = Kernel::Splat;
    std::uint32_t first = 0;  ///< brick, or pixel of `Gather`
    std::uint32_t count = 0;
    std::uint32_t level = 0;                  ///< of `Combine` and `Gather`
    gpu::BindGroup DiffusionGrids::*group{};  ///< what the kernel works on
};

/// Records the sum of light below a surface over all surface samples (core/shading/diffusion_grid.h):
/// shaders/diffusion_*.comp.
class DiffusionPass {
  public:
    DiffusionPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    /// `sums`: vec4 per sample, sum of transmitted radiance. The picture goes to `targets.diffusion`.
    [[nodiscard]] DiffusionGrids upload(core::DiffusionGrid grid, const gpu::Buffer& sums,
                                        const Targets& targets) const;

    /// Steps that take in the light of samples; to be recorded in order. `setAreas` comes first.
    [[nodiscard]] static std::vector<DiffusionStep> lightSteps(const DiffusionGrids& grids);
    /// Steps that smooth the light of levels [first, last), once after `lightSteps`.
    [[nodiscard]] static std::vector<DiffusionStep> smoothSteps(const DiffusionGrids& grids, std::size_t first,
                                                                std::size_t last);
    /// Steps from there to the pixels for a profile.
    [[nodiscard]] static std::vector<DiffusionStep> sumSteps(const DiffusionGrids& grids,
                                                             const core::DiffusionKernel& kernel);

    /// What samples stand for [m²], as many as are lit; the others count as dark.
    void setAreas(DiffusionGrids& grids, std::span<const float> areas) const;

    /// Items [first, first + count) of a step; `rays` that samples were lit by, `kernel` of the profile.
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const DiffusionGrids& grids,
                const DiffusionStep& step, std::uint32_t first, std::uint32_t count, std::uint32_t rays,
                const core::DiffusionKernel& kernel) const;
    /// Marks all pixels as not known.
    void recordClear(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const DiffusionGrids& grids) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout splatLayout_, restrictLayout_, smoothLayout_, combineLayout_, gatherLayout_;
    gpu::ComputePipeline splat_, restrict_, smooth_, combine_, gather_;
};

/// Memory accesses of an item of a step: what its cost is in proportion to.
[[nodiscard]] std::uint64_t accessesPerItem(DiffusionStep::Kernel kernel);

[[nodiscard]] const char* nameOf(DiffusionStep::Kernel kernel);

}  // namespace render
