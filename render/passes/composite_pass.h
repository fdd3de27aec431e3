// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/device.h"
#include "render/passes/segment_targets.h"
#include "render/scene_geometry.h"
#include "shaders/shared/composite_block.h"

namespace render {

/// Records the blend of one segment's new radiance with the photograph (shaders/composite.comp).
class CompositePass {
  public:
    CompositePass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    [[nodiscard]] gpu::BindGroup bind(const PathInputs& inputs, const PixelList& pixels, const Targets& targets) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                const kernel::CompositeBlock& block) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
