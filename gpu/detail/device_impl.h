// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include "gpu/adapter.h"
#include "gpu/detail/instance_impl.h"
#include "gpu/detail/object.h"
#include "gpu/detail/pipeline_compiler.h"
#include "gpu/device.h"

namespace gpu::detail {

/// One allocation of device memory.
struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize size = 0;
    VkMemoryPropertyFlags flags = 0;
    bool counted = false;
};

/// A descriptor set and the pool it came from.
struct DescriptorSet {
    VkDescriptorSet set = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
};

/// Owns the Vulkan device (unless adopted), what is in flight on its queue, and the bookkeeping of lifetimes.
///
/// Completion is known in two ways: by the fence of a submission, and, for frames somebody else submits, by their slot
/// beginning again. Both release what the commands used and make callbacks ready; callbacks run from `runReady` only.
class DeviceImpl : public std::enable_shared_from_this<DeviceImpl> {
  public:
    struct Source {
        std::shared_ptr<InstanceImpl> instanceImpl;             ///< empty when adopted
        std::unique_ptr<ValidationListener> adoptedValidation;  ///< of an adopted instance
        VkInstance instance = VK_NULL_HANDLE;
        VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
        VkDevice device = VK_NULL_HANDLE;
        VkQueue queue = VK_NULL_HANDLE;
        std::uint32_t queueFamily = 0;
        bool owned = false;
        bool debugUtils = false;
        std::string label;
        DeviceLostCallback deviceLost;
    };

    explicit DeviceImpl(Source source);
    ~DeviceImpl();
    DeviceImpl(const DeviceImpl&) = delete;
    DeviceImpl& operator=(const DeviceImpl&) = delete;

    [[nodiscard]] VkDevice vk() const { return source_.device; }
    [[nodiscard]] VkPhysicalDevice physicalDevice() const { return source_.physicalDevice; }
    [[nodiscard]] const std::string& label() const { return source_.label; }
    [[nodiscard]] const AdapterInfo& info() const { return info_; }
    [[nodiscard]] const Limits& limits() const { return limits_; }
    [[nodiscard]] bool adopted() const { return !source_.owned; }
    [[nodiscard]] bool lost() const { return lost_; }
    [[nodiscard]] bool destroyed() const { return destroyed_; }
    [[nodiscard]] std::uint64_t allocatedBytes() const { return allocatedBytes_; }
    [[nodiscard]] std::uint32_t timestampBits() const { return timestampBits_; }
    [[nodiscard]] VkPipelineCache pipelineCache() const { return pipelineCache_; }
    [[nodiscard]] PipelineCompiler& compiler() { return compiler_; }

    /// Throws when the device is lost or destroyed.
    void requireUsable() const;
    /// Throws the Error a failed result means; notices a lost device.
    void check(VkResult result, const char* call, const std::string& label);

    // Error scopes.
    void pushErrorScope(ErrorFilter filter) { scopes_.push_back({filter, std::nullopt}); }
    std::optional<Error> popErrorScope();
    [[nodiscard]] bool wouldCapture(const Error& error) const;
    bool capture(const Error& error);
    /// Runs a call of the public interface: an error an open scope wants goes there, and the call returns an empty
    /// value.
    template <class F>
    auto guarded(F&& call) -> std::invoke_result_t<F> {
        try {
            requireUsable();
            return call();
        } catch (const Error& error) {
            if (!capture(error)) throw;
        }
        return std::invoke_result_t<F>();
    }

    // Lifetimes.
    void add(Object* object) { live_.insert(object); }
    void remove(Object* object) { live_.erase(object); }
    void destroy();

