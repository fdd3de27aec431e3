// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/device_impl.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <limits>
#include <utility>

#include "gpu/detail/commands.h"
#include "gpu/detail/resources.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu::detail {

namespace {

constexpr VkDeviceSize kStagingBlock = VkDeviceSize{1} << 20;
constexpr std::uint32_t kSetsPerPool = 64;

/// Asks for large pages, of 2 MB on most machines, where the device's memory is the process's own: with small ones,
/// most look-ups all over a large image also wait for their address. It is a hint; nothing depends on it.
void askForLargePages(VkDevice device, const Allocation& allocation) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21;
    if (allocation.size < 2 * kLargePage || (allocation.flags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) == 0) return;
    void* data = nullptr;
    if (vkMapMemory(device, allocation.memory, 0, VK_WHOLE_SIZE, 0, &data) != VK_SUCCESS) return;
    const auto begin = (reinterpret_cast<std::uintptr_t>(data) + kLargePage - 1) & ~(kLargePage - 1);
    const auto end = (reinterpret_cast<std::uintptr_t>(data) + allocation.size) & ~(kLargePage - 1);
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    vkUnmapMemory(device, allocation.memory);
#else
    (void)device;
    (void)allocation;
#endif
}

}  // namespace

Object::Object(DeviceImpl& device, std::string label) : device_(device), label_(std::move(label)) { device.add(this); }

Object::~Object() { device_.remove(this); }

DeviceImpl::DeviceImpl(Source source)
    : source_(std::move(source)),
      info_(describeAdapter(source_.physicalDevice)),
      limits_(queryLimits(source_.physicalDevice, source_.queueFamily)) {
    vkGetPhysicalDeviceMemoryProperties(source_.physicalDevice, &memory_);
    std::uint32_t familyCount = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(source_.physicalDevice, &familyCount, nullptr);
    std::vector<VkQueueFamilyProperties> families(familyCount);
    vkGetPhysicalDeviceQueueFamilyProperties(source_.physicalDevice, &familyCount, families.data());
    timestampBits_ = families.at(source_.queueFamily).timestampValidBits;

    if (source_.debugUtils) {
        const auto load = [&](const char* name) { return vkGetInstanceProcAddr(source_.instance, name); };
        setObjectName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(load("vkSetDebugUtilsObjectNameEXT"));
        cmdBeginLabel_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(load("vkCmdBeginDebugUtilsLabelEXT"));
        cmdEndLabel_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(load("vkCmdEndDebugUtilsLabelEXT"));
        cmdInsertLabel_ = reinterpret_cast<PFN_vkCmdInsertDebugUtilsLabelEXT>(load("vkCmdInsertDebugUtilsLabelEXT"));
    }
    setName(VK_OBJECT_TYPE_DEVICE, handleNumber(source_.device), source_.label);

    try {
        VkCommandPoolCreateInfo poolInfo = {};
        poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT | VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
        poolInfo.queueFamilyIndex = source_.queueFamily;
        check(vkCreateCommandPool(vk(), &poolInfo, nullptr, &commandPool_), "vkCreateCommandPool", source_.label);
        VkPipelineCacheCreateInfo cacheInfo = {};
        cacheInfo.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
        check(vkCreatePipelineCache(vk(), &cacheInfo, nullptr, &pipelineCache_), "vkCreatePipelineCache",
              source_.label);
    } catch (...) {
        releaseAll();
        throw;
    }
}

DeviceImpl::~DeviceImpl() {
    if (!destroyed_) {
        compiler_.stop();
        vkDeviceWaitIdle(vk());
        waiters_.clear();
        ready_.clear();
        releaseAll();
    }
}

void DeviceImpl::requireUsable() const {
    require(!destroyed_, "Device ", quoted(source_.label), " has been destroyed.");
    if (lost_) throw Error(ErrorKind::DeviceLost, text("Device ", quoted(source_.label), " is lost."));
}

