// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/image.h"
#include "core/render/scene_geometry.h"
#include "gpu/device.h"

namespace render {

struct Ray {
    core::Vector3f origin;     ///< [m], camera frame
    core::Vector3f direction;  ///< unit length
};

struct RayHit {
    bool found = false;
    bool back = false;   ///< entered through the back layer
    int x = 0, y = 0;    ///< pixel
    float distance = 0;  ///< along the ray [m]
};

enum class MarchMethod { Pyramid, ConstantSteps };

/// The paper's baseline (section 3.5): samples a ray every `stepSize` up to `maxDistance` [m].
struct ConstantStepParams {
    float stepSize = 0.001f;
    float maxDistance = 1;
};

/// Marches a list of rays through the scene on the device, for the benchmark and the tests; the renderer's kernels
/// include the same text (shaders/lib/march.glsl).
class RayMarcher {
  public:
    /// The geometry must be recorded already, and outlive the marcher.
    RayMarcher(const gpu::Device& device, SceneGeometry& geometry);

    /// Blocks until the hits are there, in the order of the rays.
    [[nodiscard]] std::vector<RayHit> march(const std::vector<Ray>& rays, MarchMethod method,
                                            const ConstantStepParams& steps = {});
    /// Device time of the last call's kernel [s]; wall time when the device has no timestamps.
    [[nodiscard]] double seconds() const { return seconds_; }

  private:
    gpu::Device device_;
    SceneGeometry& geometry_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pipeline_;
    double seconds_ = 0;
};

}  // namespace render
