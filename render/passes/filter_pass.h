// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "gpu/device.h"
#include "render/passes/segment_targets.h"
#include "render/scene_geometry.h"

namespace render {

/// Records the edge-aware filter (shaders/filter.comp) step by step: step 0 takes colour and variance from the
/// accumulation, steps 1 to `stepCount() - 1` are the levels; the last one writes `Targets::filtered`.
class FilterPass {
  public:
    FilterPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    [[nodiscard]] static int stepCount();

    /// Bind groups by the pictures that a step reads and writes: start -> ping, ping -> pong, pong -> ping, and to
    /// `filtered`.
    struct Groups {
        gpu::BindGroup start, toPong, toPing, pingToEnd, pongToEnd;
    };
    [[nodiscard]] Groups bind(const PixelList& pixels, const Targets& targets) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const Groups& groups, int step,
                std::uint32_t firstPixel, std::uint32_t pixelCount) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
