// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/selection/region_tree.h"

namespace core {

/// Regions and all that contain them: 1, others 0.
[[nodiscard]] std::vector<std::uint8_t> markAncestors(const RegionTree& tree, const std::vector<std::uint32_t>& leaves);

/// Of the regions that contain superpixel `leaf`, the one that looks most like a whole object: a firm outline,
/// neighbours that would have to be forced in, no support unless `leaf` lies on one. Only regions that are not `barred`
/// and have at most `maxArea` [px] are looked at, and `leaf` itself. Where nothing has an outline, the largest of them.
[[nodiscard]] std::uint32_t chooseRegion(const RegionTree& tree, std::uint32_t leaf,
                                         const std::vector<std::uint8_t>& barred, float maxArea);

/// Sets `values` of all superpixels of a region.
void setLeaves(const RegionTree& tree, std::uint32_t region, std::uint32_t value, std::vector<std::uint32_t>& values);

}  // namespace core
