// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/geometry/surface.h"

namespace core {

/// The photograph's geometry for ray marching: every pixel with valid depth holds a solid between a front and a back
/// plane patch. Everything is stored in inverse depth w = 1/z, because (u, v, w) maps lines to lines and planes to
/// planes: inside a pixel the patch is w(u, v) = w0 + gu·(u − uc) + gv·(v − vc), and a ray is a straight line.
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
    Image<Patch> back;   ///< farther side; at all four corners of the pixel 0 < back ≤ front
    LabelImage labels;
    /// All solids lie in [minW, maxW] [1/m]; a ray that has left this range for good can stop.
    float minW = 0;
    float maxW = std::numeric_limits<float>::infinity();
};

/// Builds the layers from the analysed surfaces. Slopes follow the normals, limited to the differences to the valid
/// neighbours of the same label, so that a wrong normal at a silhouette cannot raise a spike. A back patch that would
/// intersect the front patch inside the pixel is made parallel to it.
[[nodiscard]] DepthLayers buildDepthLayers(const Camera& camera, const LabelImage& labels, const Surface& front,
                                           const Surface& back, const Progress& progress = {});

/// Distance [m] by which a ray's origin is lifted off the surface along its normal: half a pixel's footprint,
/// z/(fx + fy). Shared by every march, on the CPU and in the kernels. It exceeds the distance
/// by which patches protrude from a smooth surface (a sphere of radius R: (footprint/cos)²/8R), even on grazing pixels.
[[nodiscard]] float marchBias(const Camera& camera, float z);

struct MarchHit {
    int x = 0, y = 0;    ///< pixel
    bool back = false;   ///< entered through the back layer
    float distance = 0;  ///< along the ray [m]
};

/// First solid a ray enters: visits every pixel under the ray, in double precision, without a step size: the oracle of
/// the pyramid march in shaders/lib/march.glsl. `origin` in camera space with z > 0, `direction` unit length; the ray
/// ends at the image border or the camera plane (nullopt: it sees the environment).
///
/// The rule, exactly. With s = t/(pz + t·dz) the ray is the straight line
///   u = u0 + fx·(dx − dz·px/pz)·s,   v = v0 + fy·(dy − dz·py/pz)·s,   w = (1 − dz·s)/pz,   t = s/w,
/// for s from 0 to 1/dz (dz > 0: w reaches 0) or unbounded (dz ≤ 0), restricted to the image,
/// 0 ≤ u ≤ width, 0 ≤ v ≤ height; an origin outside the image may enter it. In the part [s0, s1] of the ray over a
/// pixel, the solid is where back(u, v) ≤ w ≤ front(u, v): both conditions are linear in s, so this is one interval [a,
/// b], or none.
/// - A ray is *escaping* while it has not yet been outside a solid: it starts escaping when its origin is inside the
///   solid of its pixel, keeps escaping into the next pixel when b = s1 and that pixel's a = s0, and stops otherwise.
///   A ray that comes from outside the image does not escape.
/// - The first interval of a ray that is not escaping is the hit, at s = a. Crossing the front plane there (a > s0)
///   hits the front, crossing the back plane the back; a side wall (a = s0) belongs to the layer nearer to the ray in
///   w, front − w ≤ w − back: the front.
/// - Pixels without valid depth are skipped.
[[nodiscard]] std::optional<MarchHit> march(const DepthLayers& layers, const Vector3f& origin,
                                            const Vector3f& direction);

}  // namespace core
