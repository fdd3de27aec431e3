// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/analysis_passes.h"

#include <algorithm>
#include <cstring>

#include "gpu/adapter.h"
#include "gpu/readback.h"
#include "kernels/depth_filter.h"
#include "kernels/fill_shepard.h"
#include "kernels/fit_surface.h"
#include "kernels/relax_membrane.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/depth_filter_block.h"
#include "shaders/shared/fill_shepard_block.h"
#include "shaders/shared/fit_surface_block.h"
#include "shaders/shared/relax_membrane_block.h"

namespace render {
namespace {

using enum gpu::BindingType;

constexpr std::uint64_t kLeastPixels = 1 << 13;  // of a first slice
constexpr std::uint64_t kMostPixels = 1 << 20;   // of any slice: bounds what a result takes on the device

/// A storage buffer with these bytes, rounded up to whole words. Throws gpu::Error(OutOfMemory) where the device could
/// not bind it.
gpu::Buffer uploadBytes(const gpu::Device& device, const char* label, const void* data, std::uint64_t size) {
    const gpu::Limits& limits = device.limits();
    const std::uint64_t words = std::max<std::uint64_t>((size + 3) / 4, 4);
    if (4 * words > std::min(limits.maxStorageBufferBindingSize, limits.maxBufferSize))
        throw gpu::Error(gpu::ErrorKind::OutOfMemory,
                         "The buffer \"" + std::string(label) + "\" of the analysis needs " +
                             std::to_string(4 * words) + " bytes, but the device \"" + device.adapterInfo().name +
                             "\" binds at most " +
                             std::to_string(std::min(limits.maxStorageBufferBindingSize, limits.maxBufferSize)) + ".");
    const gpu::Buffer buffer = device.createBuffer(
        {.label = label,
         .size = 4 * words,
         .usage = gpu::BufferUsage::Storage | gpu::BufferUsage::CopyDst | gpu::BufferUsage::CopySrc});
    const std::uint64_t whole = size / 4 * 4;
    if (whole > 0) device.queue().writeBuffer(buffer, 0, data, whole);
    if (whole < size) {
        std::uint32_t rest = 0;
        std::memcpy(&rest, static_cast<const char*>(data) + whole, size - whole);
        device.queue().writeBuffer(buffer, whole, &rest, sizeof(rest));
    }
    return buffer;
}

template <class T>
gpu::Buffer uploadImage(const gpu::Device& device, const char* label, const core::Image<T>& image) {
    return uploadBytes(device, label, image.data(), image.size() * sizeof(T));
}
static_assert(sizeof(core::Vector3f) == 3 * sizeof(float), "kernels read vectors as three floats");

gpu::Buffer resultBuffer(const gpu::Device& device, const char* label, std::uint64_t size) {
    return device.createBuffer({.label = label,
                                .size = std::max<std::uint64_t>(size, 16),
                                .usage = gpu::BufferUsage::Storage | gpu::BufferUsage::CopySrc});
}

void dispatchList(const gpu::Device& device, const gpu::ComputePassEncoder& pass, std::uint64_t count) {
    const ListGroups groups = listGroups(static_cast<std::uint32_t>(count), device.limits());
    pass.dispatchWorkgroups(groups.x, groups.y);
}

/// One dispatch over `count` items.
template <class Block>
void recordSlice(const gpu::CommandEncoder& encoder, const gpu::Device& device, const char* label,
                 const gpu::ComputePipeline& pipeline, const gpu::BindGroup& group, const Block& block) {
    const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = label});
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    pass.setPushConstants(block);
    dispatchList(device, pass, block.count);
    pass.end();
}

}  // namespace

DepthFilterPass::DepthFilterPass(const gpu::Device& device) : device_(device) {
    layout_ = makeLayout(device, "depth_filter",
                         {{DEPTH_FILTER_DEPTH, ReadOnlyStorageBuffer},
                          {DEPTH_FILTER_COLOR, ReadOnlyStorageBuffer},
                          {DEPTH_FILTER_LABELS, ReadOnlyStorageBuffer},
                          {DEPTH_FILTER_PARAMETERS, ReadOnlyStorageBuffer},
                          {DEPTH_FILTER_RESULT, StorageBuffer}});
    pipeline_ = makePipeline(device, "depth_filter", depth_filter_spv, {layout_}, sizeof(kernel::DepthFilterBlock));
}

DepthFilterPass::Images DepthFilterPass::upload(const core::Image<std::uint32_t>& color,
                                                const core::LabelImage& labels) const {
    return {uploadImage(device_, "filter colour", color), uploadImage(device_, "filter labels", labels)};
}

