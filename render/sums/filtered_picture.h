// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "render/bound.h"
#include "render/render_context.h"
#include "render/sums/reshade_sum.h"

namespace render {

/// One segment's sum as the edge-aware filter smooths it, made in steps over the pixels while the sum stands still.
/// Begins again when the sum restarts or the filter is switched off and on.
class FilteredPicture {
  public:
    void follow(const ReshadeSum& sum, bool enabled);
    /// Whether the next slice should be one of the filter, at 1, 4, 16, ... samples and at the end: often enough to
    /// look refined, seldom enough to cost little. `timeUp`: there will be no more samples, even amid a sweep.
    [[nodiscard]] bool due(const ReshadeSum& sum, bool timeUp) const;
    /// Samples at which the sum should pause for the filter; the largest number without.
    [[nodiscard]] std::uint32_t nextStop(const ReshadeSum& sum) const;
    /// Records the next slice; returns the device time that it will probably take [s].
    double record(const Slice& slice, const PixelList& pixels, const ReshadeSum& sum);

    [[nodiscard]] bool enabled() const { return enabled_; }
    /// Whether the composite takes the filtered picture.
    [[nodiscard]] bool shown() const { return enabled_ && samples_ > 0; }
    /// Number of pictures completed.
    [[nodiscard]] std::uint64_t version() const { return version_; }

  private:
    bool enabled_ = false;
    std::uint64_t sum_ = 0;         ///< version of the sum that is filtered
    std::uint32_t samples_ = 0;     ///< in the completed picture; 0: there is none
    int step_ = -1;                 ///< -1: no filtering in progress
    std::uint32_t pixelsDone_ = 0;  ///< in that step
    std::uint64_t version_ = 0;
    Bound<FilterPass::Groups, PixelList, Targets> groups_;
};

}  // namespace render
