// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "core/base/progress.h"
#include "gpu/command_encoder.h"
#include "gpu/device.h"

namespace render {

/// Runs long work in submissions of about `kMaxSliceSeconds` and waits for each, so that it can be cancelled and stays
/// below the time-outs of display drivers. Sizes each by the cost of a unit, which it measures and
/// remembers by kind. (For the sums of a renderer, which never wait, see `SliceSizer`.)
class SliceRunner {
  public:
    explicit SliceRunner(const gpu::Device& device) : device_(device) {}

    /// Records units [first, first + count), submits them and waits.
    using Work = std::function<void(std::uint64_t first, std::uint64_t count)>;
    /// Calls `work` for consecutive parts of [0, total), each at most `maxUnits`, with a checkpoint before each.
    /// The first part of a kind has `minUnits`.
    void run(const core::Progress& progress, const std::string& kind, std::uint64_t total, std::uint64_t minUnits,
             std::uint64_t maxUnits, const Work& work);
    /// Submits what `record` writes, and waits.
    void submit(const char* label, const std::function<void(const gpu::CommandEncoder&)>& record) const;

  private:
    gpu::Device device_;
    std::map<std::string, double> costs_;  ///< [s] per unit
};

}  // namespace render