void DeviceImpl::check(VkResult result, const char* call, const std::string& label) {
    if (result == VK_SUCCESS) return;
    const std::string message = text(call, " for ", quoted(label), " fails: ", toString(result), ".");
    switch (result) {
        case VK_ERROR_DEVICE_LOST:
            markLost(message);
            throw Error(ErrorKind::DeviceLost, message);
        case VK_ERROR_OUT_OF_HOST_MEMORY:
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        case VK_ERROR_TOO_MANY_OBJECTS:
        case VK_ERROR_OUT_OF_POOL_MEMORY:
        case VK_ERROR_MEMORY_MAP_FAILED:
            throw Error(ErrorKind::OutOfMemory, message);
        default:
            throw Error(ErrorKind::Internal, message);
    }
}

void DeviceImpl::markLost(const std::string& message) {
    if (lost_ || destroyed_) return;
    lost_ = true;
    abandonAll();
    if (const DeviceLostCallback callback = std::exchange(source_.deviceLost, nullptr)) {
        callback(DeviceLostReason::Unknown, message);
    }
}

std::optional<Error> DeviceImpl::popErrorScope() {
    require(!scopes_.empty(), "Device ", quoted(source_.label), " has no open error scope to pop.");
    std::optional<Error> error = std::move(scopes_.back().error);
    scopes_.pop_back();
    return error;
}

namespace {

bool matches(ErrorFilter filter, ErrorKind kind) {
    switch (filter) {
        case ErrorFilter::Validation:
            return kind == ErrorKind::Validation;
        case ErrorFilter::OutOfMemory:
            return kind == ErrorKind::OutOfMemory;
        case ErrorFilter::Internal:
            return kind == ErrorKind::Internal;
    }
    return false;
}

}  // namespace

bool DeviceImpl::wouldCapture(const Error& error) const {
    return std::any_of(scopes_.begin(), scopes_.end(),
                       [&](const Scope& scope) { return matches(scope.filter, error.kind()); });
}

bool DeviceImpl::capture(const Error& error) {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
        if (!matches(scope->filter, error.kind())) continue;
        if (!scope->error) scope->error = error;
        return true;
    }
    return false;
}

void DeviceImpl::abandonAll() {
    pending_.reset();
    stagingBlock_.reset();
    std::vector<Waiter> waiters = std::exchange(waiters_, {});
    for (Waiter& waiter : waiters) {
        ready_.push_back([callback = std::move(waiter.callback)] { callback(false); });
    }
}

void DeviceImpl::destroy() {
    if (destroyed_) return;
    compiler_.stop();
    vkDeviceWaitIdle(vk());
    for (Submission& submission : inFlight_) {
        for (const auto& commandBuffer : submission.commandBuffers) complete(*commandBuffer);
    }
    for (auto& [slot, frame] : frames_) {
        for (const auto& recording : frame.recordings) complete(*recording);
    }
    const std::shared_ptr<DeviceImpl> self = shared_from_this();
    runReady();  // what has been done can still be read
    if (destroyed_) return;
    vkDeviceWaitIdle(vk());
    abandonAll();
    std::vector<Submission> submissions(std::make_move_iterator(inFlight_.begin()),
                                        std::make_move_iterator(inFlight_.end()));
    inFlight_.clear();
    for (Submission& submission : submissions) freeFences_.push_back(submission.fence);
    submissions.clear();
    frames_.clear();
    for (Object* object : live_) object->release();
    releaseAll();
    destroyed_ = true;
    runReady();
    if (const DeviceLostCallback callback = std::exchange(source_.deviceLost, nullptr)) {
        callback(DeviceLostReason::Destroyed, text("Device ", quoted(source_.label), " has been destroyed."));
    }
}

