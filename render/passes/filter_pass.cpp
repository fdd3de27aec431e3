// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/filter_pass.h"

#include "core/shading/image_filter.h"
#include "kernels/filter.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/filter_block.h"

namespace render {
namespace {

const core::ImageFilterParams kParams;

}  // namespace

FilterPass::FilterPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout) : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "filter",
                         {{FILTER_PIXELS, ReadOnlyStorageBuffer},
                          {FILTER_ACCUMULATION, SampledTexture},
                          {FILTER_COUNT, SampledTexture},
                          {FILTER_SOURCE, SampledTexture},
                          {FILTER_TARGET, WriteOnlyStorageTexture}});
    pipeline_ = makePipeline(device, "filter", filter_spv, {geometryLayout, layout_}, sizeof(kernel::FilterBlock));
}

int FilterPass::stepCount() { return 1 + kParams.levels; }

FilterPass::Groups FilterPass::bind(const PixelList& pixels, const Targets& targets) const {
    const auto group = [&](const gpu::Texture& source, const gpu::Texture& target) {
        return device_.createBindGroup(
            {.label = "filter",
             .layout = layout_,
             .entries = {{.binding = FILTER_PIXELS, .buffer = pixels.buffer},
                         {.binding = FILTER_ACCUMULATION, .textureView = targets.accumulation.createView()},
                         {.binding = FILTER_COUNT, .textureView = targets.count.createView()},
                         {.binding = FILTER_SOURCE, .textureView = source.createView()},
                         {.binding = FILTER_TARGET, .textureView = target.createView()}}});
    };
    return {.start = group(targets.filterPong, targets.filterPing),
            .toPong = group(targets.filterPing, targets.filterPong),
            .toPing = group(targets.filterPong, targets.filterPing),
            .pingToEnd = group(targets.filterPing, targets.filtered),
            .pongToEnd = group(targets.filterPong, targets.filtered)};
}

void FilterPass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const Groups& groups, int step,
                        std::uint32_t firstPixel, std::uint32_t pixelCount) const {
    const bool fromPing = step % 2 == 1;
    const gpu::BindGroup& group = step == 0                 ? groups.start
                                  : step == stepCount() - 1 ? (fromPing ? groups.pingToEnd : groups.pongToEnd)
                                                            : (fromPing ? groups.toPong : groups.toPing);
    const kernel::FilterBlock block{.firstPixel = firstPixel,
                                    .pixelCount = pixelCount,
                                    .level = step - 1,
                                    .normalPower = kParams.normalPower,
                                    .depthSigma = kParams.depthSigma,
                                    .luminanceSigma = kParams.luminanceSigma,
                                    .temporalSamples = core::kTemporalSamples,
                                    .pad0 = 0};
    recordList(encoder, "filter", pipeline_, geometry, group, block, pixelCount);
}

}  // namespace render
