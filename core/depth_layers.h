// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/analysis.h"
#include "core/camera.h"
#include "core/image.h"

namespace core {

/// The photograph's geometry as rays see it: in every pixel with valid depth a solid between a front and a back plane
/// patch. Everything is stored in inverse depth w = 1/z, because (u, v, w) maps lines to lines and planes to planes:
/// inside a pixel the patch is w(u, v) = w0 + gu·(u − uc) + gv·(v − vc), and a ray is a straight line.
struct DepthLayers {
    struct Patch {
        float w = 0;   ///< 1/z at the pixel centre [1/m]; 0 = empty pixel
        float gu = 0;  ///< ∂w/∂u [1/(m·px)]
        float gv = 0;  ///< ∂w/∂v
        /// Patch value at offset (du, dv) [px] from the pixel centre.
        [[nodiscard]] float at(float du, float dv) const { return w + gu * du + gv * dv; }
        bool operator==(const Patch&) const = default;
    };
    Camera camera;
    Image<Patch> front;  ///< nearer side, larger w
    Image<Patch> back;   ///< farther side; back.w ≤ front.w
    LabelImage labels;
};

/// Builds the layers from the analysed surfaces. Slopes follow the normals, limited to the differences to the valid
/// neighbours of the same label, so that a wrong normal at a silhouette cannot raise a spike.
[[nodiscard]] DepthLayers buildDepthLayers(const Camera& camera, const LabelImage& labels, const Surface& front,
                                           const Surface& back);

/// Distance [m] by which a ray's origin is lifted off the surface along its normal: about half a pixel's footprint.
/// Shared by every march, on the CPU and in the kernels.
[[nodiscard]] float marchBias(const Camera& camera, float z);

struct MarchHit {
    int x = 0, y = 0;    ///< pixel
    bool back = false;   ///< entered through the back layer
    float distance = 0;  ///< along the ray [m]
};

/// First solid a ray enters: visits every pixel under the ray, in double precision. No step size, nothing skipped: the
/// oracle of the pyramid march in shaders/lib/march.glsl. `origin` in camera space with z > 0, `direction` unit length;
/// the ray ends at the image border or the camera plane (nullopt: it sees the environment). An origin inside a solid
/// does not count as a hit until the ray has left it.
[[nodiscard]] std::optional<MarchHit> march(const DepthLayers& layers, const Vector3f& origin,
                                            const Vector3f& direction);

}  // namespace core
