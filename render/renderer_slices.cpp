// SPDX-License-Identifier: GPL-3.0-or-later
// Slices of re-shading and filter, and the composite.
#include <optional>

#include "render/renderer_impl.h"

namespace render {
namespace {

constexpr double kFilterGuess = 1e-5;  // [s], as kPathGuess: one pixel in one step of the filter

constexpr std::uint32_t kMaxPathsPerDispatch = 16;  // per pixel: bounds what one invocation may take

}  // namespace

double Renderer::Impl::recordReshade(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    const std::string kind = "reshade " + std::to_string(state.label);
    kernel::ReshadeBlock block{};
    block.seed = scene.render.seed;
    block.bounces = positive(scene.render.bounces);
    const std::uint64_t units = timer.units(kind, kPathGuess, seconds, kListGroupSize);
    const PixelRange range = state.nextPixels(units);
    block.firstPixel = range.first;
    block.firstSample = state.samples;
    block.pixelCount = range.count;
    block.sampleCount = 1;
    if (block.pixelCount == state.pixels.count) {
        // At least two slices' worth of whole sweeps; stops where the filter wants a look.
        std::uint32_t left = targetSamples() - state.samples;
        if (scene.render.filter) {
            const std::uint32_t milestone = state.samples == 0 ? 1 : 4 * state.filteredSamples;
            if (milestone > state.samples) left = std::min(left, milestone - state.samples);
        }
        const auto sweeps = static_cast<std::uint32_t>(std::min<std::uint64_t>(units / state.pixels.count, 1u << 20));
        block.sampleCount = std::clamp(sweeps, 1u, std::min(left, kMaxPathsPerDispatch));
    }
    const std::uint64_t paths_ = std::uint64_t{block.pixelCount} * block.sampleCount;
    {
        const auto region = timer.measure(encoder, kind, paths_);
        reshade.record(encoder, geometry, state.reshadeGroup, block);
    }
    state.cursor += range.count;
    if (range.first <= state.reached) state.reached = std::max(state.reached, range.first + range.count);
    if (state.cursor == state.pixels.count) {
        state.cursor = state.sweepStart = 0;
        state.samples += block.sampleCount;
    }
    // A filtered picture stays on show until the next one is ready.
    if (!scene.render.filter || state.filteredSamples == 0) state.advanced.push_back(range);
    dropped->dirty = true;
    return static_cast<double>(paths_) * timer.cost(kind, kPathGuess);
}

double Renderer::Impl::recordFilter(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    const std::string kind = state.filterStep <= 0 ? "filter start" : "filter";
    if (state.filterStep < 0) {
        state.filterStep = 0;
        state.filterCursor = 0;
    }
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(
        timer.units(kind, kFilterGuess, seconds, kListGroupSize), state.pixels.count - state.filterCursor));
    {
        const auto region = timer.measure(encoder, kind, count);
        filter.record(encoder, geometry, state.filterGroups, state.filterStep, state.filterCursor, count);
    }
    state.filterCursor += count;
    if (state.filterCursor == state.pixels.count) {
        state.filterCursor = 0;
        if (++state.filterStep == FilterPass::stepCount()) {
            state.filterStep = -1;
            state.filteredSamples = state.samples;
            state.compositeStale = true;
        }
    }
    return count * timer.cost(kind, kFilterGuess);
}

void Renderer::Impl::recordComposite(const gpu::CommandEncoder& encoder, SegmentState& state) {
    if (state.compositeStale) state.advanced = {{0, state.reached}};
    state.compositeStale = false;
    const core::Material& material = state.material;
    kernel::CompositeBlock block{.firstPixel = 0,
                                 .pixelCount = 0,
                                 .filtered = scene.render.filter && state.filteredSamples > 0 ? 1u : 0u,
                                 .blendNew = material.blendNew,
                                 .blendOriginal = material.blendOriginal,
                                 .translucentWeight = state.translucent() ? material.translucency->weight : 0.0f,
                                 .eta = state.irradianceKey.eta,
                                 .translucent = state.translucent() ? 1u : 0u,
                                 .firstDrive = shading[state.label].drives.z,
                                 .driveCount = shading[state.label].drives.w,
                                 .pad0 = 0,
                                 .pad1 = 0};
    for (const PixelRange& range : std::exchange(state.advanced, {})) {
        if (range.count == 0) continue;
        block.firstPixel = range.first;
        block.pixelCount = range.count;
        // Of a few pixels it costs mostly its start, which tells nothing of a whole one.
        std::optional<gpu::PassTimer::Region> region;
        if (range.count == state.pixels.count) region.emplace(timer.measure(encoder, "composite", range.count));
        composite.record(encoder, geometry, state.compositeGroup, block);
    }
    changed.include(state.pixels.bounds);
    if (state.reached < state.pixels.count) return;
    changed.include(state.silhouette.bounds);
    silhouette.record(encoder, geometry, state.silhouetteGroup,
                      {.pixelCount = state.silhouette.count,
                       .blendOriginal = material.blendOriginal,
                       .firstDrive = block.firstDrive,
                       .driveCount = block.driveCount});
}

void Renderer::Impl::recordDroppedReadback(const gpu::CommandEncoder& encoder) {
    dropped->dirty = false;
    dropped->pending = true;
    encoder.copyBufferToBuffer(paths.dropped, 0, dropped->staging, 0, sizeof(kernel::uint));
    encoder.onCompleted([reader = dropped] {
        reader->staging.mapAsync(
            gpu::MapMode::Read, 0, gpu::kWholeSize, [reader](gpu::MapAsyncStatus status, std::string_view) {
                reader->pending = false;
                if (status != gpu::MapAsyncStatus::Success) return;
                reader->value = *static_cast<const kernel::uint*>(reader->staging.getConstMappedRange());
                reader->staging.unmap();
            });
    });
}

}  // namespace render