void DeviceImpl::releaseAll() noexcept {
    pending_.reset();
    stagingBlock_.reset();
    frames_.clear();
    for (const Submission& submission : inFlight_) vkDestroyFence(vk(), submission.fence, nullptr);
    inFlight_.clear();
    for (VkFence fence : freeFences_) vkDestroyFence(vk(), fence, nullptr);
    freeFences_.clear();
    for (VkDescriptorPool pool : descriptorPools_) vkDestroyDescriptorPool(vk(), pool, nullptr);
    descriptorPools_.clear();
    if (pipelineCache_ != VK_NULL_HANDLE) vkDestroyPipelineCache(vk(), pipelineCache_, nullptr);
    if (commandPool_ != VK_NULL_HANDLE) vkDestroyCommandPool(vk(), commandPool_, nullptr);
    pipelineCache_ = VK_NULL_HANDLE;
    commandPool_ = VK_NULL_HANDLE;
    if (source_.owned) vkDestroyDevice(source_.device, nullptr);
    source_.device = VK_NULL_HANDLE;
    source_.adoptedValidation.reset();
}

Allocation DeviceImpl::allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags required,
                                VkMemoryPropertyFlags preferred, bool counted, const std::string& what) {
    std::uint32_t best = memory_.memoryTypeCount;
    int bestScore = -1;
    for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
        const VkMemoryPropertyFlags flags = memory_.memoryTypes[i].propertyFlags;
        if ((requirements.memoryTypeBits & (1u << i)) == 0 || (flags & required) != required) continue;
        const int score = (flags & preferred) == preferred ? 1 : 0;
        if (score > bestScore) {
            best = i;
            bestScore = score;
        }
    }
    if (best == memory_.memoryTypeCount) {
        throw Error(ErrorKind::OutOfMemory, text("The device has no kind of memory for ", what, "."));
    }
    const VkMemoryType& type = memory_.memoryTypes[best];
    const VkDeviceSize heap = memory_.memoryHeaps[type.heapIndex].size;
    if (requirements.size > heap) {
        throw Error(ErrorKind::OutOfMemory, text("There is no room for ", what, ": it needs ", requirements.size,
                                                 " bytes, the device's memory is ", heap,
                                                 " bytes and this device has allocated ", allocatedBytes_, "."));
    }
    VkMemoryAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = best;
    Allocation allocation{
        .memory = VK_NULL_HANDLE, .size = requirements.size, .flags = type.propertyFlags, .counted = counted};
    const VkResult result = vkAllocateMemory(vk(), &info, nullptr, &allocation.memory);
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY ||
        result == VK_ERROR_TOO_MANY_OBJECTS) {
        throw Error(ErrorKind::OutOfMemory,
                    text("There is no room for ", what, ": allocating ", requirements.size,
                         " bytes fails, and this device has allocated ", allocatedBytes_, " bytes."));
    }
    check(result, "vkAllocateMemory", what);
    if (info_.type == AdapterType::CPU) askForLargePages(vk(), allocation);
    if (counted) allocatedBytes_ += allocation.size;
    return allocation;
}

void DeviceImpl::free(Allocation& allocation) noexcept {
    if (allocation.memory == VK_NULL_HANDLE) return;
    vkFreeMemory(vk(), allocation.memory, nullptr);
    if (allocation.counted) allocatedBytes_ -= allocation.size;
    allocation = {};
}

DescriptorSet DeviceImpl::allocateDescriptorSet(VkDescriptorSetLayout layout, const std::string& label) {
    VkDescriptorSetAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    DescriptorSet set;
    // Newest first: that is where room is. A pool that is full says so; freed sets make room in old pools.
    for (auto pool = descriptorPools_.rbegin(); pool != descriptorPools_.rend(); ++pool) {
        info.descriptorPool = set.pool = *pool;
        const VkResult result = vkAllocateDescriptorSets(vk(), &info, &set.set);
        if (result == VK_SUCCESS) return set;
        if (result != VK_ERROR_OUT_OF_POOL_MEMORY && result != VK_ERROR_FRAGMENTED_POOL) {
            check(result, "vkAllocateDescriptorSets", label);
        }
    }
    constexpr VkDescriptorType kTypes[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC,
        VK_DESCRIPTOR_TYPE_SAMPLER,        VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
        VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,  VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
    std::vector<VkDescriptorPoolSize> sizes;
    for (const VkDescriptorType type : kTypes) sizes.push_back({type, 8 * kSetsPerPool});
    VkDescriptorPoolCreateInfo poolInfo = {};
    poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    poolInfo.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    poolInfo.maxSets = kSetsPerPool;
    poolInfo.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    poolInfo.pPoolSizes = sizes.data();
    check(vkCreateDescriptorPool(vk(), &poolInfo, nullptr, &set.pool), "vkCreateDescriptorPool", label);
    descriptorPools_.push_back(set.pool);
    info.descriptorPool = set.pool;
    check(vkAllocateDescriptorSets(vk(), &info, &set.set), "vkAllocateDescriptorSets", label);
    return set;
}

VkCommandBuffer DeviceImpl::allocateCommandBuffer(const std::string& label) {
    VkCommandBufferAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = commandPool_;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commandBuffer = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(vk(), &info, &commandBuffer), "vkAllocateCommandBuffers", label);
    setName(VK_OBJECT_TYPE_COMMAND_BUFFER, handleNumber(commandBuffer), label);
    return commandBuffer;
}

