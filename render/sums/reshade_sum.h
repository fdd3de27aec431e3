// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "render/bound.h"
#include "render/render_context.h"
#include "render/sums/path_key.h"

namespace render {

/// The running sum of one segment's paths: whole sweeps over its pixels, and a partial one. Restarts exactly when its
/// key changes or it has more samples than are asked for.
class ReshadeSum {
  public:
    /// Restarts the sum or does nothing; true if it restarted. `target`: samples per pixel, at least 1.
    ///
    /// The sweep continues from where it stands, so that every pixel has its turn however often this happens; until
    /// then a pixel keeps the old sum.
    bool follow(PathKey key, std::uint32_t target);

    struct Advance {
        PixelRange pixels;   ///< those whose sum grew
        double seconds = 0;  ///< device time that will probably take
    };
    /// Records the next slice: part of a sweep, or whole sweeps up to `stopAt` samples.
    Advance record(const Slice& slice, std::uint16_t label, const PixelList& pixels, std::uint32_t stopAt);

    [[nodiscard]] std::uint32_t samples() const { return samples_; }  ///< completed, per pixel
    [[nodiscard]] std::uint32_t target() const { return target_; }
    [[nodiscard]] bool complete() const { return samples_ >= target_; }
    [[nodiscard]] bool betweenSweeps() const { return sweep_.done == 0; }
    /// Completed samples and the current sweep's share.
    [[nodiscard]] double progress() const;
    /// Pixels, from the begin of the list on, that have ever had a sum; the others show the photograph.
    [[nodiscard]] std::uint32_t reached() const { return reached_; }
    /// Number of restarts.
    [[nodiscard]] std::uint64_t version() const { return version_; }

  private:
    /// One pass over the pixel list, in a circle.
    struct Sweep {
        std::uint32_t count = 0;  ///< pixels in the list; 0 before the first slice
        std::uint32_t start = 0;  ///< where in the list it began
        std::uint32_t done = 0;   ///< pixels
    };
    [[nodiscard]] PixelRange nextPixels(std::uint64_t most) const;
    void advance(const PixelRange& range, std::uint32_t samples);

    PathKey key_;
    std::uint32_t target_ = 0;
    std::uint32_t samples_ = 0;
    Sweep sweep_;
    std::uint32_t reached_ = 0;
    std::uint64_t version_ = 0;
    Bound<gpu::BindGroup, PathInputs, PixelList, Targets> group_;
};

}  // namespace render
