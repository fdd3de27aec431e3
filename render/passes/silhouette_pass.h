// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shading/silhouette.h"
#include "gpu/device.h"
#include "render/passes/segment_targets.h"
#include "render/scene_geometry.h"
#include "shaders/shared/silhouette_block.h"

namespace render {

/// Records the colours of the partly covered pixels at one segment's outline (shaders/silhouette.comp).
class SilhouettePass {
  public:
    SilhouettePass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    /// Uploads the list; the buffer holds kernel::MixedPixel.
    [[nodiscard]] PixelList upload(const std::vector<core::SilhouettePixel>& pixels) const;
    [[nodiscard]] gpu::BindGroup bind(const PathInputs& inputs, const PixelList& pixels, const Targets& targets) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                const kernel::SilhouetteBlock& block) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace render
