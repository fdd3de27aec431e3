// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gpu/bind_group.h"
#include "gpu/detail/descriptor_pools.h"
#include "gpu/detail/object.h"
#include "gpu/detail/resources.h"
#include "gpu/detail/spirv_reflect.h"
#include "gpu/pipeline.h"
#include "gpu/shader_module.h"

namespace gpu {

struct RenderPassColorAttachment;  // gpu/command_encoder.h

namespace detail {

class ShaderModuleImpl final : public Object {
  public:
    ShaderModuleImpl(DeviceImpl& device, const ShaderModuleDescriptor& descriptor);
    ~ShaderModuleImpl() override { release(); }
    void release() noexcept override;

    VkShaderModule vk = VK_NULL_HANDLE;
    Reflection reflection;
};

class BindGroupLayoutImpl final : public Object {
  public:
    BindGroupLayoutImpl(DeviceImpl& device, const BindGroupLayoutDescriptor& descriptor);
    ~BindGroupLayoutImpl() override { release(); }
    void release() noexcept override;

    [[nodiscard]] const BindGroupLayoutEntry* find(std::uint32_t binding) const;

    VkDescriptorSetLayout vk = VK_NULL_HANDLE;
    std::vector<BindGroupLayoutEntry> entries;  // by rising binding
    std::uint32_t dynamicCount = 0;
};

class BindGroupImpl final : public Object {
  public:
    BindGroupImpl(DeviceImpl& device, const BindGroupDescriptor& descriptor);
    ~BindGroupImpl() override { release(); }
    void release() noexcept override;

    struct Bound {
        BindGroupLayoutEntry entry;
        std::shared_ptr<BufferImpl> buffer;
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
        std::shared_ptr<TextureViewImpl> view;
        std::shared_ptr<SamplerImpl> sampler;
    };

    DescriptorSet set;
    std::shared_ptr<BindGroupLayoutImpl> layout;
    std::vector<Bound> bound;  // in the order of layout->entries

  private:
    void checkBuffer(const BindGroupEntry& given, Bound& bound);
    void checkTexture(const BindGroupEntry& given, Bound& bound);
    void write();
};

/// Stages that see the immediates of a pipeline layout: all, as in WebGPU.
inline constexpr VkShaderStageFlags kImmediateStages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;

class PipelineLayoutImpl final : public Object {
  public:
    PipelineLayoutImpl(DeviceImpl& device, std::string label,
                       std::vector<std::shared_ptr<BindGroupLayoutImpl>> bindGroupLayouts,
                       std::uint32_t immediateBytes);
    ~PipelineLayoutImpl() override { release(); }
    void release() noexcept override;

    VkPipelineLayout vk = VK_NULL_HANDLE;
    std::vector<std::shared_ptr<BindGroupLayoutImpl>> groups;
    std::uint32_t immediateSize = 0;
};

/// The layout that a pipeline's shaders need.
[[nodiscard]] std::shared_ptr<PipelineLayoutImpl> deriveLayout(DeviceImpl& device, const std::string& label,
                                                               const std::vector<const ShaderModuleImpl*>& modules);
/// Throws unless the layout offers what the module needs.
void requireLayoutFits(const PipelineLayoutImpl& layout, const ShaderModuleImpl& module, const std::string& pipeline);

/// Specialization constants in Vulkan's form. Not movable, because the form points into the object.
class Specialization {
  public:
    Specialization(const std::vector<ConstantEntry>& constants, const ShaderModuleImpl& module,
                   const std::string& pipeline);
    Specialization(const Specialization&) = delete;
    Specialization& operator=(const Specialization&) = delete;
    [[nodiscard]] const VkSpecializationInfo* info() const { return entries_.empty() ? nullptr : &info_; }
    [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& values() const { return values_; }

  private:
    std::map<std::uint32_t, std::uint32_t> values_;  // constant_id -> bits
    std::vector<VkSpecializationMapEntry> entries_;
    std::vector<std::uint32_t> data_;
    VkSpecializationInfo info_ = {};
};

[[nodiscard]] VkPipelineShaderStageCreateInfo stageInfo(const ShaderModuleImpl& module, VkShaderStageFlagBits stage,
                                                        const Specialization& specialization);
/// The module behind a handle; throws unless it is for this stage.
[[nodiscard]] ShaderModuleImpl& resolveModule(const ShaderModule& handle, const DeviceImpl& device, ShaderStage stage,
                                              const std::string& pipeline, const char* what);

class ComputePipelineImpl final : public Object {
  public:
    enum class Compile { Now, InBackground };
    ComputePipelineImpl(DeviceImpl& device, const ComputePipelineDescriptor& descriptor, Compile when);
    ~ComputePipelineImpl() override { release(); }
    void release() noexcept override;

    /// Waits while the pipeline is being compiled. Throws the error of a failed compilation.
    [[nodiscard]] VkPipeline compiled();

    std::shared_ptr<PipelineLayoutImpl> layout;
    std::array<std::uint32_t, 3> workgroupSize = {1, 1, 1};

  private:
    /// Input of the compiler; lives until compilation ends.
    struct Source {
        std::shared_ptr<ShaderModuleImpl> module;
        Specialization specialization;
    };
    void finish();

    VkPipeline vk_ = VK_NULL_HANDLE;
    std::unique_ptr<const Source> source_;
    std::future<VkResult> compiling_;  ///< valid until the result has been taken
    VkResult result_ = VK_SUCCESS;
};

class RenderPipelineImpl final : public Object {
  public:
    RenderPipelineImpl(DeviceImpl& device, const RenderPipelineDescriptor& descriptor);
    ~RenderPipelineImpl() override { release(); }
    void release() noexcept override;

    VkPipeline vk = VK_NULL_HANDLE;
    std::shared_ptr<PipelineLayoutImpl> layout;
    std::vector<TextureFormat> targets;  // empty with an external target
    bool external = false;
    std::uint32_t vertexBufferCount = 0;

  private:
    void create(const RenderPipelineDescriptor& descriptor, const ShaderModuleImpl& vertex,
                const ShaderModuleImpl& fragment);
};

/// A Vulkan render pass for attachments of these formats, all in GENERAL.
[[nodiscard]] VkRenderPass createRenderPass(DeviceImpl& device, const std::vector<TextureFormat>& formats,
                                            const std::vector<RenderPassColorAttachment>* attachments,
                                            const std::string& label);

}  // namespace detail

}  // namespace gpu
