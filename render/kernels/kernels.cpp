// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/kernels.h"

#include <algorithm>
#include <utility>

#include "shaders/brdf/registry.h"
#include "shaders/shared/geometry_block.h"

namespace render {

ListGroups listGroups(std::uint32_t count, const gpu::Limits& limits) {
    const std::uint32_t groups = (count + kListGroupSize - 1) / kListGroupSize;
    const std::uint32_t x = std::min(groups, limits.maxComputeWorkgroupsPerDimension);
    return {.x = x, .y = x == 0 ? 1 : (groups + x - 1) / x};
}

BrdfPipeline::BrdfPipeline(const gpu::Device& device, std::string label, std::span<const std::uint32_t> code,
                           std::vector<gpu::BindGroupLayout> groups, std::uint32_t immediateSize)
    : device_(device),
      label_(std::move(label)),
      layout_(device.createPipelineLayout(
          {.label = label_, .bindGroupLayouts = std::move(groups), .immediateSize = immediateSize})),
      module_(device.createShaderModule({.label = label_, .code = code})) {}

void BrdfPipeline::use(std::uint32_t brdfs, bool driven, std::shared_ptr<const std::vector<std::uint32_t>> userCode) {
    if (userCode && userCode != userCode_) {
        std::erase_if(pipelines_, [](const auto& entry) { return entry.first.first >> BRDF_USER != 0; });
        userCode_ = std::move(userCode);
        userModule_ = device_.createShaderModule({.label = label_ + " with user BRDFs", .code = *userCode_});
    }
    chosen_ = {brdfs, driven};
    if (pipelines_.contains(chosen_)) return;
    pipelines_[chosen_] = device_.createComputePipelineAsync(
        {.label = label_,
         .layout = layout_,
         .module = brdfs >> BRDF_USER != 0 ? userModule_ : module_,
         .constants = {{"0", static_cast<double>(brdfs)}, {"1", driven ? 1.0 : 0.0}}});
}

gpu::ComputePipeline makePipeline(const gpu::Device& device, const std::string& label,
                                  std::span<const std::uint32_t> code, std::vector<gpu::BindGroupLayout> groups,
                                  std::uint32_t immediateSize) {
    const gpu::PipelineLayout layout = device.createPipelineLayout(
        {.label = label, .bindGroupLayouts = std::move(groups), .immediateSize = immediateSize});
    const gpu::ShaderModule module = device.createShaderModule({.label = label, .code = code});
    return device.createComputePipelineAsync({.label = label, .layout = layout, .module = module});
}

gpu::BindGroupLayout makeLayout(const gpu::Device& device, const std::string& label,
                                std::initializer_list<LayoutEntry> entries) {
    gpu::BindGroupLayoutDescriptor descriptor{.label = label};
    for (const LayoutEntry& entry : entries)
        descriptor.entries.push_back({.binding = entry.binding, .type = entry.type});
    return device.createBindGroupLayout(descriptor);
}

gpu::BindGroupLayout makeGeometryLayout(const gpu::Device& device) {
    using enum gpu::BindingType;
    return makeLayout(device, "geometry",
                      {{GEOMETRY_BLOCK, UniformBuffer},
                       {GEOMETRY_PYRAMID, SampledTexture},
                       {GEOMETRY_FRONT_PATCH, SampledTexture},
                       {GEOMETRY_BACK_PATCH, SampledTexture},
                       {GEOMETRY_FRONT_COLOR, SampledTexture},
                       {GEOMETRY_BACK_COLOR, SampledTexture},
                       {GEOMETRY_FRONT_NORMAL, SampledTexture},
                       {GEOMETRY_BACK_NORMAL, SampledTexture},
                       {GEOMETRY_ENVIRONMENT, SampledTexture},
                       {GEOMETRY_ENVIRONMENT_TABLE, ReadOnlyStorageBuffer}});
}

}  // namespace render
