// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <type_traits>

namespace gpu::detail {

/// Names of Vulkan objects and of groups of commands, for validation messages and RenderDoc (VK_EXT_debug_utils).
/// Without the extension every call does nothing. Owns no Vulkan object; belongs to the thread of its device.
class DebugLabels {
  public:
    DebugLabels(VkInstance instance, VkDevice device, bool enabled);

    /// Names an object; an empty name changes nothing.
    template <class T>
    void setName(VkObjectType type, T handle, const std::string& name) const {
        if constexpr (std::is_pointer_v<T>) {
            setNumberedName(type, static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(handle)), name);
        } else {
            setNumberedName(type, handle, name);
        }
    }
    void begin(VkCommandBuffer commandBuffer, const std::string& label) const;
    void end(VkCommandBuffer commandBuffer) const;
    void insert(VkCommandBuffer commandBuffer, const std::string& label) const;

  private:
    void setNumberedName(VkObjectType type, std::uint64_t handle, const std::string& name) const;

    VkDevice device_ = VK_NULL_HANDLE;
    PFN_vkSetDebugUtilsObjectNameEXT setObjectName_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT endLabel_ = nullptr;
    PFN_vkCmdInsertDebugUtilsLabelEXT insertLabel_ = nullptr;
};

}  // namespace gpu::detail
