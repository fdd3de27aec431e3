// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/geometry/march.h"
#include "gpu/device.h"
#include "render/scene_geometry.h"

namespace render {

using Ray = core::MarchRay;

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

/// Marches a list of rays through the scene on the device, for the analysis, the benchmark and the tests. The
/// renderer's kernels take the same steps (shaders/lib/march.glsl) with one ray per lane at a time; here a lane takes
/// the next ray when one has ended.
class RayMarcher {
  public:
    /// The geometry must have been recorded and has to outlive the marcher.
    RayMarcher(const gpu::Device& device, SceneGeometry& geometry);

    /// Hits in the order of the rays; blocks until they are found. A ray whose direction is zero hits nothing. Pixels
    /// marked `without` (see SceneGeometry) count as empty for the pyramid; −1 = none.
    [[nodiscard]] std::vector<RayHit> march(std::span<const Ray> rays, MarchMethod method,
                                            const ConstantStepParams& steps = {}, float without = -1);
    /// Device time of the last call's kernel [s]; wall time when the device has no timestamps.
    [[nodiscard]] double seconds() const { return seconds_; }

  private:
    gpu::Device device_;
    SceneGeometry& geometry_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline pyramid_;
    gpu::ComputePipeline constantSteps_;
    double seconds_ = 0;
};

}  // namespace render
