// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/depth_filter_pass.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "gpu/readback.h"
#include "kernels/depth_filter.h"
#include "render/analysis/slice_buffers.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/depth_filter_block.h"

namespace render {

DepthFilterPass::DepthFilterPass(const gpu::Device& device) : device_(device) {
    using enum gpu::BindingType;
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
    const std::uint64_t most = std::min<std::uint64_t>(kMaxPixels, result.size());
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
    slices.run(progress, "depth_filter", result.size(), kMinPixels, most,
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

}  // namespace render
