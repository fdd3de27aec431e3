// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/device_memory.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "gpu/detail/text.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu::detail {

namespace {

/// Asks for large pages, of 2 MB on most machines, where the device's memory is the process's own. With small pages,
/// most look-ups across a large image also wait for the translation of their address. Only a hint.
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

bool coherent(const Allocation& allocation) { return (allocation.flags & VK_MEMORY_PROPERTY_HOST_COHERENT_BIT) != 0; }

VkMappedMemoryRange wholeRange(const Allocation& allocation) {
    return {VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE, nullptr, allocation.memory, 0, VK_WHOLE_SIZE};
}

}  // namespace

DeviceMemory::DeviceMemory(VkPhysicalDevice physicalDevice, VkDevice device, bool hostMemory)
    : device_(device), hostMemory_(hostMemory) {
    vkGetPhysicalDeviceMemoryProperties(physicalDevice, &properties_);
}

std::uint32_t DeviceMemory::findType(std::uint32_t allowedTypes, VkMemoryPropertyFlags required,
                                     VkMemoryPropertyFlags preferred) const {
    std::uint32_t best = properties_.memoryTypeCount;
    int bestScore = -1;
    for (std::uint32_t i = 0; i < properties_.memoryTypeCount; ++i) {
        const VkMemoryPropertyFlags flags = properties_.memoryTypes[i].propertyFlags;
        if ((allowedTypes & (1u << i)) == 0 || (flags & required) != required) continue;
        const int score = (flags & preferred) == preferred ? 1 : 0;
        if (score > bestScore) {
            best = i;
            bestScore = score;
        }
    }
    return best;
}

Allocation DeviceMemory::allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags required,
                                  VkMemoryPropertyFlags preferred, bool counted, const std::string& what) {
    const std::uint32_t index = findType(requirements.memoryTypeBits, required, preferred);
    if (index == properties_.memoryTypeCount) {
        throw Error(ErrorKind::OutOfMemory, text("The device has no kind of memory for ", what, "."));
    }
    const VkMemoryType& type = properties_.memoryTypes[index];
    const VkDeviceSize heap = properties_.memoryHeaps[type.heapIndex].size;
    if (requirements.size > heap) {
        throw Error(ErrorKind::OutOfMemory, text("There is no room for ", what, ": it needs ", requirements.size,
                                                 " bytes, the device's memory is ", heap,
                                                 " bytes and this device has allocated ", allocatedBytes_, "."));
    }
    VkMemoryAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = index;
    Allocation allocation{
        .memory = VK_NULL_HANDLE, .size = requirements.size, .flags = type.propertyFlags, .counted = counted};
    const VkResult result = vkAllocateMemory(device_, &info, nullptr, &allocation.memory);
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY ||
        result == VK_ERROR_TOO_MANY_OBJECTS) {
        throw Error(ErrorKind::OutOfMemory,
                    text("There is no room for ", what, ": allocating ", requirements.size,
                         " bytes fails, and this device has allocated ", allocatedBytes_, " bytes."));
    }
    requireSuccess(result, "vkAllocateMemory", what);
    if (hostMemory_) askForLargePages(device_, allocation);
    if (counted) allocatedBytes_ += allocation.size;
    return allocation;
}

void DeviceMemory::free(Allocation& allocation) noexcept {
    if (allocation.memory == VK_NULL_HANDLE) return;
    vkFreeMemory(device_, allocation.memory, nullptr);
    if (allocation.counted) allocatedBytes_ -= allocation.size;
    allocation = {};
}

std::byte* DeviceMemory::map(const Allocation& allocation, const std::string& label) {
    void* data = nullptr;
    requireSuccess(vkMapMemory(device_, allocation.memory, 0, VK_WHOLE_SIZE, 0, &data), "vkMapMemory", label);
    return static_cast<std::byte*>(data);
}

void DeviceMemory::flushHostWrites(const Allocation& allocation, const std::string& label) {
    if (coherent(allocation)) return;
    const VkMappedMemoryRange range = wholeRange(allocation);
    requireSuccess(vkFlushMappedMemoryRanges(device_, 1, &range), "vkFlushMappedMemoryRanges", label);
}

void DeviceMemory::invalidateHostReads(const Allocation& allocation, const std::string& label) {
    if (coherent(allocation)) return;
    const VkMappedMemoryRange range = wholeRange(allocation);
    requireSuccess(vkInvalidateMappedMemoryRanges(device_, 1, &range), "vkInvalidateMappedMemoryRanges", label);
}

}  // namespace gpu::detail
