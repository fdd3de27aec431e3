// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/choose_region.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Separation (Region::separation) at which a neighbour is as likely another object as a part, and the width of the
/// transition.
constexpr float kSeparation = 0.85f;
constexpr float kSeparationWidth = 0.04f;
/// Growth that makes a merge count: smaller ones are specks on the outline.
constexpr float kGrowth = 1.05f;
/// Firmness of the picture's edge as part of an outline.
constexpr float kPictureEdge = 0.4f;
/// Exponent of the area in the score: of two good outlines the smaller object.
constexpr float kScoreExponent = -0.06f;
/// Weight of the part on a support.
constexpr float kSupportPenalty = 1.5f;
/// Mean strength below which an outline is none.
constexpr float kNoOutline = 0.02f;

/// Largest separation from what a region merges with until it has grown noticeably.
float separationOf(const RegionTree& tree, std::uint32_t index) {
    const float enough = kGrowth * tree.regions[index].area;
    float separation = 0;
    for (std::uint32_t up = index; tree.regions[up].area < enough && tree.regions[up].parent != up;) {
        up = tree.regions[up].parent;
        separation = std::max(separation, tree.regions[up].separation);
    }
    return separation;
}

float scoreOf(const RegionTree& tree, std::uint32_t index, bool onSupport) {
    const Region& region = tree.regions[index];
    if (region.parent == index) return 0;
    const float length = std::max(1.0f, region.outline + region.border);
    const float firmness = (region.firmness + kPictureEdge * region.border) / length;
    const float apart = 1 / (1 + std::exp((kSeparation - separationOf(tree, index)) / kSeparationWidth));
    const float free = onSupport ? 1.0f : 1 - std::min(1.0f, kSupportPenalty * region.supportArea / region.area);
    return firmness * firmness * apart * free * std::pow(region.area, kScoreExponent);
}

}  // namespace

std::vector<std::uint8_t> markAncestors(const RegionTree& tree, const std::vector<std::uint32_t>& leaves) {
    std::vector<std::uint8_t> marked(tree.regions.size());
    for (std::uint32_t i : leaves)
        while (marked[i] == 0) {
            marked[i] = 1;
            i = tree.regions[i].parent;
        }
    return marked;
}

std::uint32_t chooseRegion(const RegionTree& tree, std::uint32_t leaf, const std::vector<std::uint8_t>& barred,
                           float maxArea) {
    const bool onSupport = tree.regions[leaf].supportArea > 0;
    std::uint32_t best = leaf, largest = leaf;
    float bestScore = 0, strongest = 0;
    for (std::uint32_t i = leaf; barred[i] == 0; i = tree.regions[i].parent) {
        const Region& region = tree.regions[i];
        if (i != leaf && region.area > maxArea) break;
        largest = i;
        strongest = std::max(strongest, region.strength / std::max(1.0f, region.outline));
        const float score = scoreOf(tree, i, onSupport);
        if (score > bestScore) bestScore = score, best = i;
        if (region.parent == i) break;
    }
    return strongest < kNoOutline ? largest : best;
}

void setLeaves(const RegionTree& tree, std::uint32_t region, std::uint32_t value, std::vector<std::uint32_t>& values) {
    std::vector<std::uint32_t> open{region};
    while (!open.empty()) {
        const std::uint32_t i = open.back();
        open.pop_back();
        if (i < tree.leafCount) {
            values[i] = value;
        } else {
            open.push_back(tree.regions[i].childA);
            open.push_back(tree.regions[i].childB);
        }
    }
}

}  // namespace core
