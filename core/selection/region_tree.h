// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/selection/superpixels.h"

namespace core {

/// Region in the tree of merges, and its outline.
struct Region {
    std::uint32_t parent = 0;              ///< its own index at the root
    std::uint32_t childA = 0, childB = 0;  ///< both its own index at a leaf
    float height = 0;                      ///< cost at which its parts merged, not below that of its parts
    float separation = 0;                  ///< difference between its two parts, whatever their size
    float area = 0;                        ///< [px]
    float depthArea = 0;                   ///< pixels with depth [px]
    float supportArea = 0;                 ///< pixels on support planes [px]
    float border = 0;                      ///< part of the outline on the picture's edge [px]
    float outline = 0;                     ///< the rest of the outline [px]
    float strength = 0;                    ///< integral of the boundary strength along it [px]
    float firmness = 0;                    ///< integral of SuperpixelBorder::firmness along it [px]
    Vector3f lab = Vector3f::Zero();       ///< mean colour
};

/// Superpixels merged pairwise, the least different neighbours first. Regions [0, n) are the superpixels. Superpixels
/// that nothing links are joined at the end.
struct RegionTree {
    std::vector<Region> regions;
    std::size_t leafCount = 0;
};

/// `support` has the index of a support plane for each superpixel, or -1. Throws Error(Cancelled).
[[nodiscard]] RegionTree buildRegionTree(const Superpixels& superpixels, const std::vector<int>& support,
                                         const Progress& progress);

}  // namespace core