core::ImageF DepthFilterPass::run(const Images& images, const core::analysis::FilterPass& pass,
                                  const core::ImageF& inverseDepth, SliceRunner& slices,
                                  const core::Progress& progress) const {
    static_assert(std::tuple_size_v<decltype(pass.pairs)> == DEPTH_FILTER_PAIRS);
    static_assert(core::analysis::NoiseCurve::kCells == DEPTH_FILTER_CELLS);
    std::vector<float> parameters;
    for (const core::analysis::FilterPass::Pair& pair : pass.pairs)
        parameters.insert(parameters.end(),
                          {static_cast<float>(pair.dx), static_cast<float>(pair.dy), pair.weight, 0.0f});
    parameters.insert(parameters.end(), pass.range.sigma.begin(), pass.range.sigma.end());

    core::ImageF result(inverseDepth.width(), inverseDepth.height());
    const std::uint64_t most = std::min<std::uint64_t>(kMostPixels, result.size());
    const gpu::Buffer resultSlice = resultBuffer(device_, "filtered depth", most * sizeof(float));
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "depth_filter",
         .layout = layout_,
         .entries = {{.binding = DEPTH_FILTER_DEPTH, .buffer = uploadImage(device_, "filter depth", inverseDepth)},
                     {.binding = DEPTH_FILTER_COLOR, .buffer = images.color},
                     {.binding = DEPTH_FILTER_LABELS, .buffer = images.labels},
                     {.binding = DEPTH_FILTER_PARAMETERS,
                      .buffer = makeBuffer(device_, "filter parameters", gpu::BufferUsage::Storage, parameters)},
                     {.binding = DEPTH_FILTER_RESULT, .buffer = resultSlice}}});
    slices.run(progress, "depth_filter", result.size(), kLeastPixels, most,
               [&](std::uint64_t first, std::uint64_t count) {
                   const kernel::DepthFilterBlock block{.width = static_cast<kernel::uint>(result.width()),
                                                        .height = static_cast<kernel::uint>(result.height()),
                                                        .first = static_cast<kernel::uint>(first),
                                                        .count = static_cast<kernel::uint>(count),
                                                        .curveFirst = pass.range.first,
                                                        .cellsPerUnit = pass.range.cellsPerUnit,
                                                        .colorFactor = pass.colorFactor,
                                                        .pad0 = 0};
                   slices.submit("depth_filter", [&](const gpu::CommandEncoder& encoder) {
                       recordSlice(encoder, device_, "depth_filter", pipeline_, group, block);
                   });
                   gpu::readBufferBytes(device_, resultSlice, 0, result.data() + first, count * sizeof(float));
               });
    return result;
}

FitSurfacePass::FitSurfacePass(const gpu::Device& device) : device_(device) {
    layout_ = makeLayout(device, "fit_surface",
                         {{FIT_SURFACE_DEPTH, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_LABELS, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_TAPS, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_KNOWN, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_RESULT, StorageBuffer}});
    pipeline_ = makePipeline(device, "fit_surface", fit_surface_spv, {layout_}, sizeof(kernel::FitSurfaceBlock));
}

