// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gpu/device.h"

namespace render {

/// Work items per workgroup of kernels over lists, and the side of the workgroups of kernels over images.
inline constexpr std::uint32_t kListGroupSize = 64;
inline constexpr std::uint32_t kTileSize = 8;

/// Workgroups (x, y) that cover `count` list items within the device's limit per dimension; the kernels take
/// y·(groups in x)·kListGroupSize + x as the item's index.
struct ListGroups {
    std::uint32_t x = 0;
    std::uint32_t y = 1;
};
[[nodiscard]] ListGroups listGroups(std::uint32_t count, const gpu::Limits& limits);

/// A kernel that calls BRDFs, compiled only for those in use, because on a software device each BRDF adds to the time
/// of compilation. Keeps all pipelines it has compiled.
class BrdfPipeline {
  public:
    BrdfPipeline() = default;
    BrdfPipeline(const gpu::Device& device, std::string label, std::span<const std::uint32_t> code,
                 std::vector<gpu::BindGroupLayout> groups, std::uint32_t immediateSize);

    /// Chooses the BRDFs, bit = id in shaders/brdf/registry.h, and whether parameters vary over segments. Compiles
    /// unless there is a pipeline for them. `userCode`: the kernel with BRDFs that the user wrote, if any; it replaces
    /// the previous one.
    void use(std::uint32_t brdfs, bool driven, std::shared_ptr<const std::vector<std::uint32_t>> userCode = nullptr);
    /// The pipeline for the last choice.
    [[nodiscard]] const gpu::ComputePipeline& pipeline() const { return pipelines_.at(chosen_); }

  private:
    gpu::Device device_;
    std::string label_;
    gpu::PipelineLayout layout_;
    gpu::ShaderModule module_;
    gpu::ShaderModule userModule_;
    std::shared_ptr<const std::vector<std::uint32_t>> userCode_;
    using Choice = std::pair<std::uint32_t, bool>;
    Choice chosen_;
    std::map<Choice, gpu::ComputePipeline> pipelines_;
};

/// A pipeline whose groups have the given bindings. Every kernel that reads the scene has the geometry in group 0.
[[nodiscard]] gpu::ComputePipeline makePipeline(const gpu::Device& device, const std::string& label,
                                                std::span<const std::uint32_t> code,
                                                std::vector<gpu::BindGroupLayout> groups,
                                                std::uint32_t immediateSize = 0);

/// Group 0 of shaders/lib/geometry.glsl.
[[nodiscard]] gpu::BindGroupLayout makeGeometryLayout(const gpu::Device& device);

/// A layout for compute from (binding, type) pairs.
struct LayoutEntry {
    std::uint32_t binding;
    gpu::BindingType type;
};
[[nodiscard]] gpu::BindGroupLayout makeLayout(const gpu::Device& device, const std::string& label,
                                              std::initializer_list<LayoutEntry> entries);

/// Buffer with its first contents; at least 16 bytes, so that an empty list can be bound.
template <class T>
[[nodiscard]] gpu::Buffer makeBuffer(const gpu::Device& device, const std::string& label, gpu::BufferUsage usage,
                                     const std::vector<T>& contents) {
    gpu::Buffer buffer = device.createBuffer({.label = label,
                                              .size = std::max<std::uint64_t>(contents.size() * sizeof(T), 16),
                                              .usage = usage | gpu::BufferUsage::CopyDst | gpu::BufferUsage::CopySrc});
    if (!contents.empty()) device.queue().writeBuffer(buffer, 0, contents.data(), contents.size() * sizeof(T));
    return buffer;
}

}  // namespace render
