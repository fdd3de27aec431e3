// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/in_flight.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "gpu/detail/command_buffer.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"

namespace gpu::detail {

namespace {

constexpr VkDeviceSize kStagingBlock = VkDeviceSize{1} << 20;

}  // namespace

void InFlight::createCommandPool() {
    VkCommandPoolCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT | VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    info.queueFamilyIndex = device_.queueFamily();
    device_.check(vkCreateCommandPool(device_.vk(), &info, nullptr, &commandPool_), "vkCreateCommandPool",
                  device_.label());
}

VkCommandBuffer InFlight::allocateCommandBuffer(const std::string& label) {
    VkCommandBufferAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = commandPool_;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commandBuffer = VK_NULL_HANDLE;
    device_.check(vkAllocateCommandBuffers(device_.vk(), &info, &commandBuffer), "vkAllocateCommandBuffers", label);
    device_.labels().setName(VK_OBJECT_TYPE_COMMAND_BUFFER, commandBuffer, label);
    return commandBuffer;
}

void InFlight::freeCommandBuffer(VkCommandBuffer commandBuffer) noexcept {
    if (commandPool_ != VK_NULL_HANDLE) vkFreeCommandBuffers(device_.vk(), commandPool_, 1, &commandBuffer);
}

CommandBufferImpl& InFlight::pendingWrites() {
    if (!pending_) pending_ = std::make_shared<CommandBufferImpl>(device_, "queue writes");
    return *pending_;
}

InFlight::Staging InFlight::stage(VkDeviceSize size) {
    // The largest texel: copies from buffers to images need it.
    constexpr VkDeviceSize kAlignment = 16;
    const VkDeviceSize offset = (stagingUsed_ + kAlignment - 1) / kAlignment * kAlignment;
    if (!stagingBlock_ || offset + size > stagingBlock_->size) {
        BufferDescriptor descriptor;
        descriptor.label = "staging";
        descriptor.size = std::max(size, kStagingBlock);
        descriptor.usage = BufferUsage::MapWrite | BufferUsage::CopySrc;
        stagingBlock_ = std::make_shared<BufferImpl>(device_, descriptor, true);
        stagingUsed_ = 0;
        return stage(size);
    }
    stagingUsed_ = offset + size;
    pendingStagedBytes_ += size;
    pendingWrites().keep(*stagingBlock_);
    return {stagingBlock_.get(), offset, stagingBlock_->host() + offset};
}

VkFence InFlight::acquireFence() {
    if (!freeFences_.empty()) {
        VkFence fence = freeFences_.back();
        device_.check(vkResetFences(device_.vk(), 1, &fence), "vkResetFences", device_.label());
        freeFences_.pop_back();
        return fence;
    }
    VkFenceCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VkFence fence = VK_NULL_HANDLE;
    device_.check(vkCreateFence(device_.vk(), &info, nullptr, &fence), "vkCreateFence", device_.label());
    return fence;
}

void InFlight::submit(const std::vector<std::shared_ptr<CommandBufferImpl>>& commandBuffers) {
    for (const auto& commandBuffer : commandBuffers) {
        require(!commandBuffer->submitted, "Command buffer ", quoted(commandBuffer->label()),
                " has been submitted already; record a new one.");
        commandBuffer->requireNothingMapped();
    }
    Submission submission;
    if (pending_) {
        pending_->end();
        submission.commandBuffers.push_back(pending_);
    }
    submission.commandBuffers.insert(submission.commandBuffers.end(), commandBuffers.begin(), commandBuffers.end());
    if (submission.commandBuffers.empty()) {
        reclaim();
        return;
    }
    submitToQueue(submission);
    submission.stagedBytes = std::exchange(pendingStagedBytes_, 0);
    submission.serial = ++lastSubmitted_;
    for (const auto& commandBuffer : submission.commandBuffers) commandBuffer->markSubmitted(submission.serial);
    submissions_.push_back(std::move(submission));
    reclaim();
}

void InFlight::submitToQueue(Submission& submission) {
    std::vector<VkCommandBuffer> handles;
    for (const auto& commandBuffer : submission.commandBuffers) handles.push_back(commandBuffer->vk);
    submission.fence = acquireFence();
    VkSubmitInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = static_cast<std::uint32_t>(handles.size());
    info.pCommandBuffers = handles.data();
    const VkResult result = vkQueueSubmit(device_.queue(), 1, &info, submission.fence);
    pending_.reset();
    if (result == VK_SUCCESS) return;
    freeFences_.push_back(submission.fence);
    device_.check(result, "vkQueueSubmit", device_.label());
}

void InFlight::flushPendingWrites() {
    if (pending_) submit({});
}

void InFlight::limitStagedBytes(VkDeviceSize bytes) {
    if (pendingStagedBytes_ > bytes / 2) flushPendingWrites();
    while (true) {
        VkDeviceSize staged = 0;
        for (const Submission& submission : submissions_) staged += submission.stagedBytes;
        if (staged <= bytes / 2 || submissions_.empty()) return;
        const VkFence fence = submissions_.front().fence;
        device_.check(vkWaitForFences(device_.vk(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
                      "vkWaitForFences", device_.label());
        reclaim();
    }
}

void InFlight::beginAdoptedFrame(std::uint32_t slot, std::shared_ptr<CommandBufferImpl> recording) {
    Frame& frame = frames_[slot];
    frame.number = ++lastFrame_;
    recording->frame = frame.number;
    frame.recordings = {std::move(recording)};
}

void InFlight::complete(CommandBufferImpl& recording) {
    for (auto& callback : recording.onCompleted) ready_.push_back(std::move(callback));
    recording.onCompleted.clear();
    recording.releaseUsed();
}

void InFlight::completeFrames(std::uint64_t number) {
    for (auto frame = frames_.begin(); frame != frames_.end();) {
        if (frame->second.number > number) {
            ++frame;
            continue;
        }
        const Frame done = std::move(frame->second);
        frame = frames_.erase(frame);
        for (const auto& recording : done.recordings) complete(*recording);
    }
    lastCompletedFrame_ = std::max(lastCompletedFrame_, number);
    wakeWaiters();
}

void InFlight::completeSlot(std::uint32_t slot) {
    if (const auto frame = frames_.find(slot); frame != frames_.end()) completeFrames(frame->second.number);
}

void InFlight::whenDone(std::uint64_t submission, std::uint64_t frame, std::function<void(bool done)> callback) {
    waiters_.push_back({submission, frame, std::move(callback)});
}

void InFlight::wakeWaiters() {
    std::vector<Waiter> waiting;
    for (Waiter& waiter : waiters_) {
        if (waiter.serial <= lastCompleted_ && waiter.frame <= lastCompletedFrame_) {
            ready_.push_back([callback = std::move(waiter.callback)] { callback(true); });
        } else {
            waiting.push_back(std::move(waiter));
        }
    }
    waiters_ = std::move(waiting);
}

void InFlight::reclaim() {
    while (!submissions_.empty()) {
        const VkResult status = vkGetFenceStatus(device_.vk(), submissions_.front().fence);
        if (status == VK_NOT_READY) break;
        device_.check(status, "vkGetFenceStatus", device_.label());
        const Submission submission = std::move(submissions_.front());
        submissions_.pop_front();
        freeFences_.push_back(submission.fence);
        lastCompleted_ = submission.serial;
        for (const auto& commandBuffer : submission.commandBuffers) complete(*commandBuffer);
    }
    wakeWaiters();
}

void InFlight::runReady() {
    const std::shared_ptr<DeviceImpl> self = device_.shared_from_this();
    // A callback may wait for more; what becomes ready meanwhile runs too, each callback once.
    while (!ready_.empty()) {
        const std::function<void()> callback = std::move(ready_.front());
        ready_.pop_front();
        callback();
    }
}

void InFlight::waitIdle() {
    flushPendingWrites();
    device_.check(vkQueueWaitIdle(device_.queue()), "vkQueueWaitIdle", device_.label());
    if (lastFrame_ > 0) completeFrames(lastFrame_ - 1);
    reclaim();
}

void InFlight::completeAll() {
    for (Submission& submission : submissions_) {
        for (const auto& commandBuffer : submission.commandBuffers) complete(*commandBuffer);
    }
    for (auto& [slot, frame] : frames_) {
        for (const auto& recording : frame.recordings) complete(*recording);
    }
}

void InFlight::abandon() {
    pending_.reset();
    stagingBlock_.reset();
    std::vector<Waiter> waiters = std::exchange(waiters_, {});
    for (Waiter& waiter : waiters) {
        ready_.push_back([callback = std::move(waiter.callback)] { callback(false); });
    }
}

void InFlight::discard() {
    std::vector<Submission> submissions(std::make_move_iterator(submissions_.begin()),
                                        std::make_move_iterator(submissions_.end()));
    submissions_.clear();
    for (Submission& submission : submissions) freeFences_.push_back(submission.fence);
    submissions.clear();
    frames_.clear();
}

void InFlight::discardCallbacks() {
    waiters_.clear();
    ready_.clear();
}

void InFlight::release() noexcept {
    pending_.reset();
    stagingBlock_.reset();
    frames_.clear();
    for (const Submission& submission : submissions_) vkDestroyFence(device_.vk(), submission.fence, nullptr);
    submissions_.clear();
    for (VkFence fence : freeFences_) vkDestroyFence(device_.vk(), fence, nullptr);
    freeFences_.clear();
    if (commandPool_ != VK_NULL_HANDLE) vkDestroyCommandPool(device_.vk(), commandPool_, nullptr);
    commandPool_ = VK_NULL_HANDLE;
}

}  // namespace gpu::detail
