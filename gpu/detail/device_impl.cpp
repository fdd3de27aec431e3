// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/device_impl.h"

#include <algorithm>
#include <utility>

#include "gpu/detail/vulkan_map.h"

namespace gpu::detail {

Object::Object(DeviceImpl& device, std::string label) : device_(device), label_(std::move(label)) { device.add(this); }

Object::~Object() { device_.remove(this); }

DeviceImpl::DeviceImpl(Source source)
    : source_(std::move(source)),
      info_(describeAdapter(source_.physicalDevice)),
      limits_(queryLimits(source_.physicalDevice, source_.queueFamily)),
      labels_(source_.instance, source_.device, source_.debugUtils),
      memory_(source_.physicalDevice, source_.device, info_.type == AdapterType::CPU),
      descriptorPools_(source_.device),
      inFlight_(*this) {
    std::uint32_t familyCount = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(source_.physicalDevice, &familyCount, nullptr);
    std::vector<VkQueueFamilyProperties> families(familyCount);
    vkGetPhysicalDeviceQueueFamilyProperties(source_.physicalDevice, &familyCount, families.data());
    timestampBits_ = families.at(source_.queueFamily).timestampValidBits;
    labels_.setName(VK_OBJECT_TYPE_DEVICE, source_.device, source_.label);

    try {
        inFlight_.createCommandPool();
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
        inFlight_.discardCallbacks();
        releaseAll();
    }
}

void DeviceImpl::requireUsable() const {
    require(!destroyed_, "Device ", quoted(source_.label), " has been destroyed.");
    if (lost_) throw Error(ErrorKind::DeviceLost, text("Device ", quoted(source_.label), " is lost."));
}

void DeviceImpl::check(VkResult result, const char* call, const std::string& label) {
    if (result == VK_ERROR_DEVICE_LOST) markLost(failureMessage(result, call, label));
    requireSuccess(result, call, label);
}

void DeviceImpl::markLost(const std::string& message) {
    if (lost_ || destroyed_) return;
    lost_ = true;
    inFlight_.abandon();
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

void DeviceImpl::destroy() {
    if (destroyed_) return;
    compiler_.stop();
    vkDeviceWaitIdle(vk());
    inFlight_.completeAll();
    const std::shared_ptr<DeviceImpl> self = shared_from_this();
    // What has completed can still be read.
    inFlight_.runReady();
    if (destroyed_) return;
    vkDeviceWaitIdle(vk());
    inFlight_.abandon();
    inFlight_.discard();
    for (Object* object : live_) object->release();
    releaseAll();
    destroyed_ = true;
    inFlight_.runReady();
    if (const DeviceLostCallback callback = std::exchange(source_.deviceLost, nullptr)) {
        callback(DeviceLostReason::Destroyed, text("Device ", quoted(source_.label), " has been destroyed."));
    }
}

void DeviceImpl::releaseAll() noexcept {
    inFlight_.release();
    descriptorPools_.release();
    if (pipelineCache_ != VK_NULL_HANDLE) vkDestroyPipelineCache(vk(), pipelineCache_, nullptr);
    pipelineCache_ = VK_NULL_HANDLE;
    if (source_.owned) vkDestroyDevice(source_.device, nullptr);
    source_.device = VK_NULL_HANDLE;
    source_.adoptedValidation.reset();
}

}  // namespace gpu::detail
