// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "gpu/bind_group.h"
#include "gpu/buffer.h"
#include "gpu/command_encoder.h"
#include "gpu/error.h"
#include "gpu/handle.h"
#include "gpu/pipeline.h"
#include "gpu/query_set.h"
#include "gpu/queue.h"
#include "gpu/sampler.h"
#include "gpu/shader_module.h"
#include "gpu/texture.h"
#include "gpu/types.h"

struct VkCommandBuffer_T;

namespace gpu {

struct AdapterInfo;
struct AdoptDescriptor;  // gpu/adopt.h

using DeviceLostCallback = std::function<void(DeviceLostReason reason, std::string_view message)>;

struct DeviceDescriptor {
    std::string label = {};
    DeviceLostCallback deviceLost = {};  ///< called once, from the call that notices
};

/// A connection to an adapter; creates all other objects. Belongs to one thread at a time; different devices may be
/// used by different threads at once.
///
/// Every call may throw Error: Validation for a wrong argument (without any effect), OutOfMemory, DeviceLost.
/// While an error scope with a matching filter is open, the error goes to the scope instead and the call returns an
/// empty handle.
class Device : public Handle<detail::DeviceImpl> {
  public:
    using Handle::Handle;

    /// Wraps a Vulkan device that someone else (a QVulkanWindow) made and will destroy; see gpu/adopt.h.
    [[nodiscard]] static Device adopt(const AdoptDescriptor& descriptor);

    [[nodiscard]] Buffer createBuffer(const BufferDescriptor& descriptor) const;
    [[nodiscard]] Texture createTexture(const TextureDescriptor& descriptor) const;
    [[nodiscard]] Sampler createSampler(const SamplerDescriptor& descriptor = {}) const;
    [[nodiscard]] ShaderModule createShaderModule(const ShaderModuleDescriptor& descriptor) const;
    [[nodiscard]] BindGroupLayout createBindGroupLayout(const BindGroupLayoutDescriptor& descriptor) const;
    [[nodiscard]] BindGroup createBindGroup(const BindGroupDescriptor& descriptor) const;
    [[nodiscard]] PipelineLayout createPipelineLayout(const PipelineLayoutDescriptor& descriptor) const;
    [[nodiscard]] ComputePipeline createComputePipeline(const ComputePipelineDescriptor& descriptor) const;
    /// Same, compiled on another thread. A pass that uses it before it is ready waits, and throws the error of a failed
    /// compilation.
    [[nodiscard]] ComputePipeline createComputePipelineAsync(const ComputePipelineDescriptor& descriptor) const;
    /// Whether pipelines are being compiled on another thread.
    [[nodiscard]] bool compiling() const;
    [[nodiscard]] RenderPipeline createRenderPipeline(const RenderPipelineDescriptor& descriptor) const;
    [[nodiscard]] QuerySet createQuerySet(const QuerySetDescriptor& descriptor) const;
    [[nodiscard]] CommandEncoder createCommandEncoder(const CommandEncoderDescriptor& descriptor = {}) const;

    /// Wraps a command buffer that is being recorded (outside a render pass) and that its owner submits to the adopted
    /// queue. Call finish() on the encoder before that. `slot` is the frame-in-flight index: when the same slot
    /// begins again, everything recorded in it before has completed, and its callbacks, mappings and timestamps arrive.
    [[nodiscard]] CommandEncoder beginAdoptedFrame(VkCommandBuffer_T* commandBuffer, std::uint32_t slot) const;

    [[nodiscard]] Queue queue() const;
    [[nodiscard]] const AdapterInfo& adapterInfo() const;
    [[nodiscard]] const Limits& limits() const;
    [[nodiscard]] const std::string& label() const;
    /// Whether FilterMode::Linear works on textures of this format (not guaranteed for 32-bit floats).
    [[nodiscard]] bool supportsLinearFilter(TextureFormat format) const;
    /// Whether textures of this format can have this usage.
    [[nodiscard]] bool supportsUsage(TextureFormat format, TextureUsage usage) const;

    /// Checks for completed work and runs the callbacks waiting for it; never blocks.
    void tick() const;
    /// Blocks until all submitted work has completed, then runs callbacks like `tick`. Does not wait for the last
    /// adopted frame, which may not have been submitted yet.
    void waitIdle() const;

    /// Bytes of device memory held by living buffers and textures.
    [[nodiscard]] std::uint64_t allocatedBytes() const;

    /// Errors thrown by later calls that match `filter` are kept instead, until the scope is popped.
    void pushErrorScope(ErrorFilter filter) const;
    /// The first error the innermost scope caught, if any.
    [[nodiscard]] std::optional<Error> popErrorScope() const;

    [[nodiscard]] bool isLost() const;
    /// Waits for the device, then destroys every object made from it; remaining handles are dead, and using them is a
    /// validation error. For an adopted device this must happen before its owner destroys it.
    void destroy() const;
};

}  // namespace gpu
