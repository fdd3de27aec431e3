// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/filtered_picture.h"

#include <algorithm>
#include <limits>
#include <string>

#include "render/kernels/kernels.h"

namespace render {
namespace {

/// Assumed cost of one pixel in one step before any was measured [s].
constexpr double kFilterGuess = 1e-5;

/// Each filtered picture has this many times the samples of the one before.
constexpr std::uint32_t kSampleGrowth = 4;

}  // namespace

void FilteredPicture::follow(const ReshadeSum& sum, bool enabled) {
    if (sum.version() != sum_) samples_ = 0;
    if (sum.version() != sum_ || !enabled) step_ = -1;
    sum_ = sum.version();
    enabled_ = enabled;
}

bool FilteredPicture::due(const ReshadeSum& sum, bool timeUp) const {
    if (!enabled_) return false;
    if (step_ >= 0) return true;
    if (sum.samples() == samples_) return false;
    if (timeUp) return true;
    if (!sum.betweenSweeps()) return false;
    return sum.samples() == sum.target() || (sum.samples() >= 1 && sum.samples() >= kSampleGrowth * samples_);
}

std::uint32_t FilteredPicture::nextStop(const ReshadeSum& sum) const {
    constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
    if (!enabled_) return kNever;
    const std::uint32_t stop = sum.samples() == 0 ? 1 : kSampleGrowth * samples_;
    return stop > sum.samples() ? stop : kNever;
}

double FilteredPicture::record(const Slice& slice, const PixelList& pixels, const ReshadeSum& sum) {
    RenderContext& context = slice.context;
    // The first step costs more than the others.
    const std::string kind = step_ <= 0 ? "filter start" : "filter";
    if (step_ < 0) {
        step_ = 0;
        pixelsDone_ = 0;
    }
    const std::uint64_t units = context.sizer.units(kind, kFilterGuess, slice.seconds, kListGroupSize);
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(units, pixels.count - pixelsDone_));
    const auto& groups =
        groups_.of([&](const auto&... from) { return context.filter.bind(from...); }, pixels, context.targets);
    {
        const auto region = context.sizer.measure(slice.encoder, kind, count);
        context.filter.record(slice.encoder, context.geometry, groups, step_, pixelsDone_, count);
    }
    pixelsDone_ += count;
    if (pixelsDone_ == pixels.count) {
        pixelsDone_ = 0;
        ++step_;
    }
    if (step_ == FilterPass::stepCount()) {
        step_ = -1;
        samples_ = sum.samples();
        ++version_;
    }
    return count * context.sizer.cost(kind, kFilterGuess);
}

}  // namespace render
