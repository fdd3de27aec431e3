// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/bind_group.h"
#include "gpu/handle.h"
#include "gpu/shader_module.h"
#include "gpu/types.h"

namespace gpu {

struct ExternalRenderTarget;  // gpu/adopt.h

/// Value of a specialization constant, by its name in GLSL or its constant_id in decimal.
struct ConstantEntry {
    std::string key = {};
    double value = 0;
};

struct ComputePipelineDescriptor {
    std::string label = {};
    PipelineLayout layout = {};  ///< empty = derived from the shader
    ShaderModule module = {};
    std::vector<ConstantEntry> constants = {};
};

class ComputePipeline : public Handle<detail::ComputePipelineImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] const std::string& label() const;
    /// Layout of GLSL set `index`.
    [[nodiscard]] BindGroupLayout getBindGroupLayout(std::uint32_t index) const;
    /// Local size after specialization.
    [[nodiscard]] std::array<std::uint32_t, 3> workgroupSize() const;
};

struct VertexAttribute {
    VertexFormat format = VertexFormat::Float32x4;
    std::uint64_t offset = 0;          ///< bytes
    std::uint32_t shaderLocation = 0;  ///< GLSL location
};

struct VertexBufferLayout {
    std::uint64_t arrayStride = 0;  ///< bytes
    VertexStepMode stepMode = VertexStepMode::Vertex;
    std::vector<VertexAttribute> attributes = {};
};

struct BlendComponent {
    BlendFactor srcFactor = BlendFactor::One;  ///< result = src * srcFactor + dst * dstFactor
    BlendFactor dstFactor = BlendFactor::Zero;
};

struct BlendState {
    BlendComponent color = {};
    BlendComponent alpha = {};
};

struct ColorTargetState {
    TextureFormat format = TextureFormat::Undefined;  ///< Undefined with an external target
    std::optional<BlendState> blend = {};
};

struct RenderPipelineDescriptor {
    std::string label = {};
    PipelineLayout layout = {};  ///< empty = derived from both shaders
    ShaderModule vertex = {};
    ShaderModule fragment = {};
    std::vector<VertexBufferLayout> buffers = {};
    PrimitiveTopology topology = PrimitiveTopology::TriangleList;
    CullMode cullMode = CullMode::None;
    std::vector<ColorTargetState> targets = {};
    const ExternalRenderTarget* externalTarget = nullptr;  ///< for windows: render pass of another owner
    std::vector<ConstantEntry> vertexConstants = {};
    std::vector<ConstantEntry> fragmentConstants = {};
};

class RenderPipeline : public Handle<detail::RenderPipelineImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] const std::string& label() const;
    [[nodiscard]] BindGroupLayout getBindGroupLayout(std::uint32_t index) const;
};

}  // namespace gpu
