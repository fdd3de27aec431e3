// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/render/kernels.h"
#include "core/render/passes/segment_targets.h"
#include "core/render/scene_geometry.h"
#include "core/translucency.h"
#include "gpu/device.h"
#include "shaders/shared/dipole_gather_block.h"
#include "shaders/shared/irradiance_block.h"

namespace render {

/// The surface samples of one segment on the device.
struct SurfacePoints {
    gpu::Buffer points;  ///< kernel::SurfacePoint, shuffled so that any first few cover the whole surface
    gpu::Buffer sums;    ///< vec4 per point: sum of transmitted radiance
    std::uint32_t count = 0;
    float area = 0;       ///< [m²], front and back together
    float smoothing = 0;  ///< of the dipole for this many samples, DipoleParams::zr.w [m²]
};

/// Records slices of the translucency (DESIGN 3.6): light onto surface samples (shaders/irradiance.comp), then from
/// there onto the pixels (shaders/dipole_gather.comp).
class TranslucencyPass {
  public:
    TranslucencyPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    /// The BRDFs that paths may meet, bit = id, and whether there are drives; to be called before light is recorded.
    void useBrdfs(std::uint32_t brdfs, bool driven, std::shared_ptr<const std::vector<std::uint32_t>> userCode) {
        irradiance_.use(brdfs, driven, std::move(userCode));
    }
    [[nodiscard]] SurfacePoints upload(const core::SurfaceSamples& samples) const;
    [[nodiscard]] gpu::BindGroup bindIrradiance(const PathInputs& inputs, const SurfacePoints& points) const;
    [[nodiscard]] gpu::BindGroup bindGather(const gpu::Buffer& dipole, const PixelList& pixels,
                                            const SurfacePoints& points, const Targets& targets) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                const kernel::IrradianceBlock& block) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                const kernel::DipoleGatherBlock& block) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout irradianceLayout_;
    gpu::BindGroupLayout gatherLayout_;
    BrdfPipeline irradiance_;
    gpu::ComputePipeline gather_;
};

}  // namespace render