void FitSurfacePass::run(const core::analysis::SurfaceInput& input, core::Surface& surface, SliceRunner& slices,
                         const core::Progress& progress) const {
    constexpr std::uint64_t kValues = 7;
    const core::Camera& camera = input.camera;
    const core::ImageF inverseDepth = core::analysis::inverseOf(surface.depth);
    std::vector<float> taps;
    for (const core::analysis::NormalTap& tap : core::analysis::normalTaps(camera, input.relativeNoise))
        taps.insert(taps.end(), {static_cast<float>(tap.dx), static_cast<float>(tap.dy), tap.weight, tap.inverseLimit});
    const core::ImageV3 none;
    const core::ImageV3& known = input.known != nullptr ? *input.known : none;

    const std::uint64_t most = std::min<std::uint64_t>(kMostPixels, surface.depth.size());
    const gpu::Buffer resultSlice = resultBuffer(device_, "surface", most * kValues * sizeof(float));
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "fit_surface",
         .layout = layout_,
         .entries = {{.binding = FIT_SURFACE_DEPTH, .buffer = uploadImage(device_, "surface depth", inverseDepth)},
                     {.binding = FIT_SURFACE_LABELS, .buffer = uploadImage(device_, "surface labels", input.labels)},
                     {.binding = FIT_SURFACE_TAPS,
                      .buffer = makeBuffer(device_, "surface taps", gpu::BufferUsage::Storage, taps)},
                     {.binding = FIT_SURFACE_KNOWN, .buffer = uploadImage(device_, "known normals", known)},
                     {.binding = FIT_SURFACE_RESULT, .buffer = resultSlice}}});
    surface.normal = core::ImageV3(surface.depth.width(), surface.depth.height());
    surface.position = surface.normal;
    surface.area = core::ImageF(surface.depth.width(), surface.depth.height());
    std::vector<float> values;
    slices.run(progress, "fit_surface", surface.depth.size(), kLeastPixels, most,
               [&](std::uint64_t first, std::uint64_t count) {
                   const kernel::FitSurfaceBlock block{
                       .camera = {camera.fx, camera.fy, camera.cx, camera.cy},
                       .width = static_cast<kernel::uint>(surface.depth.width()),
                       .height = static_cast<kernel::uint>(surface.depth.height()),
                       .first = static_cast<kernel::uint>(first),
                       .count = static_cast<kernel::uint>(count),
                       .tapCount = static_cast<kernel::uint>(taps.size() / 4),
                       .hasKnown = input.known != nullptr ? 1u : 0u,
                       .relativeNoise = input.relativeNoise,
                       .sign = input.side == core::analysis::Side::Front ? -1.0f : 1.0f};
                   slices.submit("fit_surface", [&](const gpu::CommandEncoder& encoder) {
                       recordSlice(encoder, device_, "fit_surface", pipeline_, group, block);
                   });
                   values.resize(count * kValues);
                   gpu::readBufferBytes(device_, resultSlice, 0, values.data(), values.size() * sizeof(float));
                   for (std::uint64_t i = 0; i < count; ++i) {
                       const float* value = &values[i * kValues];
                       surface.normal[first + i] = {value[0], value[1], value[2]};
                       surface.position[first + i] = {value[3], value[4], value[5]};
                       surface.area[first + i] = value[6];
                   }
               });
}

RelaxMembranePass::RelaxMembranePass(const gpu::Device& device) : device_(device) {
    layout_ = makeLayout(device, "relax_membrane",
                         {{RELAX_MEMBRANE_ROWS, ReadOnlyStorageBuffer}, {RELAX_MEMBRANE_VALUES, StorageBuffer}});
    pipeline_ =
        makePipeline(device, "relax_membrane", relax_membrane_spv, {layout_}, sizeof(kernel::RelaxMembraneBlock));
}

void RelaxMembranePass::run(const core::ImageF& coverage, std::span<const core::analysis::MembraneRow> rows,
                            core::ImageRgb& values, SliceRunner& slices, const core::Progress& progress) const {
    std::vector<kernel::vec4> packed(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        packed[i] = {values[i].x(), values[i].y(), values[i].z(), coverage[i] > 0 ? 1.0f : 0.0f};
    std::vector<kernel::vec4> coefficients;
    for (const core::analysis::MembraneRow& row : rows)
        coefficients.emplace_back(row.up, row.down, row.side, row.scale);
    const gpu::Buffer state = uploadBytes(device_, "membrane", packed.data(), packed.size() * sizeof(kernel::vec4));
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "relax_membrane",
         .layout = layout_,
         .entries = {{.binding = RELAX_MEMBRANE_ROWS,
                      .buffer = makeBuffer(device_, "membrane rows", gpu::BufferUsage::Storage, coefficients)},
                     {.binding = RELAX_MEMBRANE_VALUES, .buffer = state}}});
    // A unit is a texel of a sweep, so that maps of all sizes share one measured cost; slices are whole sweeps.
    const std::uint64_t texels = values.size();
    const auto sweeps = static_cast<std::uint64_t>(core::analysis::kMembraneSweeps);
    std::uint64_t done = 0;
    slices.run(progress, "relax_membrane", texels * sweeps, texels, texels * sweeps,
               [&](std::uint64_t first, std::uint64_t count) {
                   const std::uint64_t last = (first + count + texels - 1) / texels;
                   slices.submit("relax_membrane", [&](const gpu::CommandEncoder& encoder) {
                       const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = "relax_membrane"});
                       pass.setPipeline(pipeline_);
                       pass.setBindGroup(0, group);
                       for (; done < last; ++done) {
                           for (kernel::uint parity = 0; parity < 2; ++parity) {
                               const kernel::RelaxMembraneBlock block{
                                   .width = static_cast<kernel::uint>(values.width()),
                                   .height = static_cast<kernel::uint>(values.height()),
                                   .parity = parity,
                                   .overRelaxation = core::analysis::kMembraneOverRelaxation};
                               pass.setPushConstants(block);
                               dispatchList(device_, pass, texels / 2);
                           }
                       }
                       pass.end();
                   });
               });
    gpu::readBufferBytes(device_, state, 0, packed.data(), packed.size() * sizeof(kernel::vec4));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(coverage[i] > 0)) values[i] = {packed[i].x, packed[i].y, packed[i].z};
}

