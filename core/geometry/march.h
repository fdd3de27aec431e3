// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/depth_layers.h"

namespace core {

struct Crossing;
struct ImageRay;

struct MarchRay {
    Vector3f origin{0, 0, 0};     ///< [m], camera frame
    Vector3f direction{0, 0, 0};  ///< unit length
};

/// Min/max pyramid over depth layers: finds the hits of `march` by visiting a few cells per ray instead of every pixel
/// under it (Tevs et al. 2008, "Maximum mipmaps"). The CPU twin of shaders/lib/march.glsl; immutable, thread-safe.
class MarchPyramid {
  public:
    /// `without`: a label whose pixels count as empty, 0 = none. `layers` must outlive the pyramid.
    explicit MarchPyramid(const DepthLayers& layers, std::uint16_t without = 0);

    /// First solid a ray enters, by the rule of `march`. Both compute in double precision and decide alike
    /// in every pixel; they may differ where a ray passes a pixel's corner within rounding.
    [[nodiscard]] std::optional<MarchHit> march(const Vector3f& origin, const Vector3f& direction) const;

    [[nodiscard]] const DepthLayers& layers() const { return layers_; }

  private:
    /// Range of w that the solids in a cell of 2^level pixels occupy; empty when `low` > `high`.
    struct Range {
        float low, high;
    };
    /// Whether the part [s0, s1] of a ray may touch a solid in a cell of this level, >= 1.
    [[nodiscard]] bool mayTouch(const ImageRay& ray, int level, int x, int y, double s0, double s1) const;
    /// What pixel (x, y) does to that part of a ray; nothing where its label is left out.
    [[nodiscard]] Crossing cross(const ImageRay& ray, int x, int y, double s0, double s1, bool escaping) const;

    const DepthLayers& layers_;
    std::uint16_t without_;
    std::vector<Image<Range>> levels_;  ///< [0] has cells of 2x2 pixels
};

}  // namespace core
