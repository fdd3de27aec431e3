// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/slice_runner.h"

#include <algorithm>

#include "core/base/clock.h"
#include "render/slice_sizer.h"

namespace render {

void SliceRunner::run(const core::Progress& progress, const std::string& kind, std::uint64_t total,
                      std::uint64_t minUnits, std::uint64_t maxUnits, const Work& work) {
    constexpr double kGrowth =
        8;  // at most, from one slice to the next; the first ones include the cost of starting up
    double last = 0;
    for (std::uint64_t first = 0; first < total;) {
        progress.checkpoint(static_cast<float>(first) / static_cast<float>(total));
        const auto known = costs_.find(kind);
        double wish = known == costs_.end() ? static_cast<double>(minUnits) : kMaxSliceSeconds / known->second;
        if (last > 0) wish = std::min(wish, kGrowth * last);
        const auto count = std::min(
            {static_cast<std::uint64_t>(std::max(wish, static_cast<double>(minUnits))), maxUnits, total - first});
        const auto start = core::Clock::now();
        work(first, count);
        costs_[kind] = std::max(core::secondsSince(start), 1e-6) / static_cast<double>(count);
        last = static_cast<double>(count);
        first += count;
    }
}

void SliceRunner::submit(const char* label, const std::function<void(const gpu::CommandEncoder&)>& record) const {
    const gpu::CommandEncoder encoder = device_.createCommandEncoder({.label = label});
    record(encoder);
    device_.queue().submit(encoder.finish());
    device_.waitIdle();
}

}  // namespace render
