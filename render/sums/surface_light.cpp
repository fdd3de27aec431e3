// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/surface_light.h"

#include <algorithm>
#include <string>
#include <utility>

#include "render/kernels/kernels.h"
#include "shaders/shared/rng.h"

namespace render {
namespace {

/// Paths of the smallest slice. Launching the kernel takes a software driver about as long.
constexpr std::uint64_t kMinPaths = 4096;

}  // namespace

bool SurfaceLight::follow(Key key) {
    if (key == key_) return false;
    key_ = std::move(key);
    lit_ = rays_ = 0;
    ++version_;
    return true;
}

std::uint32_t SurfaceLight::raysPerSample() const {
    return static_cast<std::uint32_t>(std::max(key_.raysPerSample, 1));
}

double SurfaceLight::record(const Slice& slice, std::uint16_t label, const SurfacePoints& points) {
    RenderContext& context = slice.context;
    const std::string kind = "irradiance " + std::to_string(label);
    kernel::IrradianceBlock block =
        nextPart(context.sizer.units(kind, kPathGuess, slice.seconds, kMinPaths), points.count);
    block.label = label;
    block.seed = kernel::rng_stream(key_.paths.seed, 2u * label + 1u);
    block.bounces = static_cast<std::uint32_t>(key_.paths.bounces);
    block.eta = key_.eta;
    const auto& group = group_.of([&](const auto&... from) { return context.translucency.bindIrradiance(from...); },
                                  context.paths, points);
    const std::uint64_t paths = std::uint64_t{block.pointCount} * block.rayCount;
    {
        const auto region = context.sizer.measure(slice.encoder, kind, paths);
        context.translucency.record(slice.encoder, context.geometry, group, block);
    }
    context.dropped.pathsRecorded();
    rays_ += block.rayCount;
    if (rays_ == raysPerSample()) {
        rays_ = 0;
        lit_ += block.pointCount;
    }
    return static_cast<double>(paths) * context.sizer.cost(kind, kPathGuess);
}

/// About `units` paths: all rays of several samples, or some rays of a few.
kernel::IrradianceBlock SurfaceLight::nextPart(std::uint64_t units, std::uint32_t samples) const {
    kernel::IrradianceBlock block{};
    block.firstPoint = lit_;
    block.firstRay = rays_;
    const std::uint32_t raysLeft = raysPerSample() - rays_;
    const std::uint32_t samplesLeft = samples - lit_;
    const std::uint32_t group = std::min(kListGroupSize, samplesLeft);
    if (rays_ == 0 && units >= std::uint64_t{group} * raysLeft) {
        block.rayCount = raysLeft;
        block.pointCount = static_cast<std::uint32_t>(std::min<std::uint64_t>(units / raysLeft, samplesLeft));
    } else {
        block.pointCount = group;
        block.rayCount = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(units / group, 1, raysLeft));
    }
    return block;
}

}  // namespace render
