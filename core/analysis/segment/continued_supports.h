// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/analysis/segment/support_planes.h"

namespace core::analysis {

/// The tables and walls of a photo (`findSupports`) where they are not visible: beyond the border of the picture and
/// behind what stands on them. A ray that misses everything visible but meets these does not see the environment.
class ContinuedSupports {
  public:
    /// Supports are continued only if at least half of their points lie on a plane.
    ContinuedSupports(const Camera& camera, const LabelImage& labels, const Surface& front);

    /// Whether the ray, which met nothing in the picture, meets a support's plane from its visible side where the plane
    /// is assumed to continue: no farther from the camera than the visible part of the support reaches, and not at a
    /// pixel that shows something beyond the plane or no surface. `direction`: any length.
    [[nodiscard]] bool meets(const Vector3f& origin, const Vector3f& direction) const;

  private:
    struct Support {
        SupportPlane plane;
        float reach = 0;  ///< [m] from the camera
    };
    [[nodiscard]] bool continuesAt(const Vector3f& point) const;

    const Camera& camera_;
    const Surface& front_;
    std::vector<Support> supports_;
};

}  // namespace core::analysis
