// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/depth/normals.h"
#include "core/analysis/kernels.h"
#include "gpu/device.h"
#include "render/slice_runner.h"

namespace render {

/// Normals, positions and patch areas on the device (shaders/analysis/fit_surface.comp).
/// Each call uploads, works in slices and reads back; may throw gpu::Error, and core::Error(Cancelled).
class FitSurfacePass {
  public:
    explicit FitSurfacePass(const gpu::Device& device);
    void run(const core::analysis::SurfaceInput& input, core::Surface& surface, SliceRunner& slices,
             const core::Progress& progress) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
