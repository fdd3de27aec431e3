// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/device.h"
#include "render/kernels/kernels.h"
#include "render/passes/segment_targets.h"
#include "render/scene_geometry.h"
#include "shaders/shared/reshade_block.h"

namespace render {

/// Records slices of the Monte Carlo re-shading (shaders/reshade.comp).
class ReshadePass {
  public:
    ReshadePass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    /// Sets the BRDFs that paths may meet, bit = id, and whether there are drives; to be called before `record`.
    void useBrdfs(std::uint32_t brdfs, bool driven, std::shared_ptr<const std::vector<std::uint32_t>> userCode) {
        pipeline_.use(brdfs, driven, std::move(userCode));
    }
    [[nodiscard]] gpu::BindGroup bind(const PathInputs& inputs, const PixelList& pixels, const Targets& targets) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                const kernel::ReshadeBlock& block) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    BrdfPipeline pipeline_;
};

}  // namespace render