void DeviceImpl::freeCommandBuffer(VkCommandBuffer commandBuffer) noexcept {
    if (commandPool_ != VK_NULL_HANDLE) vkFreeCommandBuffers(vk(), commandPool_, 1, &commandBuffer);
}

CommandBufferImpl& DeviceImpl::pendingWrites() {
    if (!pending_) pending_ = std::make_shared<CommandBufferImpl>(*this, "queue writes");
    return *pending_;
}

DeviceImpl::Staging DeviceImpl::stage(VkDeviceSize size) {
    constexpr VkDeviceSize kAlignment = 16;  // the largest texel, which buffer-to-image copies need
    const VkDeviceSize offset = (stagingUsed_ + kAlignment - 1) / kAlignment * kAlignment;
    if (!stagingBlock_ || offset + size > stagingBlock_->size) {
        BufferDescriptor descriptor;
        descriptor.label = "staging";
        descriptor.size = std::max(size, kStagingBlock);
        descriptor.usage = BufferUsage::MapWrite | BufferUsage::CopySrc;
        stagingBlock_ = std::make_shared<BufferImpl>(*this, descriptor, true);
        stagingUsed_ = 0;
        return stage(size);
    }
    stagingUsed_ = offset + size;
    pendingStagedBytes_ += size;
    pendingWrites().keep(*stagingBlock_);
    return {stagingBlock_.get(), offset, stagingBlock_->host() + offset};
}

VkFence DeviceImpl::acquireFence() {
    if (!freeFences_.empty()) {
        VkFence fence = freeFences_.back();
        check(vkResetFences(vk(), 1, &fence), "vkResetFences", source_.label);
        freeFences_.pop_back();
        return fence;
    }
    VkFenceCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VkFence fence = VK_NULL_HANDLE;
    check(vkCreateFence(vk(), &info, nullptr, &fence), "vkCreateFence", source_.label);
    return fence;
}

void DeviceImpl::submit(const std::vector<std::shared_ptr<CommandBufferImpl>>& commandBuffers) {
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
    std::vector<VkCommandBuffer> handles;
    for (const auto& commandBuffer : submission.commandBuffers) handles.push_back(commandBuffer->vk);
    submission.fence = acquireFence();
    VkSubmitInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = static_cast<std::uint32_t>(handles.size());
    info.pCommandBuffers = handles.data();
    const VkResult result = vkQueueSubmit(source_.queue, 1, &info, submission.fence);
    if (result != VK_SUCCESS) {
        freeFences_.push_back(submission.fence);
        pending_.reset();
        check(result, "vkQueueSubmit", source_.label);
    }
    pending_.reset();
    submission.stagedBytes = std::exchange(pendingStagedBytes_, 0);
    submission.serial = ++lastSubmitted_;
    for (const auto& commandBuffer : submission.commandBuffers) commandBuffer->markSubmitted(submission.serial);
    inFlight_.push_back(std::move(submission));
    reclaim();
}

void DeviceImpl::flushPendingWrites() {
    if (pending_) submit({});
}

