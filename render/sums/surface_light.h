// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "render/bound.h"
#include "render/render_context.h"
#include "render/sums/path_key.h"

namespace render {

/// Light that enters a translucent segment at its surface samples, which are lit in order. Restarts exactly when its
/// key changes.
class SurfaceLight {
  public:
    struct Key {
        PathKey paths;
        int raysPerSample = 0;
        float eta = 0;              ///< relative index of the boundary
        std::uint64_t surface = 0;  ///< version of the samples
        bool operator==(const Key&) const = default;
    };

    /// Restarts or does nothing; true if it restarted.
    bool follow(Key key);
    /// Records the next slice; returns the device time that it will probably take [s].
    double record(const Slice& slice, std::uint16_t label, const SurfacePoints& points);

    [[nodiscard]] std::uint32_t litSamples() const { return lit_; }
    [[nodiscard]] std::uint32_t raysPerSample() const;
    /// Number of restarts.
    [[nodiscard]] std::uint64_t version() const { return version_; }

  private:
    [[nodiscard]] kernel::IrradianceBlock nextPart(std::uint64_t units, std::uint32_t samples) const;

    Key key_;
    std::uint32_t lit_ = 0;
    std::uint32_t rays_ = 0;  ///< done for the samples that are being lit
    std::uint64_t version_ = 0;
    Bound<gpu::BindGroup, PathInputs, SurfacePoints> group_;
};

}  // namespace render