FillShepardPass::FillShepardPass(const gpu::Device& device) : device_(device) {
    layout_ = makeLayout(device, "fill_shepard",
                         {{FILL_SHEPARD_LEVELS, ReadOnlyStorageBuffer},
                          {FILL_SHEPARD_NODES, ReadOnlyStorageBuffer},
                          {FILL_SHEPARD_TARGETS, ReadOnlyStorageBuffer},
                          {FILL_SHEPARD_RESULT, StorageBuffer}});
    pipeline_ = makePipeline(device, "fill_shepard", fill_shepard_spv, {layout_}, sizeof(kernel::FillShepardBlock));
}

void FillShepardPass::run(const core::analysis::DirectionTree& tree, core::DirectionalMap& map, SliceRunner& slices,
                          const core::Progress& progress) const {
    std::vector<kernel::uvec4> levels;
    std::vector<kernel::vec4> nodes;
    for (const core::Image<core::analysis::DirectionNode>& level : tree.levels()) {
        kernel::uvec4 entry;
        entry.x = static_cast<kernel::uint>(level.width());
        entry.y = static_cast<kernel::uint>(level.height());
        entry.z = static_cast<kernel::uint>(nodes.size() / 2);
        levels.push_back(entry);
        for (const core::analysis::DirectionNode& node : level.pixels()) {
            nodes.emplace_back(node.direction.x(), node.direction.y(), node.direction.z(), node.radius);
            nodes.emplace_back(node.radiance.x(), node.radiance.y(), node.radiance.z(), node.weight);
        }
    }
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    std::vector<std::size_t> texels;
    std::vector<kernel::vec4> targets;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (map.coverage(x, y) > 0) continue;
            const core::Vector3f d = core::DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height);
            texels.push_back(map.radiance.index(x, y));
            targets.emplace_back(d.x(), d.y(), d.z(), 0.0f);
        }
    }
    if (texels.empty()) return;
    const std::uint64_t most = std::min<std::uint64_t>(kMostPixels, texels.size());
    const gpu::Buffer resultSlice = resultBuffer(device_, "filled directions", most * sizeof(kernel::vec4));
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "fill_shepard",
         .layout = layout_,
         .entries = {
             {.binding = FILL_SHEPARD_LEVELS,
              .buffer = makeBuffer(device_, "direction levels", gpu::BufferUsage::Storage, levels)},
             {.binding = FILL_SHEPARD_NODES,
              .buffer = uploadBytes(device_, "direction nodes", nodes.data(), nodes.size() * sizeof(kernel::vec4))},
             {.binding = FILL_SHEPARD_TARGETS,
              .buffer = uploadBytes(device_, "directions", targets.data(), targets.size() * sizeof(kernel::vec4))},
             {.binding = FILL_SHEPARD_RESULT, .buffer = resultSlice}}});
    constexpr std::uint64_t kLeastTexels = 512;
    slices.run(progress, "fill_shepard", texels.size(), kLeastTexels, most,
               [&](std::uint64_t first, std::uint64_t count) {
                   const kernel::FillShepardBlock block{.levelCount = static_cast<kernel::uint>(levels.size()),
                                                        .first = static_cast<kernel::uint>(first),
                                                        .count = static_cast<kernel::uint>(count),
                                                        .opening = core::analysis::DirectionTree::kOpening,
                                                        .leastCube = core::analysis::DirectionTree::kMinCube,
                                                        .pad0 = 0,
                                                        .pad1 = 0,
                                                        .pad2 = 0};
                   slices.submit("fill_shepard", [&](const gpu::CommandEncoder& encoder) {
                       recordSlice(encoder, device_, "fill_shepard", pipeline_, group, block);
                   });
                   const auto values = gpu::readBuffer<kernel::vec4>(device_, resultSlice, 0, count);
                   for (std::uint64_t i = 0; i < count; ++i)
                       map.radiance[texels[first + i]] = {values[i].x, values[i].y, values[i].z};
               });
}

}  // namespace render
