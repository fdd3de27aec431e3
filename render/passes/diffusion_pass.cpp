// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/diffusion_pass.h"

#include <numbers>
#include <utility>

#include "kernels/diffusion_combine.h"
#include "kernels/diffusion_gather.h"
#include "kernels/diffusion_restrict.h"
#include "kernels/diffusion_smooth.h"
#include "kernels/diffusion_splat.h"
#include "render/kernels/kernels.h"

namespace render {
namespace {

template <class Block>
void dispatch(const gpu::CommandEncoder& encoder, const char* label, const gpu::ComputePipeline& pipeline,
              const gpu::BindGroup& group, const Block& block, std::uint32_t count) {
    const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = label});
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    pass.setImmediates(0, &block, sizeof(block));
    const ListGroups groups = listGroups(count, encoder.device().limits());
    pass.dispatchWorkgroups(groups.x, groups.y);
    pass.end();
}

kernel::vec4 toKernel(const core::Vector3f& v) { return {v.x(), v.y(), v.z(), 0}; }

}  // namespace

DiffusionPass::DiffusionPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout) : device_(device) {
    using enum gpu::BindingType;
    splatLayout_ = makeLayout(device, "diffusion splat",
                              {{DIFFUSION_SPLAT_BRICKS, ReadOnlyStorageBuffer},
                               {DIFFUSION_SPLAT_STARTS, ReadOnlyStorageBuffer},
                               {DIFFUSION_SPLAT_ENTRIES, ReadOnlyStorageBuffer},
                               {DIFFUSION_SPLAT_PLACES, ReadOnlyStorageBuffer},
                               {DIFFUSION_SPLAT_SUMS, ReadOnlyStorageBuffer},
                               {DIFFUSION_SPLAT_LIGHT, StorageBuffer}});
    restrictLayout_ =
        makeLayout(device, "diffusion restrict",
                   {{DIFFUSION_RESTRICT_BRICKS, ReadOnlyStorageBuffer}, {DIFFUSION_RESTRICT_LIGHT, StorageBuffer}});
    smoothLayout_ = makeLayout(device, "diffusion smooth",
                               {{DIFFUSION_SMOOTH_BRICKS, ReadOnlyStorageBuffer},
                                {DIFFUSION_SMOOTH_FROM, ReadOnlyStorageBuffer},
                                {DIFFUSION_SMOOTH_TO, StorageBuffer}});
    combineLayout_ = makeLayout(device, "diffusion combine",
                                {{DIFFUSION_COMBINE_BRICKS, ReadOnlyStorageBuffer},
                                 {DIFFUSION_COMBINE_NARROW, ReadOnlyStorageBuffer},
                                 {DIFFUSION_COMBINE_WIDE, ReadOnlyStorageBuffer},
                                 {DIFFUSION_COMBINE_SUM, StorageBuffer}});
    gatherLayout_ = makeLayout(device, "diffusion gather",
                               {{DIFFUSION_GATHER_BRICKS, ReadOnlyStorageBuffer},
                                {DIFFUSION_GATHER_PIXELS, ReadOnlyStorageBuffer},
                                {DIFFUSION_GATHER_SUM, ReadOnlyStorageBuffer},
                                {DIFFUSION_GATHER_DIFFUSION, WriteOnlyStorageTexture}});
    splat_ = makePipeline(device, "diffusion splat", diffusion_splat_spv, {splatLayout_},
                          sizeof(kernel::DiffusionGridBlock));
    restrict_ = makePipeline(device, "diffusion restrict", diffusion_restrict_spv, {restrictLayout_},
                             sizeof(kernel::DiffusionGridBlock));
    smooth_ = makePipeline(device, "diffusion smooth", diffusion_smooth_spv, {smoothLayout_},
                           sizeof(kernel::DiffusionGridBlock));
    combine_ = makePipeline(device, "diffusion combine", diffusion_combine_spv, {combineLayout_},
                            sizeof(kernel::DiffusionCombineBlock));
    gather_ = makePipeline(device, "diffusion gather", diffusion_gather_spv, {geometryLayout, gatherLayout_},
                           sizeof(kernel::DiffusionGatherBlock));
}