void DeviceImpl::limitStagedBytes(VkDeviceSize bytes) {
    if (pendingStagedBytes_ > bytes / 2) flushPendingWrites();
    while (true) {
        VkDeviceSize staged = 0;
        for (const Submission& submission : inFlight_) staged += submission.stagedBytes;
        if (staged <= bytes / 2 || inFlight_.empty()) return;
        const VkFence fence = inFlight_.front().fence;
        check(vkWaitForFences(vk(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()), "vkWaitForFences",
              source_.label);
        reclaim();
    }
}

void DeviceImpl::beginAdoptedFrame(std::uint32_t slot, std::shared_ptr<CommandBufferImpl> recording) {
    Frame& frame = frames_[slot];
    frame.number = ++lastFrame_;
    recording->frame = frame.number;
    frame.recordings = {std::move(recording)};
}

void DeviceImpl::complete(CommandBufferImpl& recording) {
    for (auto& callback : recording.onCompleted) ready_.push_back(std::move(callback));
    recording.onCompleted.clear();
    recording.releaseUsed();
}

void DeviceImpl::completeFrames(std::uint64_t number) {
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

void DeviceImpl::completeSlot(std::uint32_t slot) {
    if (const auto frame = frames_.find(slot); frame != frames_.end()) completeFrames(frame->second.number);
}

void DeviceImpl::whenDone(std::uint64_t submission, std::uint64_t frame, std::function<void(bool done)> callback) {
    waiters_.push_back({submission, frame, std::move(callback)});
}

void DeviceImpl::wakeWaiters() {
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

void DeviceImpl::reclaim() {
    while (!inFlight_.empty()) {
        const VkResult status = vkGetFenceStatus(vk(), inFlight_.front().fence);
        if (status == VK_NOT_READY) break;
        check(status, "vkGetFenceStatus", source_.label);
        const Submission submission = std::move(inFlight_.front());
        inFlight_.pop_front();
        freeFences_.push_back(submission.fence);
        lastCompleted_ = submission.serial;
        for (const auto& commandBuffer : submission.commandBuffers) complete(*commandBuffer);
    }
    wakeWaiters();
}

void DeviceImpl::runReady() {
    const std::shared_ptr<DeviceImpl> self = shared_from_this();
    // A callback may wait for more; what becomes ready meanwhile runs too, each callback once.
    while (!ready_.empty()) {
        const std::function<void()> callback = std::move(ready_.front());
        ready_.pop_front();
        callback();
    }
}

void DeviceImpl::waitIdle() {
    flushPendingWrites();
    check(vkQueueWaitIdle(source_.queue), "vkQueueWaitIdle", source_.label);
    if (lastFrame_ > 0) completeFrames(lastFrame_ - 1);
    reclaim();
}

void DeviceImpl::setName(VkObjectType type, std::uint64_t handle, const std::string& name) const {
    if (setObjectName_ == nullptr || name.empty()) return;
    VkDebugUtilsObjectNameInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = name.c_str();
    setObjectName_(source_.device, &info);
}

namespace {

VkDebugUtilsLabelEXT labelInfo(const std::string& label) {
    VkDebugUtilsLabelEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
    info.pLabelName = label.c_str();
    return info;
}

}  // namespace

void DeviceImpl::beginLabel(VkCommandBuffer commandBuffer, const std::string& label) const {
    const VkDebugUtilsLabelEXT info = labelInfo(label);
    if (cmdBeginLabel_ != nullptr) cmdBeginLabel_(commandBuffer, &info);
}

void DeviceImpl::endLabel(VkCommandBuffer commandBuffer) const {
    if (cmdEndLabel_ != nullptr) cmdEndLabel_(commandBuffer);
}

void DeviceImpl::insertLabel(VkCommandBuffer commandBuffer, const std::string& label) const {
    const VkDebugUtilsLabelEXT info = labelInfo(label);
    if (cmdInsertLabel_ != nullptr) cmdInsertLabel_(commandBuffer, &info);
}

}  // namespace gpu::detail
