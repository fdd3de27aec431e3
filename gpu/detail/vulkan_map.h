// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <string>

#include "gpu/types.h"

namespace gpu::detail {

// This library's enumerations in Vulkan's words.
[[nodiscard]] VkFormat toVulkan(TextureFormat format);
[[nodiscard]] VkShaderStageFlags toVulkan(ShaderStage stages);
[[nodiscard]] VkPipelineStageFlags pipelineStages(ShaderStage stages);
[[nodiscard]] VkDescriptorType toVulkan(BindingType type, bool dynamic);
[[nodiscard]] VkBufferUsageFlags toVulkan(BufferUsage usage);
[[nodiscard]] VkImageUsageFlags toVulkan(TextureUsage usage);
[[nodiscard]] VkFilter toVulkan(FilterMode mode);
[[nodiscard]] VkSamplerAddressMode toVulkan(AddressMode mode);
[[nodiscard]] VkPrimitiveTopology toVulkan(PrimitiveTopology topology);
[[nodiscard]] VkFormat toVulkan(VertexFormat format);
[[nodiscard]] VkBlendFactor toVulkan(BlendFactor factor);
/// The name of a result, for example "VK_ERROR_DEVICE_LOST".
[[nodiscard]] const char* toString(VkResult result);
/// Message of a failed call: its name, the label of its object, the result.
[[nodiscard]] std::string failureMessage(VkResult result, const char* call, const std::string& label);
/// Throws the Error a failed result means. Calls that may lose the device go through DeviceImpl::check instead.
void requireSuccess(VkResult result, const char* call, const std::string& label);

[[nodiscard]] constexpr bool isBuffer(BindingType type) {
    return type == BindingType::UniformBuffer || type == BindingType::StorageBuffer ||
           type == BindingType::ReadOnlyStorageBuffer;
}
[[nodiscard]] constexpr bool isStorageTexture(BindingType type) {
    return type == BindingType::WriteOnlyStorageTexture || type == BindingType::ReadOnlyStorageTexture ||
           type == BindingType::ReadWriteStorageTexture;
}
[[nodiscard]] constexpr bool isSampled(BindingType type) {
    return type == BindingType::SampledTexture || type == BindingType::CombinedTextureSampler;
}
[[nodiscard]] constexpr bool isWritable(BindingType type) {
    return type == BindingType::StorageBuffer || type == BindingType::WriteOnlyStorageTexture ||
           type == BindingType::ReadWriteStorageTexture;
}
[[nodiscard]] constexpr TextureSampleType sampleTypeOf(TextureFormat format) {
    return format == TextureFormat::R32Uint || format == TextureFormat::RGBA32Uint ? TextureSampleType::Uint
                                                                                   : TextureSampleType::Float;
}

}  // namespace gpu::detail