DiffusionGrids DiffusionPass::upload(core::DiffusionGrid grid, const gpu::Buffer& sums, const Targets& targets) const {
    const gpu::Buffer bricks = makeBuffer(device_, "diffusion bricks", gpu::BufferUsage::Storage, grid.words);
    const gpu::Buffer starts = makeBuffer(device_, "diffusion starts", gpu::BufferUsage::Storage, grid.sampleStarts);
    const gpu::Buffer entries = makeBuffer(device_, "diffusion entries", gpu::BufferUsage::Storage, grid.samples);
    const gpu::Buffer pixels = makeBuffer(device_, "diffusion pixels", gpu::BufferUsage::Storage, grid.pixels);
    const auto cells = [&](const char* label, std::uint64_t values = 1) {
        return device_.createBuffer({.label = label,
                                     .size = values * grid.brickCount() * DIFFUSION_BRICK_CELLS * sizeof(kernel::vec4),
                                     .usage = gpu::BufferUsage::Storage});
    };
    const gpu::Buffer light = cells("diffusion light");
    const gpu::Buffer narrow = cells("diffusion light, narrow");
    const gpu::Buffer wide = cells("diffusion light, wide");
    const gpu::Buffer sum = cells("diffusion sum", 2);
    DiffusionGrids grids;
    grids.places = makeBuffer(device_, "diffusion places", gpu::BufferUsage::Storage, grid.places);
    grids.splat = device_.createBindGroup({.label = "diffusion splat",
                                           .layout = splatLayout_,
                                           .entries = {{.binding = DIFFUSION_SPLAT_BRICKS, .buffer = bricks},
                                                       {.binding = DIFFUSION_SPLAT_STARTS, .buffer = starts},
                                                       {.binding = DIFFUSION_SPLAT_ENTRIES, .buffer = entries},
                                                       {.binding = DIFFUSION_SPLAT_PLACES, .buffer = grids.places},
                                                       {.binding = DIFFUSION_SPLAT_SUMS, .buffer = sums},
                                                       {.binding = DIFFUSION_SPLAT_LIGHT, .buffer = light}}});
    grids.restrict = device_.createBindGroup({.label = "diffusion restrict",
                                              .layout = restrictLayout_,
                                              .entries = {{.binding = DIFFUSION_RESTRICT_BRICKS, .buffer = bricks},
                                                          {.binding = DIFFUSION_RESTRICT_LIGHT, .buffer = light}}});
    const auto smooth = [&](const gpu::Buffer& from, const gpu::Buffer& to) {
        return device_.createBindGroup({.label = "diffusion smooth",
                                        .layout = smoothLayout_,
                                        .entries = {{.binding = DIFFUSION_SMOOTH_BRICKS, .buffer = bricks},
                                                    {.binding = DIFFUSION_SMOOTH_FROM, .buffer = from},
                                                    {.binding = DIFFUSION_SMOOTH_TO, .buffer = to}}});
    };
    grids.toNarrow = smooth(light, narrow);
    grids.toWide = smooth(narrow, wide);
    grids.combine = device_.createBindGroup({.label = "diffusion combine",
                                             .layout = combineLayout_,
                                             .entries = {{.binding = DIFFUSION_COMBINE_BRICKS, .buffer = bricks},
                                                         {.binding = DIFFUSION_COMBINE_NARROW, .buffer = narrow},
                                                         {.binding = DIFFUSION_COMBINE_WIDE, .buffer = wide},
                                                         {.binding = DIFFUSION_COMBINE_SUM, .buffer = sum}}});
    grids.gather = device_.createBindGroup(
        {.label = "diffusion gather",
         .layout = gatherLayout_,
         .entries = {{.binding = DIFFUSION_GATHER_BRICKS, .buffer = bricks},
                     {.binding = DIFFUSION_GATHER_PIXELS, .buffer = pixels},
                     {.binding = DIFFUSION_GATHER_SUM, .buffer = sum},
                     {.binding = DIFFUSION_GATHER_DIFFUSION, .textureView = targets.diffusion.createView()}}});
    grids.pixelCount = static_cast<std::uint32_t>(grid.pixels.size());
    grid.words = {};
    grid.sampleStarts = grid.samples = {};
    grid.pixels = {};
    grids.grid = std::move(grid);
    return grids;
}

std::vector<DiffusionStep> DiffusionPass::lightSteps(const DiffusionGrids& grids) {
    using enum DiffusionStep::Kernel;
    const std::vector<core::DiffusionGrid::Level>& levels = grids.grid.levels;
    std::vector<DiffusionStep> steps;
    for (std::size_t l = 0; l < levels.size(); ++l)
        if (levels[l].count > 0)
            steps.push_back({.kernel = l == 0 ? Splat : Restrict,
                             .first = levels[l].first,
                             .count = levels[l].count,
                             .group = l == 0 ? &DiffusionGrids::splat : &DiffusionGrids::restrict});
    return steps;
}

std::vector<DiffusionStep> DiffusionPass::smoothSteps(const DiffusionGrids& grids, std::size_t first,
                                                      std::size_t last) {
    std::vector<DiffusionStep> steps;
    for (std::size_t l = first; l < last; ++l) {
        const core::DiffusionGrid::Level& level = grids.grid.levels[l];
        for (const auto group : {&DiffusionGrids::toNarrow, &DiffusionGrids::toWide}) {
            const std::uint32_t count = group == &DiffusionGrids::toWide ? level.wanted : level.near;
            if (count > 0)
                steps.push_back(
                    {.kernel = DiffusionStep::Kernel::Smooth, .first = level.first, .count = count, .group = group});
        }
    }
    return steps;
}

