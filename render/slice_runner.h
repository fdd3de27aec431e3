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

/// Runs long work that waits for its result in submissions of about `kMaxSliceSeconds`, so that it can be cancelled
/// and no display driver loses its patience. What a unit costs is measured and remembered by kind.
class SliceRunner {
  public:
    explicit SliceRunner(const gpu::Device& device) : device_(device) {}

    /// Does units [first, first + count), to the end: records, submits and waits.
    using Work = std::function<void(std::uint64_t first, std::uint64_t count)>;
    /// Calls `work` for consecutive parts of [0, total), each at most `most` units, with a checkpoint before each.
    /// The first one of a kind has `least` units.
    void run(const core::Progress& progress, const std::string& kind, std::uint64_t total, std::uint64_t least,
             std::uint64_t most, const Work& work);
    /// Submits what `record` writes, and waits.
    void submit(const char* label, const std::function<void(const gpu::CommandEncoder&)>& record) const;

  private:
    gpu::Device device_;
    std::map<std::string, double> costs_;  ///< [s] per unit
};

}  // namespace render
