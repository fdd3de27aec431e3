// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <vector>

namespace gpu::detail {

/// A descriptor set and the pool it came from.
struct DescriptorSet {
    VkDescriptorSet set = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
};

/// Descriptor pools, made as they are needed. Owns the pools; a set belongs to its bind group, which frees it. Belongs
/// to the thread of its device.
class DescriptorPools {
  public:
    explicit DescriptorPools(VkDevice device) : device_(device) {}
    DescriptorPools(const DescriptorPools&) = delete;
    DescriptorPools& operator=(const DescriptorPools&) = delete;

    [[nodiscard]] DescriptorSet allocate(VkDescriptorSetLayout layout, const std::string& label);
    /// Destroys all pools; before the device dies.
    void release() noexcept;

  private:
    [[nodiscard]] VkDescriptorPool addPool(const std::string& label);

    VkDevice device_ = VK_NULL_HANDLE;
    std::vector<VkDescriptorPool> pools_;
};

}  // namespace gpu::detail
