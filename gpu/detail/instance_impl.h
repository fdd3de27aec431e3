// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdint>
#include <memory>

#include "gpu/adapter.h"
#include "gpu/instance.h"

namespace gpu::detail {

/// Listens to the validation layer of one VkInstance.
class ValidationListener {
  public:
    ValidationListener(ValidationMode mode, ValidationCallback callback)
        : mode_(mode), callback_(std::move(callback)) {}
    ~ValidationListener();
    ValidationListener(const ValidationListener&) = delete;
    ValidationListener& operator=(const ValidationListener&) = delete;

    [[nodiscard]] VkDebugUtilsMessengerCreateInfoEXT createInfo();
    void attach(VkInstance instance);
    [[nodiscard]] std::uint64_t messageCount() const { return count_; }

  private:
    static VkBool32 onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT types,
                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

    ValidationMode mode_;
    ValidationCallback callback_;
    std::atomic<std::uint64_t> count_ = 0;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

class InstanceImpl {
  public:
    explicit InstanceImpl(const InstanceDescriptor& descriptor);
    ~InstanceImpl();
    InstanceImpl(const InstanceImpl&) = delete;
    InstanceImpl& operator=(const InstanceImpl&) = delete;

    VkInstance vk = VK_NULL_HANDLE;
    bool debugUtils = false;
    std::unique_ptr<ValidationListener> validation;
};

class AdapterImpl {
  public:
    std::shared_ptr<InstanceImpl> instance;
    VkPhysicalDevice vk = VK_NULL_HANDLE;
    std::uint32_t queueFamily = 0;
    AdapterInfo info;
    Limits limits;
};

[[nodiscard]] AdapterInfo describeAdapter(VkPhysicalDevice physicalDevice);
[[nodiscard]] Limits queryLimits(VkPhysicalDevice physicalDevice, std::uint32_t queueFamily);

}  // namespace gpu::detail
