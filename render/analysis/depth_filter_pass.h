// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/analysis/depth/filter_depth.h"
#include "core/analysis/kernels.h"
#include "gpu/device.h"
#include "render/slice_runner.h"

namespace render {

/// Passes of the edge-avoiding depth filter on the device (shaders/analysis/depth_filter.comp).
/// Each call uploads, works in slices and reads back; may throw gpu::Error, and core::Error(Cancelled).
class DepthFilterPass {
  public:
    explicit DepthFilterPass(const gpu::Device& device);

    /// What all passes over one picture share.
    struct Images {
        gpu::Buffer color;
        gpu::Buffer labels;
    };
    [[nodiscard]] Images upload(const core::Image<std::uint32_t>& color, const core::LabelImage& labels) const;
    [[nodiscard]] core::ImageF run(const Images& images, const core::analysis::FilterPass& pass,
                                   const core::ImageF& inverseDepth, SliceRunner& slices,
                                   const core::Progress& progress) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
