// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/analysis/kernels.h"
#include "core/analysis/light/sphere_membrane.h"
#include "gpu/device.h"
#include "render/slice_runner.h"

namespace render {

/// The membrane on the sphere, relaxed on the device (shaders/analysis/relax_membrane.comp).
/// Each call uploads, works in slices and reads back; may throw gpu::Error, and core::Error(Cancelled).
class RelaxMembranePass {
  public:
    explicit RelaxMembranePass(const gpu::Device& device);
    void run(const core::ImageF& coverage, std::span<const core::analysis::MembraneRow> rows, core::ImageRgb& values,
             SliceRunner& slices, const core::Progress& progress) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
