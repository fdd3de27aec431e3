// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/descriptor_pools.h"

#include "gpu/detail/vulkan_map.h"

namespace gpu::detail {

namespace {

constexpr std::uint32_t kSetsPerPool = 64;

}  // namespace

DescriptorSet DescriptorPools::allocate(VkDescriptorSetLayout layout, const std::string& label) {
    VkDescriptorSetAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    DescriptorSet set;
    // Newest first, as it most likely has room. A full pool returns an error; freed sets make room in old pools.
    for (auto pool = pools_.rbegin(); pool != pools_.rend(); ++pool) {
        info.descriptorPool = set.pool = *pool;
        const VkResult result = vkAllocateDescriptorSets(device_, &info, &set.set);
        if (result == VK_SUCCESS) return set;
        if (result != VK_ERROR_OUT_OF_POOL_MEMORY && result != VK_ERROR_FRAGMENTED_POOL) {
            requireSuccess(result, "vkAllocateDescriptorSets", label);
        }
    }
    info.descriptorPool = set.pool = addPool(label);
    requireSuccess(vkAllocateDescriptorSets(device_, &info, &set.set), "vkAllocateDescriptorSets", label);
    return set;
}

VkDescriptorPool DescriptorPools::addPool(const std::string& label) {
    constexpr VkDescriptorType kTypes[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC,
        VK_DESCRIPTOR_TYPE_SAMPLER,        VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
        VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,  VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
    std::vector<VkDescriptorPoolSize> sizes;
    for (const VkDescriptorType type : kTypes) sizes.push_back({type, 8 * kSetsPerPool});
    VkDescriptorPoolCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    info.maxSets = kSetsPerPool;
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    requireSuccess(vkCreateDescriptorPool(device_, &info, nullptr, &pool), "vkCreateDescriptorPool", label);
    pools_.push_back(pool);
    return pool;
}

void DescriptorPools::release() noexcept {
    for (VkDescriptorPool pool : pools_) vkDestroyDescriptorPool(device_, pool, nullptr);
    pools_.clear();
}

}  // namespace gpu::detail
