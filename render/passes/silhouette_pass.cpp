// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/silhouette_pass.h"

#include "kernels/silhouette.h"
#include "render/kernels/kernels.h"

namespace render {

SilhouettePass::SilhouettePass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout)
    : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "silhouette",
                         {{SILHOUETTE_PIXELS, ReadOnlyStorageBuffer},
                          {SILHOUETTE_RESULT, ReadWriteStorageTexture},
                          {SILHOUETTE_DRIVES, ReadOnlyStorageBuffer},
                          {SILHOUETTE_DRIVE_VALUES, ReadOnlyStorageBuffer}});
    pipeline_ =
        makePipeline(device, "silhouette", silhouette_spv, {geometryLayout, layout_}, sizeof(kernel::SilhouetteBlock));
}

PixelList SilhouettePass::upload(const std::vector<core::SilhouettePixel>& pixels) const {
    const auto pack = [](int x, int y) { return static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16; };
    std::vector<kernel::MixedPixel> packed;
    packed.reserve(pixels.size());
    core::PixelBox bounds;
    for (const core::SilhouettePixel& p : pixels) {
        bounds.add({p.x, p.y});
        packed.push_back({.pixel = pack(p.x, p.y),
                          .source = pack(p.sourceX, p.sourceY),
                          .coverage = p.coverage,
                          .pad0 = 0,
                          .kept = {p.kept.x(), p.kept.y(), p.kept.z(), 0},
                          .keptOriginal = {p.keptOriginal.x(), p.keptOriginal.y(), p.keptOriginal.z(), 0}});
    }
    return {.buffer = makeBuffer(device_, "silhouette", gpu::BufferUsage::Storage, packed),
            .count = static_cast<std::uint32_t>(packed.size()),
            .bounds = bounds};
}

gpu::BindGroup SilhouettePass::bind(const PathInputs& inputs, const PixelList& pixels, const Targets& targets) const {
    return device_.createBindGroup(
        {.label = "silhouette",
         .layout = layout_,
         .entries = {{.binding = SILHOUETTE_PIXELS, .buffer = pixels.buffer},
                     {.binding = SILHOUETTE_RESULT, .textureView = targets.result.createView()},
                     {.binding = SILHOUETTE_DRIVES, .buffer = inputs.drives},
                     {.binding = SILHOUETTE_DRIVE_VALUES, .buffer = inputs.driveValues}}});
}

void SilhouettePass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                            const kernel::SilhouetteBlock& block) const {
    recordList(encoder, "silhouette", pipeline_, geometry, group, block, block.pixelCount);
}

}  // namespace render
