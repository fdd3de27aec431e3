// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/material/material.h"
#include "render/render_context.h"
#include "render/sums/sampled_surface.h"
#include "render/sums/surface_light.h"

namespace render {

/// Light below the surface of a translucent segment, summed from its lit samples onto its pixels. A first sum is made
/// of a 64th of the samples, then of an eighth, then of all. Restarts exactly when its key changes.
class DiffusionSum {
  public:
    struct Key {
        std::uint64_t light = 0;        ///< version of the samples' light
        core::Translucency scattering;  ///< the material's, without what does not affect the sum
        bool operator==(const Key&) const = default;
    };

    /// Restarts or does nothing; true if it restarted.
    bool follow(const SurfaceLight& light, const core::Translucency& translucency);
    /// Whether enough samples are lit for the next sum, or one is in progress.
    [[nodiscard]] bool due(const SurfaceLight& light, const SurfacePoints& points) const;
    /// Records the next slice; returns the device time that it will probably take [s].
    double record(const Slice& slice, SampledSurface& surface, const SurfaceLight& light);

    /// Samples in the complete sum on show; 0: none is complete.
    [[nodiscard]] std::uint32_t samples() const { return samples_; }
    /// Number of sums completed.
    [[nodiscard]] std::uint64_t version() const { return version_; }

  private:
    void begin(const Slice& slice, SampledSurface& surface, const SurfaceLight& light);
    double recordStep(const Slice& slice, const DiffusionGrids& grids, std::uint32_t rays);
    void noteProgress();

    Key key_;
    std::uint32_t samples_ = 0;
    std::uint64_t version_ = 0;
    bool cleared_ = false;           ///< the picture holds nothing of other light
    std::uint32_t gridSamples_ = 0;  ///< samples whose light is in the grids
    std::size_t smoothFrom_ = 0;     ///< levels of the grids from this one on are smooth

    // The sum in progress.
    std::uint32_t target_ = 0;  ///< samples in it; 0: there is none
    core::DiffusionKernel kernel_;
    std::vector<DiffusionStep> steps_;
    std::size_t lightSteps_ = 0;   ///< the first steps: they take in light
    std::size_t smoothSteps_ = 0;  ///< the first steps with those that smooth it
    std::size_t step_ = 0;
    std::uint32_t itemsDone_ = 0;  ///< in that step
};

}  // namespace render
