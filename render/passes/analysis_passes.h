// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/kernels.h"
#include "gpu/device.h"
#include "render/slice_runner.h"

namespace render {

/// The pieces of core::AnalysisKernels on the device, one class per kernel of shaders/analysis. Each call uploads,
/// works in slices, and reads back; it may throw gpu::Error, and core::Error(Cancelled).

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
