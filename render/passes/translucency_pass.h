// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/shading/surface_samples.h"
#include "gpu/device.h"
#include "render/kernels/kernels.h"
#include "render/passes/segment_targets.h"
#include "render/scene_geometry.h"
#include "shaders/shared/irradiance_block.h"

namespace render {

/// The surface samples of one segment on the device.
struct SurfacePoints {
    gpu::Buffer points;  ///< kernel::SurfacePoint; any number of first ones covers the whole surface
    gpu::Buffer sums;    ///< vec4 per point: sum of transmitted radiance
    std::uint32_t count = 0;
    double area = 0;  ///< of front and back [m²]
    bool operator==(const SurfacePoints&) const = default;
};

/// Records slices of the light that enters at surface samples (docs/method.md#translucency, shaders/irradiance.comp).
class TranslucencyPass {
  public:
    TranslucencyPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout);

    /// Sets the BRDFs that paths may meet, bit = id, and whether there are drives; to be called before `record`.
    void useBrdfs(std::uint32_t brdfs, bool driven, std::shared_ptr<const std::vector<std::uint32_t>> userCode) {
        irradiance_.use(brdfs, driven, std::move(userCode));
    }
    [[nodiscard]] SurfacePoints upload(const core::SurfaceSamples& samples) const;
    [[nodiscard]] gpu::BindGroup bindIrradiance(const PathInputs& inputs, const SurfacePoints& points) const;
    void record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                const kernel::IrradianceBlock& block) const;

  private:
    gpu::Device device_;
    gpu::BindGroupLayout irradianceLayout_;
    BrdfPipeline irradiance_;
};

}  // namespace render