    // Memory.
    [[nodiscard]] Allocation allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags required,
                                      VkMemoryPropertyFlags preferred, bool counted, const std::string& what);
    void free(Allocation& allocation) noexcept;
    [[nodiscard]] DescriptorSet allocateDescriptorSet(VkDescriptorSetLayout layout, const std::string& label);

    // Commands.
    [[nodiscard]] VkCommandBuffer allocateCommandBuffer(const std::string& label);
    void freeCommandBuffer(VkCommandBuffer commandBuffer) noexcept;
    /// Writes and clears that run before the next submission or adopted frame.
    [[nodiscard]] CommandBufferImpl& pendingWrites();
    /// Room for `size` bytes in host memory the device can read, kept until the pending writes have run.
    struct Staging {
        BufferImpl* buffer = nullptr;
        VkDeviceSize offset = 0;
        std::byte* data = nullptr;
    };
    [[nodiscard]] Staging stage(VkDeviceSize size);
    void submit(const std::vector<std::shared_ptr<CommandBufferImpl>>& commandBuffers);
    void flushPendingWrites();
    /// Blocks while more than `bytes` of staged data have not reached the device.
    void limitStagedBytes(VkDeviceSize bytes);

    // Completion.
    void beginAdoptedFrame(std::uint32_t slot, std::shared_ptr<CommandBufferImpl> recording);
    /// Everything begun up to and including this slot's frame has completed.
    void completeSlot(std::uint32_t slot);
    void completeFrames(std::uint64_t number);
    /// `callback(true)` once these have completed, `callback(false)` if they never will.
    void whenDone(std::uint64_t submission, std::uint64_t frame, std::function<void(bool done)> callback);
    [[nodiscard]] std::uint64_t lastSubmission() const { return lastSubmitted_; }
    [[nodiscard]] std::uint64_t lastFrame() const { return lastFrame_; }
    void reclaim();
    void runReady();
    void waitIdle();

    // Debug labels.
    void setName(VkObjectType type, std::uint64_t handle, const std::string& name) const;
    void beginLabel(VkCommandBuffer commandBuffer, const std::string& label) const;
    void endLabel(VkCommandBuffer commandBuffer) const;
    void insertLabel(VkCommandBuffer commandBuffer, const std::string& label) const;

  private:
    struct Submission {
        std::uint64_t serial = 0;
        VkFence fence = VK_NULL_HANDLE;
        VkDeviceSize stagedBytes = 0;
        std::vector<std::shared_ptr<CommandBufferImpl>> commandBuffers;
    };
    struct Frame {
        std::uint64_t number = 0;
        std::vector<std::shared_ptr<CommandBufferImpl>> recordings;
    };
    struct Waiter {
        std::uint64_t serial = 0;
        std::uint64_t frame = 0;
        std::function<void(bool)> callback;
    };
    struct Scope {
        ErrorFilter filter;
        std::optional<Error> error;
    };

    void markLost(const std::string& message);
    void complete(CommandBufferImpl& recording);

    void wakeWaiters();
    void abandonAll();
    void releaseAll() noexcept;
    [[nodiscard]] VkFence acquireFence();

    Source source_;
    AdapterInfo info_;
    Limits limits_;
    std::uint32_t timestampBits_ = 0;
    VkPhysicalDeviceMemoryProperties memory_ = {};
    VkCommandPool commandPool_ = VK_NULL_HANDLE;
    VkPipelineCache pipelineCache_ = VK_NULL_HANDLE;
    PipelineCompiler compiler_;
    std::vector<VkDescriptorPool> descriptorPools_;
    std::vector<VkFence> freeFences_;

    std::unordered_set<Object*> live_;
    std::uint64_t allocatedBytes_ = 0;
    std::vector<Scope> scopes_;
    bool lost_ = false;
    bool destroyed_ = false;

    std::shared_ptr<CommandBufferImpl> pending_;
    std::shared_ptr<BufferImpl> stagingBlock_;
    VkDeviceSize stagingUsed_ = 0;
    VkDeviceSize pendingStagedBytes_ = 0;
    std::deque<Submission> inFlight_;
    std::uint64_t lastSubmitted_ = 0;
    std::uint64_t lastCompleted_ = 0;
    std::map<std::uint32_t, Frame> frames_;
    std::uint64_t lastFrame_ = 0;
    std::uint64_t lastCompletedFrame_ = 0;
    std::vector<Waiter> waiters_;
    std::deque<std::function<void()>> ready_;

    PFN_vkSetDebugUtilsObjectNameEXT setObjectName_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT cmdBeginLabel_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT cmdEndLabel_ = nullptr;
    PFN_vkCmdInsertDebugUtilsLabelEXT cmdInsertLabel_ = nullptr;
};

/// A non-dispatchable or dispatchable handle as a number, for labels.
template <class T>
[[nodiscard]] std::uint64_t handleNumber(T handle) {
    if constexpr (std::is_pointer_v<T>) {
        return static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(handle));
    } else {
        return handle;
    }
}

}  // namespace gpu::detail
