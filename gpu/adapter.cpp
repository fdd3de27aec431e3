// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/adapter.h"

#include <algorithm>
#include <cstring>
#include <iomanip>
#include <sstream>

#include "gpu/detail/device_impl.h"
#include "gpu/detail/instance_impl.h"
#include "gpu/detail/text.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

namespace {

AdapterType typeOf(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return AdapterType::DiscreteGPU;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return AdapterType::IntegratedGPU;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return AdapterType::VirtualGPU;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return AdapterType::CPU;
        default:
            return AdapterType::Unknown;
    }
}

/// Identifiers of the PCI SIG, and Khronos' own for software.
std::string vendorName(std::uint32_t id) {
    switch (id) {
        case 0x1002:
            return "AMD";
        case 0x1010:
            return "Imagination";
        case 0x106b:
            return "Apple";
        case 0x10de:
            return "NVIDIA";
        case 0x13b5:
            return "Arm";
        case 0x5143:
            return "Qualcomm";
        case 0x8086:
            return "Intel";
        case VK_VENDOR_ID_MESA:
            return "Mesa";
        default: {
            std::ostringstream hex;
            hex << "0x" << std::hex << id;
            return hex.str();
        }
    }
}

bool hasExtension(VkPhysicalDevice device, const char* name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

}  // namespace

AdapterInfo describeAdapter(VkPhysicalDevice physicalDevice) {
    VkPhysicalDeviceDriverProperties driver = {};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties = {};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    if (hasExtension(physicalDevice, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME)) properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(physicalDevice, &properties);
    const VkPhysicalDeviceProperties& p = properties.properties;
    AdapterInfo info;
    info.name = p.deviceName;
    info.type = typeOf(p.deviceType);
    info.vendorId = p.vendorID;
    info.deviceId = p.deviceID;
    info.vendor = vendorName(p.vendorID);
    info.apiVersionMajor = VK_API_VERSION_MAJOR(p.apiVersion);
    info.apiVersionMinor = VK_API_VERSION_MINOR(p.apiVersion);
    info.driver = driver.driverName[0] != 0 ? text(driver.driverName, ' ', driver.driverInfo)
                                            : text("driver version ", p.driverVersion);
    return info;
}

Limits queryLimits(VkPhysicalDevice physicalDevice, std::uint32_t queueFamily) {
    VkPhysicalDeviceMaintenance3Properties maintenance = {};
    maintenance.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
    VkPhysicalDeviceProperties2 properties = {};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &maintenance;
    vkGetPhysicalDeviceProperties2(physicalDevice, &properties);
    const VkPhysicalDeviceLimits& vk = properties.properties.limits;

    Limits limits;
    limits.maxTextureDimension2D = vk.maxImageDimension2D;
    limits.maxBindGroups = vk.maxBoundDescriptorSets;
    limits.maxBufferSize = maintenance.maxMemoryAllocationSize;
    limits.maxUniformBufferBindingSize = vk.maxUniformBufferRange;
    limits.maxStorageBufferBindingSize = vk.maxStorageBufferRange;
    limits.minUniformBufferOffsetAlignment = static_cast<std::uint32_t>(vk.minUniformBufferOffsetAlignment);
    limits.minStorageBufferOffsetAlignment = static_cast<std::uint32_t>(vk.minStorageBufferOffsetAlignment);
    limits.maxComputeWorkgroupStorageSize = vk.maxComputeSharedMemorySize;
    limits.maxComputeInvocationsPerWorkgroup = vk.maxComputeWorkGroupInvocations;
    limits.maxComputeWorkgroupSizeX = vk.maxComputeWorkGroupSize[0];
    limits.maxComputeWorkgroupSizeY = vk.maxComputeWorkGroupSize[1];
    limits.maxComputeWorkgroupSizeZ = vk.maxComputeWorkGroupSize[2];
    limits.maxComputeWorkgroupsPerDimension =
        std::min({vk.maxComputeWorkGroupCount[0], vk.maxComputeWorkGroupCount[1], vk.maxComputeWorkGroupCount[2]});
    limits.maxColorAttachments = vk.maxColorAttachments;

    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physicalDevice, &memory);
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) == 0) continue;
        limits.deviceMemory = std::max<std::uint64_t>(limits.deviceMemory, memory.memoryHeaps[i].size);
    }

    std::uint32_t familyCount = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice, &familyCount, nullptr);
    std::vector<VkQueueFamilyProperties> families(familyCount);
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice, &familyCount, families.data());
    limits.timestamps =
        queueFamily < familyCount && families[queueFamily].timestampValidBits > 0 && vk.timestampPeriod > 0;
    limits.timestampPeriod = limits.timestamps ? static_cast<double>(vk.timestampPeriod) : 0;
    return limits;
}

}  // namespace detail

const AdapterInfo& Adapter::info() const {
    detail::require(impl_ != nullptr, "The adapter is an empty handle.");
    return impl_->info;
}

const Limits& Adapter::limits() const {
    detail::require(impl_ != nullptr, "The adapter is an empty handle.");
    return impl_->limits;
}

Device Adapter::requestDevice(const DeviceDescriptor& descriptor) const {
    detail::require(impl_ != nullptr, "The adapter is an empty handle.");
    const float priority = 1;
    VkDeviceQueueCreateInfo queueInfo = {};
    queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queueInfo.queueFamilyIndex = impl_->queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkDeviceCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;

    detail::DeviceImpl::Source source;
    const VkResult result = vkCreateDevice(impl_->vk, &info, nullptr, &source.device);
    if (result != VK_SUCCESS) {
        throw Error(result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY
                        ? ErrorKind::OutOfMemory
                        : ErrorKind::Internal,
                    detail::text("Opening device \"", impl_->info.name, "\" fails: ", detail::toString(result), "."));
    }
    source.instanceImpl = impl_->instance;
    source.instance = impl_->instance->vk;
    source.physicalDevice = impl_->vk;
    vkGetDeviceQueue(source.device, impl_->queueFamily, 0, &source.queue);
    source.queueFamily = impl_->queueFamily;
    source.owned = true;
    source.debugUtils = impl_->instance->debugUtils;
    source.label = descriptor.label;
    source.deviceLost = descriptor.deviceLost;
    return Device(std::make_shared<detail::DeviceImpl>(std::move(source)));
}

}  // namespace gpu
