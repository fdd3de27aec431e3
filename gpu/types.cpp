// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/types.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <utility>

namespace gpu {

namespace {

template <class E>
std::string bitNames(E set, std::initializer_list<std::pair<E, const char*>> names) {
    std::string result;
    for (const auto& [bit, name] : names) {
        if (!has(set, bit)) continue;
        if (!result.empty()) result += '|';
        result += name;
    }
    return result.empty() ? "None" : result;
}

}  // namespace

std::uint32_t texelSize(TextureFormat format) {
    switch (format) {
        case TextureFormat::Undefined:
            return 0;
        case TextureFormat::R8Unorm:
            return 1;
        case TextureFormat::R16Float:
            return 2;
        case TextureFormat::RGBA8Unorm:
        case TextureFormat::RGBA8UnormSrgb:
        case TextureFormat::BGRA8Unorm:
        case TextureFormat::R32Uint:
        case TextureFormat::R32Float:
            return 4;
        case TextureFormat::RGBA16Float:
        case TextureFormat::RG32Float:
            return 8;
        case TextureFormat::RGBA32Uint:
        case TextureFormat::RGBA32Float:
            return 16;
    }
    return 0;
}

const char* toString(TextureFormat format) {
    switch (format) {
        case TextureFormat::Undefined:
            return "undefined";
        case TextureFormat::R8Unorm:
            return "r8unorm";
        case TextureFormat::R16Float:
            return "r16float";
        case TextureFormat::RGBA8Unorm:
            return "rgba8unorm";
        case TextureFormat::RGBA8UnormSrgb:
            return "rgba8unorm-srgb";
        case TextureFormat::BGRA8Unorm:
            return "bgra8unorm";
        case TextureFormat::R32Uint:
            return "r32uint";
        case TextureFormat::R32Float:
            return "r32float";
        case TextureFormat::RGBA16Float:
            return "rgba16float";
        case TextureFormat::RG32Float:
            return "rg32float";
        case TextureFormat::RGBA32Uint:
            return "rgba32uint";
        case TextureFormat::RGBA32Float:
            return "rgba32float";
    }
    return "unknown";
}

const char* toString(AdapterType type) {
    switch (type) {
        case AdapterType::DiscreteGPU:
            return "discrete GPU";
        case AdapterType::IntegratedGPU:
            return "integrated GPU";
        case AdapterType::VirtualGPU:
            return "virtual GPU";
        case AdapterType::CPU:
            return "CPU";
        case AdapterType::Unknown:
            break;
    }
    return "unknown";
}

const char* toString(BindingType type) {
    switch (type) {
        case BindingType::UniformBuffer:
            return "uniform buffer";
        case BindingType::StorageBuffer:
            return "storage buffer";
        case BindingType::ReadOnlyStorageBuffer:
            return "read-only storage buffer";
        case BindingType::Sampler:
            return "sampler";
        case BindingType::SampledTexture:
            return "sampled texture";
        case BindingType::CombinedTextureSampler:
            return "texture with sampler";
        case BindingType::WriteOnlyStorageTexture:
            return "write-only storage texture";
        case BindingType::ReadOnlyStorageTexture:
            return "read-only storage texture";
        case BindingType::ReadWriteStorageTexture:
            return "read-write storage texture";
    }
    return "unknown";
}

std::string toString(BufferUsage usage) {
    return bitNames<BufferUsage>(usage, {{BufferUsage::MapRead, "MapRead"},
                                         {BufferUsage::MapWrite, "MapWrite"},
                                         {BufferUsage::CopySrc, "CopySrc"},
                                         {BufferUsage::CopyDst, "CopyDst"},
                                         {BufferUsage::Index, "Index"},
                                         {BufferUsage::Vertex, "Vertex"},
                                         {BufferUsage::Uniform, "Uniform"},
                                         {BufferUsage::Storage, "Storage"},
                                         {BufferUsage::Indirect, "Indirect"},
                                         {BufferUsage::QueryResolve, "QueryResolve"}});
}

std::string toString(TextureUsage usage) {
    return bitNames<TextureUsage>(usage, {{TextureUsage::CopySrc, "CopySrc"},
                                          {TextureUsage::CopyDst, "CopyDst"},
                                          {TextureUsage::TextureBinding, "TextureBinding"},
                                          {TextureUsage::StorageBinding, "StorageBinding"},
                                          {TextureUsage::RenderAttachment, "RenderAttachment"}});
}

std::uint32_t fullMipLevelCount(std::uint32_t width, std::uint32_t height) {
    return static_cast<std::uint32_t>(std::bit_width(std::max({width, height, 1u})));
}

}  // namespace gpu
