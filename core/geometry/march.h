// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/depth_layers.h"

namespace core {

struct MarchRay {
    Vector3f origin{0, 0, 0};     ///< [m], camera frame
    Vector3f direction{0, 0, 0};  ///< unit length
};

/// Min/max pyramid over depth layers: the hits of `march`, from a few cells per ray instead of every pixel under it
/// (Tevs et al. 2008, "Maximum mipmaps"). The CPU twin of shaders/lib/march.glsl; immutable, for any number of threads.
class MarchPyramid {
  public:
    /// `without`: a label whose pixels count as empty, 0 = none. `layers` has to outlive the pyramid.
    explicit MarchPyramid(const DepthLayers& layers, std::uint16_t without = 0);

    /// First solid a ray enters, by the rule of `march`. Both are double precision and take the same decision in every
    /// pixel; they may differ where a ray runs through the corner of a pixel within rounding.
    [[nodiscard]] std::optional<MarchHit> march(const Vector3f& origin, const Vector3f& direction) const;

    [[nodiscard]] const DepthLayers& layers() const { return layers_; }

  private:
    /// Range of w that the solids of a cell of 2^level pixels take up; `low` > `high`: empty.
    struct Range {
        float low, high;
    };
    const DepthLayers& layers_;
    std::uint16_t without_;
    std::vector<Image<Range>> levels_;  ///< [0] has cells of 2x2 pixels
};

}  // namespace core
