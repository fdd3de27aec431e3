// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/directional_map.h"
#include "core/base/progress.h"

namespace core::analysis {

/// A group of observed texels of a directional map.
struct DirectionNode {
    Vector3f direction{0, 0, 0};  ///< unit, weighted mean
    Vector3f radiance{0, 0, 0};   ///< weighted sum
    float weight = 0;             ///< Σ solid angle · n/(n + 1), n = coverage; 0 = the group is empty
    float radius = 0;             ///< [rad], from `direction` to the farthest texel centre
};

/// Quadtree over the texels of a directional map, stored as a pyramid of images. Distant texels are taken in groups,
/// which makes an interpolation O(log n).
class DirectionTree {
  public:
    /// A group is taken as one node if its radius is smaller than this fraction of its distance.
    static constexpr float kOpening = 0.2f;
    /// Minimum cube of a distance [rad³].
    static constexpr float kMinCube = 1e-12f;

    explicit DirectionTree(const DirectionalMap& map);

    [[nodiscard]] bool empty() const { return levels_.back()(0, 0).weight <= 0; }
    /// [0] = the texels; the last level is a single node.
    [[nodiscard]] const std::vector<Image<DirectionNode>>& levels() const { return levels_; }
    /// Shepard's mean ([BRD14] 3.3) seen from a unit direction: every node weighs its own weight over the cube of its
    /// angular distance. Not for an empty tree.
    [[nodiscard]] Vector3f interpolate(const Vector3f& direction) const;

  private:
    void gather(int level, int x, int y, const Vector3f& direction, Vector3f& sum, float& weight) const;
    std::vector<Image<DirectionNode>> levels_;
};

/// Fills the texels without coverage by `DirectionTree::interpolate`, on the CPU.
void fillShepard(const DirectionTree& tree, DirectionalMap& map, const Progress& progress);

}  // namespace core::analysis
