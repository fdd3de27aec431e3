// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/region_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <unordered_map>

#include "core/selection/support.h"

namespace core {

namespace {

/// Colour difference (OKLab) between two regions that counts fully, and its weight beside the border.
constexpr float kColorDifference = 0.2f;
constexpr float kColorWeight = 0.25f;
/// Weight of one region lying on a support plane and the other not.
constexpr float kSupportWeight = 0.6f;
/// Exponent of the smaller area in the cost: small specks merge early.
constexpr float kMergeExponent = 0.12f;
constexpr std::size_t kMergesPerCheckpoint = 256;

struct Link {
    std::uint32_t a, b;                ///< clusters that the link joins now
    float length, strength, firmness;  ///< integrals along the border
    std::uint32_t version = 0;
    bool alive = true;
};

struct MergeCandidate {
    float cost;
    std::uint32_t link, version;
    bool operator<(const MergeCandidate& other) const {  // the cheapest is the greatest
        return cost != other.cost ? cost > other.cost : link > other.link;
    }
};

std::uint64_t pairKey(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

class Merger {
  public:
    Merger(const Superpixels& superpixels, const std::vector<int>& support);
    RegionTree run(const Progress& progress);

  private:
    [[nodiscard]] float separation(const Link& link) const;
    [[nodiscard]] float cost(const Link& link) const;
    void addLeaf(const Superpixel& superpixel, bool onSupport);
    void addLink(const SuperpixelBorder& border);
    void push(std::uint32_t link) { queue_.push({cost(links_[link]), link, links_[link].version}); }
    [[nodiscard]] std::uint32_t merge(std::uint32_t a, std::uint32_t b, float length, float strength, float firmness,
                                      float height);
    void moveLinks(std::uint32_t from, std::uint32_t to);

    RegionTree tree_;
    float pictureArea_ = 0;
    std::vector<Link> links_;
    std::vector<std::uint32_t> regionOf_;              ///< by cluster, which has the index of one of its superpixels
    std::vector<std::vector<std::uint32_t>> linksOf_;  ///< by cluster; may hold dead links
    std::unordered_map<std::uint64_t, std::uint32_t> linkOf_;
    std::priority_queue<MergeCandidate> queue_;
};

Merger::Merger(const Superpixels& superpixels, const std::vector<int>& support) {
    const std::size_t count = superpixels.superpixels.size();
    tree_.leafCount = count;
    tree_.regions.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i) addLeaf(superpixels.superpixels[i], support[i] != kNoSupport);
    linksOf_.resize(count);
    regionOf_.resize(count);
    std::iota(regionOf_.begin(), regionOf_.end(), 0U);
    links_.reserve(superpixels.borders.size());
    linkOf_.reserve(2 * superpixels.borders.size());
    for (const SuperpixelBorder& border : superpixels.borders) addLink(border);
    for (std::uint32_t i = 0; i < links_.size(); ++i) push(i);
}

void Merger::addLeaf(const Superpixel& superpixel, bool onSupport) {
    const auto self = static_cast<std::uint32_t>(tree_.regions.size());
    Region region;
    region.parent = region.childA = region.childB = self;
    region.area = superpixel.area;
    region.depthArea = superpixel.depthArea;
    region.supportArea = onSupport ? superpixel.area : 0;
    region.border = superpixel.border;
    region.lab = superpixel.lab;
    pictureArea_ += superpixel.area;
    tree_.regions.push_back(region);
}

void Merger::addLink(const SuperpixelBorder& border) {
    const auto index = static_cast<std::uint32_t>(links_.size());
    links_.push_back(
        {border.a, border.b, border.length, border.length * border.strength, border.length * border.firmness});
    linkOf_.emplace(pairKey(border.a, border.b), index);
    for (const std::uint32_t end : {border.a, border.b}) {
        linksOf_[end].push_back(index);
        Region& region = tree_.regions[end];
        region.outline += border.length;
        region.strength += border.length * border.strength;
        region.firmness += border.length * border.firmness;
    }
}

float Merger::cost(const Link& link) const {
    const Region& a = tree_.regions[regionOf_[link.a]];
    const Region& b = tree_.regions[regionOf_[link.b]];
    return separation(link) * std::pow(std::min(a.area, b.area) / pictureArea_, kMergeExponent);
}

float Merger::separation(const Link& link) const {
    const Region& a = tree_.regions[regionOf_[link.a]];
    const Region& b = tree_.regions[regionOf_[link.b]];
    const float border = 0.5f * (link.strength + link.firmness) / link.length;
    const float color = std::min(1.0f, (a.lab - b.lab).norm() / kColorDifference);
    const float support = std::abs(a.supportArea / a.area - b.supportArea / b.area);
    return border + kColorWeight * color + kSupportWeight * support;
}

std::uint32_t Merger::merge(std::uint32_t a, std::uint32_t b, float length, float strength, float firmness,
                            float height) {
    const auto fresh = static_cast<std::uint32_t>(tree_.regions.size());
    Region region;
    Region& left = tree_.regions[a];
    Region& right = tree_.regions[b];
    region.parent = fresh;
    region.childA = a, region.childB = b;
    region.height = std::max({height, left.height, right.height});
    region.area = left.area + right.area;
    region.depthArea = left.depthArea + right.depthArea;
    region.supportArea = left.supportArea + right.supportArea;
    region.border = left.border + right.border;
    region.outline = std::max(0.0f, left.outline + right.outline - 2 * length);
    region.strength = std::max(0.0f, left.strength + right.strength - 2 * strength);
    region.firmness = std::max(0.0f, left.firmness + right.firmness - 2 * firmness);
    region.lab = (left.area * left.lab + right.area * right.lab) / region.area;
    left.parent = right.parent = fresh;
    tree_.regions.push_back(region);
    return fresh;
}

/// Gives the links of the cluster `from` to the cluster `to`; equal ones are added up.
void Merger::moveLinks(std::uint32_t from, std::uint32_t to) {
    for (const std::uint32_t index : linksOf_[from]) {
        Link& link = links_[index];
        if (!link.alive) continue;
        const std::uint32_t other = link.a == from ? link.b : link.a;
        linkOf_.erase(pairKey(from, other));
        if (other == to) {
            link.alive = false;
            continue;
        }
        const auto known = linkOf_.find(pairKey(to, other));
        if (known != linkOf_.end()) {
            Link& kept = links_[known->second];
            kept.length += link.length;
            kept.strength += link.strength;
            kept.firmness += link.firmness;
            ++kept.version;
            link.alive = false;
            push(known->second);
            continue;
        }
        link.a = std::min(to, other), link.b = std::max(to, other);
        ++link.version;
        linkOf_.emplace(pairKey(to, other), index);
        linksOf_[to].push_back(index);
        push(index);
    }
    linksOf_[from] = {};
}

RegionTree Merger::run(const Progress& progress) {
    std::size_t merges = 0;
    while (!queue_.empty()) {
        const MergeCandidate best = queue_.top();
        queue_.pop();
        const Link link = links_[best.link];
        if (!link.alive || link.version != best.version) continue;
        // A cluster keeps its links when a smaller one joins it, so their costs may have risen since.
        const float now = cost(link);
        if (now > best.cost * 1.0001f) {
            queue_.push({now, best.link, best.version});
            continue;
        }
        if (++merges % kMergesPerCheckpoint == 0)
            progress.checkpoint(static_cast<float>(merges) / static_cast<float>(tree_.leafCount));
        const float contrast = separation(link);
        const std::uint32_t region =
            merge(regionOf_[link.a], regionOf_[link.b], link.length, link.strength, link.firmness, now);
        const bool keepA = linksOf_[link.a].size() >= linksOf_[link.b].size();
        const std::uint32_t to = keepA ? link.a : link.b;
        moveLinks(keepA ? link.b : link.a, to);
        regionOf_[to] = region;
        tree_.regions[region].separation = contrast;
    }
    std::uint32_t root = static_cast<std::uint32_t>(tree_.regions.size()) - 1;
    for (std::uint32_t i = 0; i < root; ++i)
        if (tree_.regions[i].parent == i) root = merge(root, i, 0, 0, 0, 2);
    return std::move(tree_);
}

}  // namespace

RegionTree buildRegionTree(const Superpixels& superpixels, const std::vector<int>& support, const Progress& progress) {
    return Merger(superpixels, support).run(progress);
}

}  // namespace core
