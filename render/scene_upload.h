// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/shading/environment_sampler.h"
#include "render/kernels/drive_buffers.h"
#include "render/kernels/measured_tables.h"
#include "render/render_context.h"
#include "render/shaded_scene.h"

namespace render {

/// Brings a scene to the device and remembers which one is there, so that each part is uploaded once.
class SceneUpload {
  public:
    explicit SceneUpload(core::LightSampling lightSampling) : lightSampling_(lightSampling) {}

    /// Continues to upload the picture for about `seconds`; true when all of it is on the device.
    [[nodiscard]] bool layersReady(RenderContext& context, const ShadedScene& shaded, double seconds);
    /// Uploads the light and the tables of materials. May throw gpu::Error(OutOfMemory).
    void follow(RenderContext& context, const ShadedScene& shaded);

  private:
    void uploadMaterials(RenderContext& context, const ShadedScene& shaded);

    core::LightSampling lightSampling_;
    PictureLayers layers_;                                ///< on the device, or on their way
    std::shared_ptr<const core::DepthLayers> uploading_;  ///< kept alive until they are uploaded
    std::optional<std::shared_ptr<const core::DirectionalMap>> environment_;
    std::uint64_t revision_ = 0;  ///< of the scene whose materials are on the device
    MeasuredTables measured_;
    DriveBuffers drives_;
};

}  // namespace render
