// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/composite_pass.h"

#include "kernels/composite.h"
#include "render/kernels/kernels.h"

namespace render {

CompositePass::CompositePass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout) : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "composite",
                         {{COMPOSITE_PIXELS, ReadOnlyStorageBuffer},
                          {COMPOSITE_ACCUMULATION, SampledTexture},
                          {COMPOSITE_COUNT, SampledTexture},
                          {COMPOSITE_FILTERED, SampledTexture},
                          {COMPOSITE_DIFFUSION, SampledTexture},
                          {COMPOSITE_RESULT, WriteOnlyStorageTexture},
                          {COMPOSITE_DRIVES, ReadOnlyStorageBuffer},
                          {COMPOSITE_DRIVE_VALUES, ReadOnlyStorageBuffer}});
    pipeline_ =
        makePipeline(device, "composite", composite_spv, {geometryLayout, layout_}, sizeof(kernel::CompositeBlock));
}

gpu::BindGroup CompositePass::bind(const PathInputs& inputs, const PixelList& pixels, const Targets& targets) const {
    return device_.createBindGroup(
        {.label = "composite",
         .layout = layout_,
         .entries = {{.binding = COMPOSITE_PIXELS, .buffer = pixels.buffer},
                     {.binding = COMPOSITE_ACCUMULATION, .textureView = targets.accumulation.createView()},
                     {.binding = COMPOSITE_COUNT, .textureView = targets.count.createView()},
                     {.binding = COMPOSITE_FILTERED, .textureView = targets.filtered.createView()},
                     {.binding = COMPOSITE_DIFFUSION, .textureView = targets.diffusion.createView()},
                     {.binding = COMPOSITE_RESULT, .textureView = targets.result.createView()},
                     {.binding = COMPOSITE_DRIVES, .buffer = inputs.drives},
                     {.binding = COMPOSITE_DRIVE_VALUES, .buffer = inputs.driveValues}}});
}

void CompositePass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                           const kernel::CompositeBlock& block) const {
    recordList(encoder, "composite", pipeline_, geometry, group, block, block.pixelCount);
}

}  // namespace render
