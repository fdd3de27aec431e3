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
    core::DiffusionGrid grid;  ///< without its lists, which are only on the device
    std::uint32_t pixelCount = 0;
    gpu::Buffer places;  ///< vec4 per sample: position, area
    gpu::BindGroup splat, restrict, toNarrow, toWide, combine, gather;
};

/// One step of a sum: a kernel over a range of items.
struct DiffusionStep {
    enum class Kernel : std::uint8_t { Splat, Restrict, Smooth, Combine, Gather };
    Kernel kernel = Kernel::Splat;
    std::uint32_t first = 0;  ///< brick, or pixel of `Gather`
    std::uint32_t count = 0;
    std::uint32_t level = 0;                  ///< for `Combine` and `Gather`
    gpu::BindGroup DiffusionGrids::*group{};  ///< bindings of the kernel
};

/// Records the sum of light below a surface over all surface samples (core/shading/diffusion_grid.h):
/// shaders/diffusion_*.comp.
class DiffusionPass {
  public:
    DiffusionPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    /// `sums`: vec4 per sample, sum of transmitted radiance. The picture goes to `targets.diffusion`.
    [[nodiscard]] DiffusionGrids upload(core::DiffusionGrid grid, const gpu::Buffer& sums,
                                        const Targets& targets) const;

    /// Steps that bring the samples' light into the grids, to be recorded in order after `setAreas`.
    [[nodiscard]] static std::vector<DiffusionStep> lightSteps(const DiffusionGrids& grids);
    /// Steps that smooth the light of levels [first, last), once after the light steps.
    [[nodiscard]] static std::vector<DiffusionStep> smoothSteps(const DiffusionGrids& grids, std::size_t first,
                                                                std::size_t last);
    /// Steps that sum the smoothed light onto the pixels for a profile.
    [[nodiscard]] static std::vector<DiffusionStep> sumSteps(const DiffusionGrids& grids,
                                                             const core::DiffusionKernel& kernel);

    /// Sets the areas that the lit samples represent [m²]; the other samples count as dark.
    void setAreas(DiffusionGrids& grids, std::span<const float> areas) const;

    /// Records items [first, first + count) of a step. `rays`: rays per sample; `kernel`: of the profile.
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const DiffusionGrids& grids,
                const DiffusionStep& step, std::uint32_t first, std::uint32_t count, std::uint32_t rays,
                const core::DiffusionKernel& kernel) const;
    /// Marks all pixels as unknown.
    void recordClear(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const DiffusionGrids& grids) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout splatLayout_, restrictLayout_, smoothLayout_, combineLayout_, gatherLayout_;
    gpu::ComputePipeline splat_, restrict_, smooth_, combine_, gather_;
};

/// Memory accesses per item of a step, to which its cost is proportional.
[[nodiscard]] std::uint64_t accessesPerItem(DiffusionStep::Kernel kernel);

[[nodiscard]] const char* nameOf(DiffusionStep::Kernel kernel);

}  // namespace render
