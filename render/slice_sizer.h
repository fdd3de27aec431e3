// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "gpu/command_encoder.h"
#include "gpu/device.h"
#include "gpu/pass_timer.h"

namespace render {

/// Longest planned duration of one slice (one dispatch) on the device [s]. Keeps a window responsive and stays far
/// below the time-outs of display drivers.
inline constexpr double kMaxSliceSeconds = 0.03;

/// Decides how large the slices of a renderer's sums are, by the measured cost of a unit of each kind of work on the
/// device. (Long work of the analysis has its own rule: `SliceRunner`, which waits for each slice.)
///
/// A unit is whatever the kind counts (paths, pixel-sample pairs). Before the first measurement a kind costs its
/// `guess`. A higher measurement counts in full, a lower one half.
class SliceSizer {
  public:
    explicit SliceSizer(const gpu::Device& device);

    /// Estimated device time of one unit of `kind` [s].
    [[nodiscard]] double cost(const std::string& kind, double guess) const;
    /// Units of `kind` that take `seconds`, but no longer than one slice may take; at least `minUnits`.
    [[nodiscard]] std::uint64_t units(const std::string& kind, double guess, double seconds,
                                      std::uint64_t minUnits) const;
    /// Measures everything recorded into `encoder` until the region ends.
    [[nodiscard]] gpu::PassTimer::Region measure(const gpu::CommandEncoder& encoder, const std::string& kind,
                                                 std::uint64_t units);
    /// Evaluates the measurements that have arrived.
    void collect();

  private:
    struct Slice {
        std::string kind;
        double units = 0;
    };
    gpu::PassTimer timer_;
    std::map<std::string, double> costs_;
    std::map<std::string, Slice> inFlight_;  ///< by the region's label
    std::uint64_t nextSlice_ = 0;
};

}  // namespace render
