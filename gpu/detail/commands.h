// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "gpu/command_encoder.h"
#include "gpu/detail/bindings.h"
#include "gpu/detail/command_buffer.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/object.h"
#include "gpu/detail/usage_tracker.h"

namespace gpu::detail {

/// One use of a resource by a dispatch or a render pass.
struct ResourceUse {
    BufferImpl* buffer = nullptr;
    TextureImpl* texture = nullptr;
    std::uint32_t mipLevel = 0;
    Access access;
    std::uint32_t group = 0;
    std::uint32_t binding = 0;
};

/// Uses of one scope (a dispatch, a render pass). Checks WebGPU's rule that a resource written through one binding is
/// not read through another.
class UsageScope {
  public:
    void add(const ResourceUse& use) { uses_.push_back(use); }
    void requireNoConflict(const std::string& where) const;
    void record(CommandBufferImpl& commands) const;
    void clear() { uses_.clear(); }

  private:
    std::vector<ResourceUse> uses_;
};

/// Groups, dynamic offsets and immediates as they are set on a pass.
class BindingState {
  public:
    explicit BindingState(DeviceImpl& device) : device_(device) {}

    void setPipelineLayout(std::shared_ptr<PipelineLayoutImpl> layout);
    void setBindGroup(std::uint32_t index, const BindGroup& group, std::span<const std::uint32_t> dynamicOffsets,
                      CommandBufferImpl& commands);
    void setImmediates(std::uint32_t rangeOffset, const void* data, std::size_t size, const std::string& pass);
    /// Throws unless everything the pipeline needs is set and fits.
    void requireComplete(const std::string& pipeline) const;
    void collectUses(UsageScope& scope) const;

    /// Everything to bind, detached from this object.
    struct Snapshot {
        VkPipelineLayout layout = VK_NULL_HANDLE;
        struct Set {
            std::uint32_t index = 0;
            std::uint32_t dynamicCount = 0;
            VkDescriptorSet vk = VK_NULL_HANDLE;
        };
        std::vector<Set> sets;  // groups without entries are left out
        std::vector<std::uint32_t> dynamicOffsets;
        std::vector<std::byte> immediates;
        void record(VkCommandBuffer commandBuffer, VkPipelineBindPoint bindPoint) const;
    };
    [[nodiscard]] Snapshot snapshot() const;

  private:
    struct Slot {
        std::shared_ptr<BindGroupImpl> group;
        std::vector<std::uint32_t> dynamicOffsets;
    };

    DeviceImpl& device_;
    std::shared_ptr<PipelineLayoutImpl> layout_;
    std::vector<Slot> slots_;
    std::array<std::byte, kMaxImmediateSize> immediates_ = {};
    std::bitset<kMaxImmediateSize / 4> immediatesSet_;  ///< per word
};

class CommandEncoderImpl {
  public:
    CommandEncoderImpl(std::shared_ptr<DeviceImpl> device, std::string label,
                       std::shared_ptr<CommandBufferImpl> commands)
        : device_(std::move(device)), label_(std::move(label)), commands_(std::move(commands)) {}
    ~CommandEncoderImpl();
    CommandEncoderImpl(const CommandEncoderImpl&) = delete;
    CommandEncoderImpl& operator=(const CommandEncoderImpl&) = delete;

    /// Runs a recording call: throws when finished or when a pass is open. An error kept by a scope makes the encoder
    /// invalid, as in WebGPU: finish() fails.
    template <class F>
    auto record(F&& call) -> std::invoke_result_t<F> {
        return guardedCall([&] {
            requireOpen();
            require(!passOpen, "Encoder ", quoted(label_),
                    " has an open pass; end it before recording on the encoder.");
            return call();
        });
    }
    template <class F>
    auto guardedCall(F&& call) -> std::invoke_result_t<F> {
        return device_->guarded([&]() -> std::invoke_result_t<F> {
            try {
                return call();
            } catch (const Error& error) {
                if (device_->wouldCapture(error)) invalid_ = true;
                throw;
            }
        });
    }
    void requireOpen() const;
    std::shared_ptr<CommandBufferImpl> finish();

    [[nodiscard]] const std::shared_ptr<DeviceImpl>& device() const { return device_; }
    [[nodiscard]] const std::string& label() const { return label_; }
    [[nodiscard]] CommandBufferImpl& commands() const { return *commands_; }

    void writeTimestamp(QuerySetImpl& querySet, std::uint32_t index, VkPipelineStageFlagBits stage);
    /// Orders all later commands after all earlier ones. Software drivers write a timestamp only when they wait, so
    /// without a barrier it would include later dispatches.
    void executionBarrier();

    bool passOpen = false;
    int debugGroups = 0;

  private:
    std::shared_ptr<DeviceImpl> device_;
    std::string label_;
    std::shared_ptr<CommandBufferImpl> commands_;
    bool finished_ = false;
    bool invalid_ = false;
};

class ComputePassImpl {
  public:
    ComputePassImpl(std::shared_ptr<CommandEncoderImpl> encoder, const ComputePassDescriptor& descriptor);
    ~ComputePassImpl();
    ComputePassImpl(const ComputePassImpl&) = delete;
    ComputePassImpl& operator=(const ComputePassImpl&) = delete;

    void requireOpen() const;
    void prepareDispatch(const ResourceUse* indirect);
    void end();

    const std::shared_ptr<CommandEncoderImpl> encoder;
    const std::string label;
    std::shared_ptr<ComputePipelineImpl> pipeline;
    BindingState bindings;
    int debugGroups = 0;

  private:
    std::optional<PassTimestampWrites> timestampWrites_;
    UsageScope scope_;
    bool open_ = true;
};

class RenderPassImpl {
  public:
    struct Target {
        VkRenderPass renderPass = VK_NULL_HANDLE;
        VkFramebuffer framebuffer = VK_NULL_HANDLE;
        std::uint32_t width = 0;
        std::uint32_t height = 0;
        std::vector<VkClearValue> clearValues;
        std::vector<TextureFormat> formats;  // empty when external
        bool external = false;
        UsageScope attachments;
    };
    RenderPassImpl(std::shared_ptr<CommandEncoderImpl> encoder, std::string label, Target target,
                   std::optional<PassTimestampWrites> timestampWrites);
    ~RenderPassImpl();
    RenderPassImpl(const RenderPassImpl&) = delete;
    RenderPassImpl& operator=(const RenderPassImpl&) = delete;

    void requireOpen() const;
    void prepareDraw(bool indexed);
    void end();

    const std::shared_ptr<CommandEncoderImpl> encoder;
    const std::string label;
    std::shared_ptr<RenderPipelineImpl> pipeline;
    BindingState bindings;
    Target target;
    UsageScope scope;
    std::vector<std::function<void(VkCommandBuffer)>> recorded;
    std::unordered_set<std::uint32_t> vertexBuffers;
    bool indexBuffer = false;

  private:
    std::optional<PassTimestampWrites> timestampWrites_;
    bool open_ = true;
};

}  // namespace gpu::detail
