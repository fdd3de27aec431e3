// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shaders/shared/interop.h"

namespace render {

/// The upper hemisphere divided into boxes of height z and azimuth φ, whose area dz dφ is their solid angle, so that
/// each contains the same number of given directions.
class DirectionCells {
  public:
    /// 2^levels cells for `directions`, unit vectors; those with z <= 0 are ignored.
    DirectionCells(std::span<const kernel::vec4> directions, int levels);

    /// z from, z to, φ from, φ to [rad]. Neighbours in this order are neighbours in space: 2^k cells from a multiple of
    /// 2^k on are one box.
    [[nodiscard]] const std::vector<kernel::vec4>& cells() const { return cells_; }
    /// dz dφ, which is the solid angle [sr].
    [[nodiscard]] static double solidAngle(const kernel::vec4& cell);
    /// Cell that contains `direction`; z > 0.
    [[nodiscard]] std::size_t find(const kernel::vec4& direction) const;

  private:
    struct Point {
        float z, phi;
    };
    struct Split {
        bool onZ = false;
        float at = 0;
    };
    static Point pointOf(const kernel::vec4& direction);
    void split(std::span<Point> points, const kernel::vec4& box, int level, std::size_t node);

    int levels_;
    std::vector<Split> splits_;  ///< a heap: children of i are 2i + 1, 2i + 2
    std::vector<kernel::vec4> cells_;
};

}  // namespace render
