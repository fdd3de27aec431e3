// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/command_encoder.h"
#include "gpu/device.h"

namespace gpu {

/// A Vulkan device owned by someone else, for `Device::adopt`. The instance must have been made for Vulkan 1.1 (for Qt:
/// QVulkanInstance::setApiVersion({1, 1})); no feature or extension is needed. The queue must support compute and
/// graphics, and only one thread may use it.
struct AdoptDescriptor {
    std::string label = {};
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queueFamilyIndex = 0;
    bool debugUtils = false;  ///< VK_EXT_debug_utils is enabled: objects get labels, and PATINA_VALIDATION applies
    DeviceLostCallback deviceLost = {};
};

/// Render pass that a pipeline draws in (subpass 0), for `RenderPipelineDescriptor::externalTarget`.
struct ExternalRenderTarget {
    VkRenderPass renderPass = VK_NULL_HANDLE;
    VkSampleCountFlagBits sampleCount = VK_SAMPLE_COUNT_1_BIT;
    bool hasDepth = true;  ///< QVulkanWindow's default render pass has a depth attachment; it is not used
};

/// A pass into a framebuffer owned by someone else. Needs all clear values of the render pass, in attachment order (for
/// QVulkanWindow: colour, depth, and colour again when multisampled).
struct ExternalRenderPassDescriptor {
    std::string label = {};
    VkRenderPass renderPass = VK_NULL_HANDLE;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    std::uint32_t width = 0;   ///< pixels
    std::uint32_t height = 0;  ///< pixels
    std::vector<VkClearValue> clearValues = {};
    std::optional<PassTimestampWrites> timestampWrites = {};
};

}  // namespace gpu
