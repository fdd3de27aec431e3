// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/reshade_pass.h"

#include "kernels/reshade.h"
#include "render/kernels/kernels.h"
#include "shaders/brdf/measured.h"

namespace render {

ReshadePass::ReshadePass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout) : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "reshade",
                         {{RESHADE_SHADING, ReadOnlyStorageBuffer},
                          {RESHADE_DROPPED, StorageBuffer},
                          {RESHADE_PIXELS, ReadOnlyStorageBuffer},
                          {RESHADE_ACCUMULATION, ReadWriteStorageTexture},
                          {RESHADE_COUNT, ReadWriteStorageTexture},
                          {RESHADE_DRIVES, ReadOnlyStorageBuffer},
                          {RESHADE_DRIVE_VALUES, ReadOnlyStorageBuffer},
                          {MEASURED_TABLES, ReadOnlyStorageBuffer}});
    pipeline_ = BrdfPipeline(device, "reshade", reshade_spv, {geometryLayout, layout_}, sizeof(kernel::ReshadeBlock));
}

gpu::BindGroup ReshadePass::bind(const PathInputs& inputs, const PixelList& pixels, const Targets& targets) const {
    return device_.createBindGroup(
        {.label = "reshade",
         .layout = layout_,
         .entries = {{.binding = RESHADE_SHADING, .buffer = inputs.shading},
                     {.binding = RESHADE_DROPPED, .buffer = inputs.dropped},
                     {.binding = RESHADE_PIXELS, .buffer = pixels.buffer},
                     {.binding = RESHADE_ACCUMULATION, .textureView = targets.accumulation.createView()},
                     {.binding = RESHADE_COUNT, .textureView = targets.count.createView()},
                     {.binding = RESHADE_DRIVES, .buffer = inputs.drives},
                     {.binding = RESHADE_DRIVE_VALUES, .buffer = inputs.driveValues},
                     {.binding = MEASURED_TABLES, .buffer = inputs.measured}}});
}

void ReshadePass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                         const kernel::ReshadeBlock& block) const {
    recordList(encoder, "reshade", pipeline_.pipeline(), geometry, group, block, block.pixelCount);
}

}  // namespace render
