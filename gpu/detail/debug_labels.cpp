// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/debug_labels.h"

namespace gpu::detail {

namespace {

VkDebugUtilsLabelEXT labelInfo(const std::string& label) {
    VkDebugUtilsLabelEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
    info.pLabelName = label.c_str();
    return info;
}

}  // namespace

DebugLabels::DebugLabels(VkInstance instance, VkDevice device, bool enabled) : device_(device) {
    if (!enabled) return;
    const auto load = [&](const char* name) { return vkGetInstanceProcAddr(instance, name); };
    setObjectName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(load("vkSetDebugUtilsObjectNameEXT"));
    beginLabel_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(load("vkCmdBeginDebugUtilsLabelEXT"));
    endLabel_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(load("vkCmdEndDebugUtilsLabelEXT"));
    insertLabel_ = reinterpret_cast<PFN_vkCmdInsertDebugUtilsLabelEXT>(load("vkCmdInsertDebugUtilsLabelEXT"));
}

void DebugLabels::setNumberedName(VkObjectType type, std::uint64_t handle, const std::string& name) const {
    if (setObjectName_ == nullptr || name.empty()) return;
    VkDebugUtilsObjectNameInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = name.c_str();
    setObjectName_(device_, &info);
}

void DebugLabels::begin(VkCommandBuffer commandBuffer, const std::string& label) const {
    const VkDebugUtilsLabelEXT info = labelInfo(label);
    if (beginLabel_ != nullptr) beginLabel_(commandBuffer, &info);
}

void DebugLabels::end(VkCommandBuffer commandBuffer) const {
    if (endLabel_ != nullptr) endLabel_(commandBuffer);
}

void DebugLabels::insert(VkCommandBuffer commandBuffer, const std::string& label) const {
    const VkDebugUtilsLabelEXT info = labelInfo(label);
    if (insertLabel_ != nullptr) insertLabel_(commandBuffer, &info);
}

}  // namespace gpu::detail
