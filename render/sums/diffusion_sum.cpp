// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/diffusion_sum.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "core/material/diffusion_profile.h"
#include "core/material/translucency.h"
#include "core/shading/diffusion_grid.h"
#include "core/shading/surface_samples.h"

namespace render {
namespace {

/// Assumed cost of one access to the grids before any was measured [s].
constexpr double kAccessGuess = 1e-8;

/// Accesses of the smallest slice. Launching a kernel takes a software driver about as long.
constexpr std::uint64_t kMinAccesses = 200000;

/// Samples in the largest sum that can be made now; 0: too few are lit.
std::uint32_t summableSamples(std::uint32_t lit, std::uint32_t all) {
    for (const std::uint32_t part : {1U, 8U, 64U})
        if (lit >= std::max(all / part, 1U)) return all / part;
    return 0;
}

}  // namespace

bool DiffusionSum::follow(const SurfaceLight& light, const core::Translucency& translucency) {
    Key key{light.version(), translucency};
    key.scattering.weight = 1;
    key.scattering.preset.clear();
    if (key == key_) return false;
    if (key.light != key_.light) {
        gridSamples_ = 0;
        cleared_ = false;
    }
    key_ = std::move(key);
    target_ = samples_ = 0;
    return true;
}

bool DiffusionSum::due(const SurfaceLight& light, const SurfacePoints& points) const {
    return target_ > 0 || summableSamples(light.litSamples(), points.count) > samples_;
}

double DiffusionSum::record(const Slice& slice, SampledSurface& surface, const SurfaceLight& light) {
    if (target_ == 0) begin(slice, surface, light);
    const double seconds = step_ < steps_.size() ? recordStep(slice, surface.grids(), light.raysPerSample()) : 0;
    noteProgress();
    return seconds;
}

/// Plans the steps of the next sum; leaves out those whose results the last one has left in the grids.
void DiffusionSum::begin(const Slice& slice, SampledSurface& surface, const SurfaceLight& light) {
    const DiffusionPass& pass = slice.context.diffusion;
    DiffusionGrids& grids = surface.grids();
    target_ = summableSamples(light.litSamples(), surface.points().count);
    steps_.clear();
    step_ = 0;
    itemsDone_ = 0;
    if (gridSamples_ != target_) {
        pass.setAreas(grids, core::sampleAreas(surface.samples(), target_));
        steps_ = DiffusionPass::lightSteps(grids);
        gridSamples_ = 0;
        smoothFrom_ = grids.grid.levels.size();
    }
    lightSteps_ = steps_.size();
    const double spacing = grids.grid.spacing;
    const double area = std::max(surface.points().area / target_, spacing * spacing);
    kernel_ = core::fitDiffusionKernel(core::blurred(core::profileFromTranslucency(key_.scattering), area), grids.grid);
    std::ranges::copy(DiffusionPass::smoothSteps(grids, kernel_.finest, smoothFrom_), std::back_inserter(steps_));
    smoothSteps_ = steps_.size();
    std::ranges::copy(DiffusionPass::sumSteps(grids, kernel_), std::back_inserter(steps_));
    if (cleared_) return;
    pass.recordClear(slice.encoder, slice.context.geometry, grids);
    cleared_ = true;
}

double DiffusionSum::recordStep(const Slice& slice, const DiffusionGrids& grids, std::uint32_t rays) {
    RenderContext& context = slice.context;
    const DiffusionStep& step = steps_[step_];
    const std::string kind = nameOf(step.kernel);
    const std::uint64_t accesses = accessesPerItem(step.kernel);
    const double guess = kAccessGuess * static_cast<double>(accesses);
    const std::uint64_t units = context.sizer.units(kind, guess, slice.seconds, kMinAccesses / accesses);
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(units, step.count - itemsDone_));
    {
        const auto region = context.sizer.measure(slice.encoder, kind, count);
        context.diffusion.record(slice.encoder, context.geometry, grids, step, itemsDone_, count, rays, kernel_);
    }
    itemsDone_ += count;
    if (itemsDone_ == step.count) {
        itemsDone_ = 0;
        ++step_;
    }
    return count * context.sizer.cost(kind, guess);
}

void DiffusionSum::noteProgress() {
    if (step_ >= lightSteps_) gridSamples_ = target_;
    if (step_ >= smoothSteps_) smoothFrom_ = std::min(smoothFrom_, kernel_.finest);
    if (step_ < steps_.size()) return;
    samples_ = target_;
    target_ = 0;
    ++version_;
}

}  // namespace render
