// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/vulkan_map.h"

#include "gpu/detail/text.h"

namespace gpu::detail {

VkFormat toVulkan(TextureFormat format) {
    switch (format) {
        case TextureFormat::Undefined:
            return VK_FORMAT_UNDEFINED;
        case TextureFormat::R8Unorm:
            return VK_FORMAT_R8_UNORM;
        case TextureFormat::RGBA8Unorm:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case TextureFormat::RGBA8UnormSrgb:
            return VK_FORMAT_R8G8B8A8_SRGB;
        case TextureFormat::BGRA8Unorm:
            return VK_FORMAT_B8G8R8A8_UNORM;
        case TextureFormat::R16Float:
            return VK_FORMAT_R16_SFLOAT;
        case TextureFormat::RGBA16Float:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case TextureFormat::R32Uint:
            return VK_FORMAT_R32_UINT;
        case TextureFormat::R32Float:
            return VK_FORMAT_R32_SFLOAT;
        case TextureFormat::RG32Float:
            return VK_FORMAT_R32G32_SFLOAT;
        case TextureFormat::RGBA32Uint:
            return VK_FORMAT_R32G32B32A32_UINT;
        case TextureFormat::RGBA32Float:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
    }
    return VK_FORMAT_UNDEFINED;
}

VkShaderStageFlags toVulkan(ShaderStage stages) {
    VkShaderStageFlags result = 0;
    if (has(stages, ShaderStage::Vertex)) result |= VK_SHADER_STAGE_VERTEX_BIT;
    if (has(stages, ShaderStage::Fragment)) result |= VK_SHADER_STAGE_FRAGMENT_BIT;
    if (has(stages, ShaderStage::Compute)) result |= VK_SHADER_STAGE_COMPUTE_BIT;
    return result;
}

VkPipelineStageFlags pipelineStages(ShaderStage stages) {
    VkPipelineStageFlags result = 0;
    if (has(stages, ShaderStage::Vertex)) result |= VK_PIPELINE_STAGE_VERTEX_SHADER_BIT;
    if (has(stages, ShaderStage::Fragment)) result |= VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    if (has(stages, ShaderStage::Compute)) result |= VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    return result;
}

VkDescriptorType toVulkan(BindingType type, bool dynamic) {
    switch (type) {
        case BindingType::UniformBuffer:
            return dynamic ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case BindingType::StorageBuffer:
        case BindingType::ReadOnlyStorageBuffer:
            return dynamic ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        case BindingType::Sampler:
            return VK_DESCRIPTOR_TYPE_SAMPLER;
        case BindingType::SampledTexture:
            return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
        case BindingType::CombinedTextureSampler:
            return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        case BindingType::WriteOnlyStorageTexture:
        case BindingType::ReadOnlyStorageTexture:
        case BindingType::ReadWriteStorageTexture:
            break;
    }
    return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
}

VkBufferUsageFlags toVulkan(BufferUsage usage) {
    // New buffers are zeroed by a fill, so every buffer is a transfer destination.
    VkBufferUsageFlags result = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    if (has(usage, BufferUsage::CopySrc)) result |= VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (has(usage, BufferUsage::Index)) result |= VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
    if (has(usage, BufferUsage::Vertex)) result |= VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
    if (has(usage, BufferUsage::Uniform)) result |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    if (has(usage, BufferUsage::Storage)) result |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    if (has(usage, BufferUsage::Indirect)) result |= VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
    return result;
}

VkImageUsageFlags toVulkan(TextureUsage usage) {
    // New textures are zeroed by a clear, so every image is a transfer destination.
    VkImageUsageFlags result = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (has(usage, TextureUsage::CopySrc)) result |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (has(usage, TextureUsage::TextureBinding)) result |= VK_IMAGE_USAGE_SAMPLED_BIT;
    if (has(usage, TextureUsage::StorageBinding)) result |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (has(usage, TextureUsage::RenderAttachment)) result |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    return result;
}

VkFilter toVulkan(FilterMode mode) { return mode == FilterMode::Linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST; }

VkSamplerAddressMode toVulkan(AddressMode mode) {
    switch (mode) {
        case AddressMode::ClampToEdge:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        case AddressMode::Repeat:
            return VK_SAMPLER_ADDRESS_MODE_REPEAT;
        case AddressMode::MirrorRepeat:
            break;
    }
    return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
}

VkPrimitiveTopology toVulkan(PrimitiveTopology topology) {
    switch (topology) {
        case PrimitiveTopology::TriangleList:
            return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        case PrimitiveTopology::TriangleStrip:
            return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
        case PrimitiveTopology::LineList:
            return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
        case PrimitiveTopology::LineStrip:
            return VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
        case PrimitiveTopology::PointList:
            break;
    }
    return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
}

VkFormat toVulkan(VertexFormat format) {
    switch (format) {
        case VertexFormat::Float32:
            return VK_FORMAT_R32_SFLOAT;
        case VertexFormat::Float32x2:
            return VK_FORMAT_R32G32_SFLOAT;
        case VertexFormat::Float32x3:
            return VK_FORMAT_R32G32B32_SFLOAT;
        case VertexFormat::Float32x4:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        case VertexFormat::Uint32:
            return VK_FORMAT_R32_UINT;
        case VertexFormat::Unorm8x4:
            break;
    }
    return VK_FORMAT_R8G8B8A8_UNORM;
}

VkBlendFactor toVulkan(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::Zero:
            return VK_BLEND_FACTOR_ZERO;
        case BlendFactor::One:
            return VK_BLEND_FACTOR_ONE;
        case BlendFactor::SrcAlpha:
            return VK_BLEND_FACTOR_SRC_ALPHA;
        case BlendFactor::OneMinusSrcAlpha:
            return VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        case BlendFactor::DstAlpha:
            return VK_BLEND_FACTOR_DST_ALPHA;
        case BlendFactor::OneMinusDstAlpha:
            break;
    }
    return VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
}

