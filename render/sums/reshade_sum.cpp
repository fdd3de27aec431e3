// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/reshade_sum.h"

#include <algorithm>
#include <string>
#include <utility>

#include "render/kernels/kernels.h"

namespace render {
namespace {

/// Paths per pixel in one dispatch; bounds the time of one invocation.
constexpr std::uint32_t kMaxPathsPerDispatch = 16;

}  // namespace

bool ReshadeSum::follow(PathKey key, std::uint32_t target) {
    target_ = target;
    if (key == key_ && samples_ <= target) return false;
    key_ = std::move(key);
    samples_ = 0;
    if (sweep_.count > 0) sweep_.start = (sweep_.start + sweep_.done) % sweep_.count;
    sweep_.done = 0;
    ++version_;
    return true;
}

ReshadeSum::Advance ReshadeSum::record(const Slice& slice, std::uint16_t label, const PixelList& pixels,
                                       std::uint32_t stopAt) {
    RenderContext& context = slice.context;
    const std::string kind = "reshade " + std::to_string(label);
    sweep_.count = pixels.count;
    const std::uint64_t units = context.sizer.units(kind, kPathGuess, slice.seconds, kListGroupSize);
    const PixelRange range = nextPixels(units);
    std::uint32_t samples = 1;
    if (range.count == pixels.count) {
        const auto sweeps = static_cast<std::uint32_t>(std::min<std::uint64_t>(units / pixels.count, 1u << 20));
        const std::uint32_t left = std::min(stopAt, target_) - samples_;
        samples = std::clamp(sweeps, 1u, std::min(left, kMaxPathsPerDispatch));
    }
    kernel::ReshadeBlock block{};
    block.seed = key_.seed;
    block.bounces = static_cast<std::uint32_t>(key_.bounces);
    block.firstPixel = range.first;
    block.firstSample = samples_;
    block.pixelCount = range.count;
    block.sampleCount = samples;
    const auto& group = group_.of([&](const auto&... from) { return context.reshade.bind(from...); }, context.paths,
                                  pixels, context.targets);
    const std::uint64_t paths = std::uint64_t{range.count} * samples;
    {
        const auto region = context.sizer.measure(slice.encoder, kind, paths);
        context.reshade.record(slice.encoder, context.geometry, group, block);
    }
    context.dropped.pathsRecorded();
    advance(range, samples);
    return {range, static_cast<double>(paths) * context.sizer.cost(kind, kPathGuess)};
}

/// Up to `most` pixels that the current sweep takes next.
PixelRange ReshadeSum::nextPixels(std::uint64_t most) const {
    const std::uint32_t first = (sweep_.start + sweep_.done) % sweep_.count;
    const std::uint32_t left = std::min(sweep_.count - sweep_.done, sweep_.count - first);
    return {first, static_cast<std::uint32_t>(std::min<std::uint64_t>(most, left))};
}

void ReshadeSum::advance(const PixelRange& range, std::uint32_t samples) {
    sweep_.done += range.count;
    if (range.first <= reached_) reached_ = std::max(reached_, range.first + range.count);
    if (sweep_.done < sweep_.count) return;
    sweep_.done = sweep_.start = 0;
    samples_ += samples;
}

double ReshadeSum::progress() const {
    const double sweep = sweep_.count > 0 ? static_cast<double>(sweep_.done) / sweep_.count : 0;
    return samples_ + sweep;
}

}  // namespace render
