// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/fill_shepard_pass.h"

#include <algorithm>
#include <vector>

#include "gpu/readback.h"
#include "kernels/fill_shepard.h"
#include "render/analysis/slice_buffers.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/fill_shepard_block.h"

namespace render {
namespace {

/// Texels of a first slice, whose cost is not known yet.
constexpr std::uint64_t kMinTexels = 512;

/// The tree as FILL_SHEPARD_LEVELS and FILL_SHEPARD_NODES.
struct PackedTree {
    std::vector<kernel::uvec4> levels;
    std::vector<kernel::vec4> nodes;
};

PackedTree packTree(const core::analysis::DirectionTree& tree) {
    PackedTree packed;
    for (const core::Image<core::analysis::DirectionNode>& level : tree.levels()) {
        kernel::uvec4 entry;
        entry.x = static_cast<kernel::uint>(level.width());
        entry.y = static_cast<kernel::uint>(level.height());
        entry.z = static_cast<kernel::uint>(packed.nodes.size() / 2);
        packed.levels.push_back(entry);
        for (const core::analysis::DirectionNode& node : level.pixels()) {
            packed.nodes.emplace_back(node.direction.x(), node.direction.y(), node.direction.z(), node.radius);
            packed.nodes.emplace_back(node.radiance.x(), node.radiance.y(), node.radiance.z(), node.weight);
        }
    }
    return packed;
}

struct MissingTexels {
    std::vector<std::size_t> index;
    std::vector<kernel::vec4> directions;  ///< FILL_SHEPARD_TARGETS
};

MissingTexels missingTexels(const core::DirectionalMap& map) {
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    MissingTexels missing;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (map.coverage(x, y) > 0) continue;
            const core::Vector3f d = core::DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height);
            missing.index.push_back(map.radiance.index(x, y));
            missing.directions.emplace_back(d.x(), d.y(), d.z(), 0.0f);
        }
    }
    return missing;
}

}  // namespace

FillShepardPass::FillShepardPass(const gpu::Device& device) : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "fill_shepard",
                         {{FILL_SHEPARD_LEVELS, ReadOnlyStorageBuffer},
                          {FILL_SHEPARD_NODES, ReadOnlyStorageBuffer},
                          {FILL_SHEPARD_TARGETS, ReadOnlyStorageBuffer},
                          {FILL_SHEPARD_RESULT, StorageBuffer}});
    pipeline_ = makePipeline(device, "fill_shepard", fill_shepard_spv, {layout_}, sizeof(kernel::FillShepardBlock));
}

void FillShepardPass::run(const core::analysis::DirectionTree& tree, core::DirectionalMap& map, SliceRunner& slices,
                          const core::Progress& progress) const {
    const auto [levels, nodes] = packTree(tree);
    const auto [texels, targets] = missingTexels(map);
    if (texels.empty()) return;
    const std::uint64_t most = std::min<std::uint64_t>(kMaxPixels, texels.size());
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
    slices.run(progress, "fill_shepard", texels.size(), kMinTexels, most,
               [&](std::uint64_t first, std::uint64_t count) {
                   const kernel::FillShepardBlock block{.levelCount = static_cast<kernel::uint>(levels.size()),
                                                        .first = static_cast<kernel::uint>(first),
                                                        .count = static_cast<kernel::uint>(count),
                                                        .opening = core::analysis::DirectionTree::kOpening,
                                                        .minCube = core::analysis::DirectionTree::kMinCube,
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