const char* toString(VkResult result) {
    switch (result) {
        case VK_SUCCESS:
            return "VK_SUCCESS";
        case VK_NOT_READY:
            return "VK_NOT_READY";
        case VK_TIMEOUT:
            return "VK_TIMEOUT";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "VK_ERROR_OUT_OF_HOST_MEMORY";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
        case VK_ERROR_INITIALIZATION_FAILED:
            return "VK_ERROR_INITIALIZATION_FAILED";
        case VK_ERROR_DEVICE_LOST:
            return "VK_ERROR_DEVICE_LOST";
        case VK_ERROR_MEMORY_MAP_FAILED:
            return "VK_ERROR_MEMORY_MAP_FAILED";
        case VK_ERROR_LAYER_NOT_PRESENT:
            return "VK_ERROR_LAYER_NOT_PRESENT";
        case VK_ERROR_EXTENSION_NOT_PRESENT:
            return "VK_ERROR_EXTENSION_NOT_PRESENT";
        case VK_ERROR_FEATURE_NOT_PRESENT:
            return "VK_ERROR_FEATURE_NOT_PRESENT";
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return "VK_ERROR_INCOMPATIBLE_DRIVER";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "VK_ERROR_TOO_MANY_OBJECTS";
        case VK_ERROR_FORMAT_NOT_SUPPORTED:
            return "VK_ERROR_FORMAT_NOT_SUPPORTED";
        case VK_ERROR_FRAGMENTED_POOL:
            return "VK_ERROR_FRAGMENTED_POOL";
        case VK_ERROR_OUT_OF_POOL_MEMORY:
            return "VK_ERROR_OUT_OF_POOL_MEMORY";
        default:
            return "an unknown Vulkan error";
    }
}

std::string failureMessage(VkResult result, const char* call, const std::string& label) {
    return text(call, " for ", quoted(label), " fails: ", toString(result), ".");
}

void requireSuccess(VkResult result, const char* call, const std::string& label) {
    switch (result) {
        case VK_SUCCESS:
            return;
        case VK_ERROR_DEVICE_LOST:
            throw Error(ErrorKind::DeviceLost, failureMessage(result, call, label));
        case VK_ERROR_OUT_OF_HOST_MEMORY:
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        case VK_ERROR_TOO_MANY_OBJECTS:
        case VK_ERROR_OUT_OF_POOL_MEMORY:
        case VK_ERROR_MEMORY_MAP_FAILED:
            throw Error(ErrorKind::OutOfMemory, failureMessage(result, call, label));
        default:
            throw Error(ErrorKind::Internal, failureMessage(result, call, label));
    }
}

}  // namespace gpu::detail
