// SPDX-License-Identifier: GPL-3.0-or-later
// Light below the surfaces of translucent segments: surface samples, their light, and its sum over them.
#include <future>
#include <iterator>

#include "core/base/parallel.h"
#include "core/shading/surface_samples.h"
#include "render/renderer_impl.h"
#include "shaders/shared/rng.h"

namespace render {
namespace {

constexpr double kAccessGuess = 1e-8;  // [s], as kPathGuess: one access to the grids of light below a surface

// What starting this kernel costs a software driver is as much as these paths; smaller slices would mean only that.
constexpr std::uint64_t kMinIrradiancePaths = 4096;
constexpr std::uint64_t kMinAccesses = 200000;  // likewise

}  // namespace

void Renderer::Impl::prepareTranslucency(SegmentState& state) {
    const bool made = state.pendingPoints.valid() &&
                      state.pendingPoints.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (made) {
        SurfaceGrids grids = state.pendingPoints.get();
        if (!state.pointsStale) {
            state.surface = std::move(grids.surface);
            state.points = translucency.upload(state.surface);
            state.grids = diffusion.upload(std::move(grids.grid), state.points.sums, targets);
            state.irradianceGroup = {};
            state.restartLight();
        }
    }
    if (state.pointsStale && !state.pendingPoints.valid()) {
        state.pointsStale = false;
        state.points = {};
        state.pendingPoints =
            core::inBackground([photo = scene.photo, from = analysis, label = state.label, params = scene.render] {
                return makeSurfaceGrids(*photo, *from, label, params);
            });
    }
    if (!state.irradianceGroup && state.points.count > 0)
        state.irradianceGroup = translucency.bindIrradiance(paths, state.points);
}

/// With nothing else to do: true when samples of some segment are still being made, after waiting a little for them.
bool Renderer::Impl::awaitPoints(double seconds) {
    for (SegmentState& state : segments) {
        if (!state.translucent() || !state.pendingPoints.valid()) continue;
        state.pendingPoints.wait_for(std::chrono::duration<double>(seconds));
        return true;
    }
    return false;
}

double Renderer::Impl::recordIrradiance(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    const std::string kind = "irradiance " + std::to_string(state.label);
    const std::uint64_t units = timer.units(kind, kPathGuess, seconds, kMinIrradiancePaths);
    kernel::IrradianceBlock block{};
    block.firstPoint = state.litPoints;
    block.firstRay = state.litRays;
    const std::uint32_t raysLeft = rays() - state.litRays;
    const std::uint32_t pointsLeft = state.points.count - state.litPoints;
    const std::uint32_t group = std::min(kListGroupSize, pointsLeft);
    if (state.litRays == 0 && units >= std::uint64_t{group} * raysLeft) {
        block.rayCount = raysLeft;
        block.pointCount = static_cast<std::uint32_t>(std::min<std::uint64_t>(units / raysLeft, pointsLeft));
    } else {
        block.pointCount = group;
        block.rayCount = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(units / group, 1, raysLeft));
    }
    block.label = state.label;
    block.seed = kernel::rng_stream(scene.render.seed, 2u * state.label + 1u);
    block.bounces = positive(scene.render.bounces);
    block.eta = state.irradianceKey.eta;
    const std::uint64_t paths_ = std::uint64_t{block.pointCount} * block.rayCount;
    {
        const auto region = timer.measure(encoder, kind, paths_);
        translucency.record(encoder, geometry, state.irradianceGroup, block);
    }
    state.litRays += block.rayCount;
    if (state.litRays == rays()) {
        state.litRays = 0;
        state.litPoints += block.pointCount;
    }
    dropped->dirty = true;
    return static_cast<double>(paths_) * timer.cost(kind, kPathGuess);
}

/// Before the first slice of a sum: what has to be done for it.
void Renderer::Impl::prepareGather(const gpu::CommandEncoder& encoder, SegmentState& state) {
    state.gatherTarget = state.gatherable();
    state.gatherSteps.clear();
    state.gatherStep = 0;
    state.gatherCursor = 0;
    if (state.gridPoints != state.gatherTarget) {
        diffusion.setAreas(state.grids, core::sampleAreas(state.surface, state.gatherTarget));
        state.gatherSteps = DiffusionPass::lightSteps(state.grids);
        state.gridPoints = 0;
        state.smoothedFrom = state.grids.grid.levels.size();
    }
    state.lightSteps = state.gatherSteps.size();
    const double spacing = state.grids.grid.spacing;
    const double area = std::max(state.points.area / state.gatherTarget, spacing * spacing);
    state.diffusionKernel = core::fitDiffusionKernel(
        core::blurred(core::profileFromTranslucency(state.scattering), area), state.grids.grid);
    std::ranges::copy(DiffusionPass::smoothSteps(state.grids, state.diffusionKernel.finest, state.smoothedFrom),
                      std::back_inserter(state.gatherSteps));
    state.smoothSteps = state.gatherSteps.size();
    std::ranges::copy(DiffusionPass::sumSteps(state.grids, state.diffusionKernel),
                      std::back_inserter(state.gatherSteps));
    if (!state.diffusionFresh) return;
    diffusion.recordClear(encoder, geometry, state.grids);
    state.diffusionFresh = false;
}

double Renderer::Impl::recordGather(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    if (state.gatherTarget == 0) prepareGather(encoder, state);
    double spent = 0;
    if (state.gatherStep < state.gatherSteps.size()) {
        const DiffusionStep& step = state.gatherSteps[state.gatherStep];
        const std::string kind = nameOf(step.kernel);
        const std::uint64_t accesses = accessesPerItem(step.kernel);
        const double guess = kAccessGuess * static_cast<double>(accesses);
        const std::uint64_t units = timer.units(kind, guess, seconds, kMinAccesses / accesses);
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(units, step.count - state.gatherCursor));
        {
            const auto region = timer.measure(encoder, kind, count);
            diffusion.record(encoder, geometry, state.grids, step, state.gatherCursor, count, rays(),
                             state.diffusionKernel);
        }
        spent = count * timer.cost(kind, guess);
        state.gatherCursor += count;
        if (state.gatherCursor == step.count) {
            state.gatherCursor = 0;
            ++state.gatherStep;
        }
    }
    if (state.gatherStep >= state.lightSteps) state.gridPoints = state.gatherTarget;
    if (state.gatherStep >= state.smoothSteps)
        state.smoothedFrom = std::min(state.smoothedFrom, state.diffusionKernel.finest);
    if (state.gatherStep == state.gatherSteps.size()) {
        state.gathered = state.gatherTarget;
        state.gatherTarget = 0;
        state.compositeStale = true;
    }
    return spent;
}

}  // namespace render
