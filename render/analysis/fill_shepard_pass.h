// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/kernels.h"
#include "core/analysis/light/shepard.h"
#include "gpu/device.h"
#include "render/slice_runner.h"

namespace render {

/// Shepard's interpolation over directions on the device (shaders/analysis/fill_shepard.comp).
/// Each call uploads, works in slices and reads back; may throw gpu::Error, and core::Error(Cancelled).
class FillShepardPass {
  public:
    explicit FillShepardPass(const gpu::Device& device);
    void run(const core::analysis::DirectionTree& tree, core::DirectionalMap& map, SliceRunner& slices,
             const core::Progress& progress) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
