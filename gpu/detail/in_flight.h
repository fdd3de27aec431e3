// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gpu::detail {

class BufferImpl;
class CommandBufferImpl;
class DeviceImpl;

/// Work on its way through the queue, from recording to completion: command buffers, fences, staged data, callbacks.
///
/// Ownership: keeps every submitted command buffer, and through it whatever the commands use, until the work has
/// completed; dropping these references is what destroys objects whose handles are gone. Completion is known in two
/// ways: the fence of a submission passes, or, for adopted frames, which their owner submits, their slot begins again.
///
/// Threading: belongs to the thread of its device. Completion only makes callbacks ready; they run in `runReady`,
/// never inside the call that noticed the completion.
class InFlight {
  public:
    explicit InFlight(DeviceImpl& device) : device_(device) {}
    InFlight(const InFlight&) = delete;
    InFlight& operator=(const InFlight&) = delete;

    /// Call once, before anything is recorded.
    void createCommandPool();
    [[nodiscard]] VkCommandBuffer allocateCommandBuffer(const std::string& label);
    void freeCommandBuffer(VkCommandBuffer commandBuffer) noexcept;

    /// Writes and clears that run before the next submission or adopted frame.
    [[nodiscard]] CommandBufferImpl& pendingWrites();
    /// Room for `size` bytes in host memory the device can read, kept until the pending writes have run.
    struct Staging {
        BufferImpl* buffer = nullptr;
        VkDeviceSize offset = 0;  ///< [bytes] in `buffer`
        std::byte* data = nullptr;
    };
    [[nodiscard]] Staging stage(VkDeviceSize size);
    void submit(const std::vector<std::shared_ptr<CommandBufferImpl>>& commandBuffers);
    void flushPendingWrites();
    /// Blocks while more than `bytes` of staged data have not reached the device.
    void limitStagedBytes(VkDeviceSize bytes);

    void beginAdoptedFrame(std::uint32_t slot, std::shared_ptr<CommandBufferImpl> recording);
    /// Completes everything begun up to and including this slot's frame.
    void completeSlot(std::uint32_t slot);
    /// Calls `callback(true)` once these have completed, `callback(false)` if they never will.
    void whenDone(std::uint64_t submission, std::uint64_t frame, std::function<void(bool done)> callback);
    [[nodiscard]] std::uint64_t lastSubmission() const { return lastSubmitted_; }
    [[nodiscard]] std::uint64_t lastFrame() const { return lastFrame_; }
    /// Completes the submissions whose fences have passed.
    void reclaim();
    /// Runs the callbacks that are ready, including those that become ready meanwhile.
    void runReady();
    void waitIdle();

    // Shutting down, in this order. The device is idle.
    /// Makes the callbacks of everything recorded or submitted ready.
    void completeAll();
    /// Drops writes that were not submitted; waiting callbacks become ready with `false`. Also for a lost device.
    void abandon();
    /// Lets go of all command buffers.
    void discard();
    void discardCallbacks();
    /// Destroys all Vulkan objects.
    void release() noexcept;

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

    [[nodiscard]] VkFence acquireFence();
    void submitToQueue(Submission& submission);
    void complete(CommandBufferImpl& recording);
    void completeFrames(std::uint64_t number);
    void wakeWaiters();

    DeviceImpl& device_;
    VkCommandPool commandPool_ = VK_NULL_HANDLE;
    std::vector<VkFence> freeFences_;

    std::shared_ptr<CommandBufferImpl> pending_;
    std::shared_ptr<BufferImpl> stagingBlock_;
    VkDeviceSize stagingUsed_ = 0;
    VkDeviceSize pendingStagedBytes_ = 0;

    std::deque<Submission> submissions_;
    std::uint64_t lastSubmitted_ = 0;
    std::uint64_t lastCompleted_ = 0;

    std::map<std::uint32_t, Frame> frames_;  ///< adopted frames by slot
    std::uint64_t lastFrame_ = 0;
    std::uint64_t lastCompletedFrame_ = 0;

    std::vector<Waiter> waiters_;
    std::deque<std::function<void()>> ready_;
};

}  // namespace gpu::detail
