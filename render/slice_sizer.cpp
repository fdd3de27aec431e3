// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/slice_sizer.h"

#include <algorithm>

namespace render {

SliceSizer::SliceSizer(const gpu::Device& device) : timer_(device, 256) {}

double SliceSizer::cost(const std::string& kind, double guess) const {
    const auto known = costs_.find(kind);
    return known == costs_.end() ? guess : known->second;
}

std::uint64_t SliceSizer::units(const std::string& kind, double guess, double seconds, std::uint64_t minUnits) const {
    const double count = std::clamp(seconds, 0.0, kMaxSliceSeconds) / cost(kind, guess);
    return std::max(minUnits, static_cast<std::uint64_t>(std::min(count, 1e15)));
}

gpu::PassTimer::Region SliceSizer::measure(const gpu::CommandEncoder& encoder, const std::string& kind,
                                           std::uint64_t units) {
    std::string label = kind + " #" + std::to_string(nextSlice_++);
    inFlight_[label] = {kind, static_cast<double>(std::max<std::uint64_t>(units, 1))};
    return timer_.measure(encoder, std::move(label));
}

void SliceSizer::collect() {
    for (const gpu::PassTimer::Timing& timing : timer_.takeResults()) {
        const auto slice = inFlight_.find(timing.label);
        if (slice == inFlight_.end()) continue;
        const double measured = std::max(timing.seconds, 1e-7) / slice->second.units;
        // Costs rise at once and fall by halves, because slices that are too long can be felt and short ones cannot.
        double& cost = costs_.try_emplace(slice->second.kind, measured).first->second;
        cost = std::max(measured, 0.5 * (cost + measured));
        inFlight_.erase(slice);
    }
    // Regions that the timer had no room for are never reported.
    while (inFlight_.size() > 1024) inFlight_.erase(inFlight_.begin());
}

}  // namespace render