std::vector<DiffusionStep> DiffusionPass::sumSteps(const DiffusionGrids& grids, const core::DiffusionKernel& kernel) {
    using enum DiffusionStep::Kernel;
    const std::vector<core::DiffusionGrid::Level>& levels = grids.grid.levels;
    std::vector<DiffusionStep> steps;
    for (std::size_t l = levels.size(); l-- > kernel.finest;)
        if (levels[l].wanted > 0)
            steps.push_back({.kernel = Combine,
                             .first = levels[l].first,
                             .count = levels[l].wanted,
                             .level = static_cast<std::uint32_t>(l),
                             .group = &DiffusionGrids::combine});
    if (grids.pixelCount > 0)
        steps.push_back({.kernel = Gather,
                         .first = 0,
                         .count = grids.pixelCount,
                         .level = static_cast<std::uint32_t>(kernel.finest),
                         .group = &DiffusionGrids::gather});
    return steps;
}

void DiffusionPass::setAreas(DiffusionGrids& grids, std::span<const float> areas) const {
    std::vector<kernel::vec4>& places = grids.grid.places;
    for (std::size_t i = 0; i < places.size(); ++i) places[i].w = i < areas.size() ? areas[i] : 0.0f;
    if (!places.empty()) device_.queue().writeBuffer(grids.places, 0, places.data(), places.size() * sizeof(places[0]));
}

void DiffusionPass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const DiffusionGrids& grids,
                           const DiffusionStep& step, std::uint32_t first, std::uint32_t count, std::uint32_t rays,
                           const core::DiffusionKernel& kernel) const {
    const gpu::BindGroup& group = grids.*step.group;
    const char* name = nameOf(step.kernel);
    kernel::DiffusionGridBlock bricks{.firstBrick = step.first + first,
                                      .brickCount = count,
                                      .levelFirst = grids.grid.levels[0].first,
                                      .scale = std::numbers::pi_v<float> / static_cast<float>(rays)};
    switch (step.kernel) {
        case DiffusionStep::Kernel::Splat:
            dispatch(encoder, name, splat_, group, bricks, count * DIFFUSION_BRICK_CELLS);
            break;
        case DiffusionStep::Kernel::Restrict:
            dispatch(encoder, name, restrict_, group, bricks, count * DIFFUSION_BRICK_CELLS);
            break;
        case DiffusionStep::Kernel::Smooth:
            dispatch(encoder, name, smooth_, group, bricks, count * DIFFUSION_BRICK_CELLS);
            break;
        case DiffusionStep::Kernel::Combine: {
            const kernel::DiffusionCombineBlock block{
                .narrow = toKernel(kernel.narrow[step.level]),
                .wide = toKernel(kernel.wide[step.level]),
                .firstBrick = step.first + first,
                .brickCount = count,
                .coarser = step.level + 1 < grids.grid.levels.size() ? 1.0f : 0.0f,
                .pad0 = 0};
            dispatch(encoder, name, combine_, group, block, count * DIFFUSION_BRICK_CELLS);
            break;
        }
        case DiffusionStep::Kernel::Gather: {
            const std::array<double, 3>& corner = grids.grid.corner;
            const kernel::DiffusionGatherBlock block{
                .corner = {static_cast<float>(corner[0]), static_cast<float>(corner[1]), static_cast<float>(corner[2]),
                           static_cast<float>(grids.grid.cellOf(step.level))},
                .flatSurface = toKernel(kernel.flat.integral),
                .tolerance = toKernel(kernel.flat.tolerance),
                .firstPixel = first,
                .pixelCount = count,
                .level = step.level,
                .known = 1};
            recordList(encoder, name, gather_, geometry, group, block, count);
            break;
        }
    }
}

void DiffusionPass::recordClear(const gpu::CommandEncoder& encoder, SceneGeometry& geometry,
                                const DiffusionGrids& grids) const {
    kernel::DiffusionGatherBlock block{};
    block.pixelCount = grids.pixelCount;
    if (block.pixelCount > 0)
        recordList(encoder, "diffusion clear", gather_, geometry, grids.gather, block, block.pixelCount);
}

std::uint64_t accessesPerItem(DiffusionStep::Kernel kernel) {
    switch (kernel) {
        case DiffusionStep::Kernel::Splat:
            return 10 * DIFFUSION_BRICK_CELLS;
        case DiffusionStep::Kernel::Restrict:
            return 64 * DIFFUSION_BRICK_CELLS;
        case DiffusionStep::Kernel::Smooth:
            return 40 * DIFFUSION_BRICK_CELLS;
        case DiffusionStep::Kernel::Combine:
            return 18 * DIFFUSION_BRICK_CELLS;
        case DiffusionStep::Kernel::Gather:
            return 54;
    }
    return 1;
}

const char* nameOf(DiffusionStep::Kernel kernel) {
    switch (kernel) {
        case DiffusionStep::Kernel::Splat:
            return "diffusion splat";
        case DiffusionStep::Kernel::Restrict:
            return "diffusion restrict";
        case DiffusionStep::Kernel::Smooth:
            return "diffusion smooth";
        case DiffusionStep::Kernel::Combine:
            return "diffusion combine";
        case DiffusionStep::Kernel::Gather:
            return "diffusion gather";
    }
    return "";
}

}  // namespace render
