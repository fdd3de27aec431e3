// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/handle.h"
#include "gpu/sampler.h"
#include "gpu/texture.h"
#include "gpu/types.h"

namespace gpu {

struct BindGroupLayoutEntry {
    std::uint32_t binding = 0;
    ShaderStage visibility = ShaderStage::Compute;
    BindingType type = BindingType::UniformBuffer;
    bool hasDynamicOffset = false;                           ///< buffers only
    std::uint64_t minBindingSize = 0;                        ///< buffers only [bytes]; 0 = anything
    TextureFormat storageFormat = TextureFormat::Undefined;  ///< storage textures only; Undefined = anything
    TextureSampleType sampleType = TextureSampleType::Any;   ///< sampled textures only
    friend bool operator==(const BindGroupLayoutEntry&, const BindGroupLayoutEntry&) = default;
};

struct BindGroupLayoutDescriptor {
    std::string label = {};
    std::vector<BindGroupLayoutEntry> entries = {};
};

/// Bindings of one group, as a shader expects them. Layouts with equal entries are interchangeable.
class BindGroupLayout : public Handle<detail::BindGroupLayoutImpl> {
  public:
    using Handle::Handle;
    [[nodiscard]] const std::string& label() const;
    [[nodiscard]] const std::vector<BindGroupLayoutEntry>& entries() const;  ///< in order of binding
};

/// One resource of a group: a buffer range, a view, a sampler, or (CombinedTextureSampler) a view and a sampler.
struct BindGroupEntry {
    std::uint32_t binding = 0;
    Buffer buffer = {};
    std::uint64_t offset = 0;         ///< bytes
    std::uint64_t size = kWholeSize;  ///< bytes
    TextureView textureView = {};
    Sampler sampler = {};
};

struct BindGroupDescriptor {
    std::string label = {};
    BindGroupLayout layout = {};
    std::vector<BindGroupEntry> entries = {};
};

/// Resources bound together; checked against the layout on creation.
class BindGroup : public Handle<detail::BindGroupImpl> {
  public:
    using Handle::Handle;
    [[nodiscard]] const std::string& label() const;
};

struct PipelineLayoutDescriptor {
    std::string label = {};
    std::vector<BindGroupLayout> bindGroupLayouts = {};  ///< index = group (GLSL set)
    std::uint32_t immediateSize = 0;                     ///< [bytes] a multiple of 4 up to kMaxImmediateSize
};

/// The groups and immediates of a pipeline.
class PipelineLayout : public Handle<detail::PipelineLayoutImpl> {
  public:
    using Handle::Handle;
    [[nodiscard]] const std::string& label() const;
};

}  // namespace gpu
