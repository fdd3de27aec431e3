// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace gpu::detail {

/// One allocation of device memory.
struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize size = 0;
    VkMemoryPropertyFlags flags = 0;
    bool counted = false;
};

/// Allocates, counts and maps the memory of buffers and textures.
///
/// Owns no memory: an Allocation belongs to the buffer or texture that asked for it, which returns it with `free`
/// before the device dies. Belongs to the thread of its device.
class DeviceMemory {
  public:
    /// `hostMemory`: the device's memory is the process's own.
    DeviceMemory(VkPhysicalDevice physicalDevice, VkDevice device, bool hostMemory);
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;

    /// Memory of a type with all `required` properties, and with all `preferred` ones where there is such a type.
    /// `counted` allocations add to `allocatedBytes`. `what` names the resource in Error(OutOfMemory).
    [[nodiscard]] Allocation allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags required,
                                      VkMemoryPropertyFlags preferred, bool counted, const std::string& what);
    void free(Allocation& allocation) noexcept;

    /// The bytes of host-visible memory, mapped until it is freed. `label` names the resource in errors.
    [[nodiscard]] std::byte* map(const Allocation& allocation, const std::string& label);
    /// Makes writes of the host visible to the device, where the memory is not coherent.
    void flushHostWrites(const Allocation& allocation, const std::string& label);
    /// Makes writes of the device visible to the host, where the memory is not coherent.
    void invalidateHostReads(const Allocation& allocation, const std::string& label);

    /// Bytes of all counted allocations.
    [[nodiscard]] std::uint64_t allocatedBytes() const { return allocatedBytes_; }

  private:
    [[nodiscard]] std::uint32_t findType(std::uint32_t allowedTypes, VkMemoryPropertyFlags required,
                                         VkMemoryPropertyFlags preferred) const;

    VkDevice device_ = VK_NULL_HANDLE;
    bool hostMemory_ = false;
    VkPhysicalDeviceMemoryProperties properties_ = {};
    std::uint64_t allocatedBytes_ = 0;
};

}  // namespace gpu::detail
