// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/guess_object.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/selection/choose_region.h"

namespace core {

namespace {

/// Largest area that a further seed adds or takes away, in parts of what the first ones selected.
constexpr float kMaxAdded = 1.5f;
constexpr float kMaxRemoved = 0.5f;
/// Part of the first region from which a disc in it around a removed seed is no detail.
constexpr float kDetail = 0.06f;
/// Removed seeds in the first region that show it to be the wrong one, whatever their size.
constexpr int kManyRemoved = 3;
/// Distance from the outline within which a seed corrects details [working px], and their largest area in squares of
/// the seed's distance: that of a disc twice as wide.
constexpr float kNear = 20;
constexpr float kDetailArea = 12;

constexpr float kUnlimited = std::numeric_limits<float>::max();

float distanceBetween(const Pixel& a, const Pixel& b) {
    return std::hypot(static_cast<float>(a.x - b.x), static_cast<float>(a.y - b.y));
}

class Guess {
  public:
    Guess(const Selector::State& state, const SelectionSeeds& seeds, const SeedLeaves& leaves)
        : state_(state),
          leaves_(leaves),
          barredAdd_(markAncestors(state.tree, leaves.remove)),
          barredRemove_(markAncestors(state.tree, leaves.add)),
          object_(state.tree.leafCount),
          corrected_(state.tree.leafCount) {
        const int factor = state.picture.factor;
        for (const Pixel& p : seeds.add) add_.push_back({p.x / factor, p.y / factor});
        for (const Pixel& p : seeds.remove) remove_.push_back({p.x / factor, p.y / factor});
    }

    ObjectGuess run() {
        const std::uint32_t first = firstRegion();
        setLeaves(state_.tree, first, 1, object_);
        area_ = state_.tree.regions[first].area;
        for (std::size_t i = 1; i < add_.size(); ++i) correct(add_[i], leaves_.add[i], 1);
        for (std::size_t i = 0; i < remove_.size(); ++i) correct(remove_[i], leaves_.remove[i], 0);
        ObjectGuess guess{{{object_.begin(), object_.end()}, std::vector<std::uint8_t>(object_.size())},
                          {corrected_.begin(), corrected_.end()},
                          std::move(discs_)};
        for (const std::uint32_t leaf : leaves_.remove) guess.prior.fixed[leaf] = 1, guess.prior.object[leaf] = 0;
        for (const std::uint32_t leaf : leaves_.add) guess.prior.fixed[leaf] = 1, guess.prior.object[leaf] = 1;
        return guess;
    }

  private:
    /// The best region of all around the first seed if the removed points lie on details of it, otherwise the best one
    /// without them.
    [[nodiscard]] std::uint32_t firstRegion() const {
        const RegionTree& tree = state_.tree;
        const std::uint32_t first = leaves_.add.front();
        const std::vector<std::uint8_t> unbarred(tree.regions.size());
        const std::uint32_t whole = chooseRegion(tree, first, unbarred, kUnlimited);
        std::vector<std::uint32_t> inWhole(tree.leafCount);
        setLeaves(tree, whole, 1, inWhole);
        const std::vector<std::uint8_t> barred = markAncestors(tree, {first});
        const float area = tree.regions[whole].area;
        const float deep = std::sqrt(kDetail * area / std::numbers::pi_v<float>);
        int count = 0;
        for (std::size_t i = 0; i < remove_.size(); ++i) {
            const std::uint32_t leaf = leaves_.remove[i];
            if (inWhole[leaf] == 0) continue;
            const std::uint32_t removed = chooseRegion(tree, leaf, barred, kUnlimited);
            const bool detail = ++count < kManyRemoved && tree.regions[removed].area <= kMaxRemoved * area &&
                                reachesOutside(inWhole, remove_[i], deep);
            if (!detail) return chooseRegion(tree, first, barredAdd_, kUnlimited);
        }
        return whole;
    }

    /// Whether a pixel whose superpixel is not in `region` lies closer than `radius` [working px].
    [[nodiscard]] bool reachesOutside(const std::vector<std::uint32_t>& region, const Pixel& at, float radius) const {
        const Image<std::uint32_t>& index = state_.superpixels.index;
        const int reach = static_cast<int>(radius);
        for (int y = std::max(0, at.y - reach); y <= std::min(index.height() - 1, at.y + reach); ++y)
            for (int x = std::max(0, at.x - reach); x <= std::min(index.width() - 1, at.x + reach); ++x)
                if (region[index(x, y)] == 0 && distanceBetween({x, y}, at) < radius) return true;
        return false;
    }

    void correct(const Pixel& at, std::uint32_t leaf, std::uint8_t value) {
        const float outline = distanceTo(value, at);
        float most = (value != 0 ? kMaxAdded : kMaxRemoved) * area_;
        if (outline < kNear) {
            float radius = outline;
            for (const Pixel& other : value != 0 ? remove_ : add_)
                radius = std::min(radius, 0.5f * distanceBetween(at, other));
            discs_.push_back({at, radius, value});
            if (outline > 0) most = std::min(most, kDetailArea * outline * outline);
        }
        const std::uint32_t region = chooseRegion(state_.tree, leaf, value != 0 ? barredAdd_ : barredRemove_, most);
        setLeaves(state_.tree, region, value, object_);
        setLeaves(state_.tree, region, 1, corrected_);
        if (value != 0) area_ = std::max(area_, state_.tree.regions[region].area);
    }

    /// Distance to the nearest pixel whose superpixel has `value`; not more than kNear [working px].
    [[nodiscard]] float distanceTo(std::uint8_t value, const Pixel& at) const {
        const Image<std::uint32_t>& index = state_.superpixels.index;
        const int reach = static_cast<int>(kNear);
        float least = kNear;
        for (int y = std::max(0, at.y - reach); y <= std::min(index.height() - 1, at.y + reach); ++y)
            for (int x = std::max(0, at.x - reach); x <= std::min(index.width() - 1, at.x + reach); ++x)
                if (object_[index(x, y)] == value) least = std::min(least, distanceBetween({x, y}, at));
        return least;
    }

    const Selector::State& state_;
    const SeedLeaves& leaves_;
    std::vector<std::uint8_t> barredAdd_, barredRemove_;
    std::vector<Pixel> add_, remove_;                ///< [working px]
    std::vector<std::uint32_t> object_, corrected_;  ///< by superpixel
    std::vector<CertainDisc> discs_;
    float area_ = 0;  ///< of the largest region chosen so far [working px]
};

}  // namespace

SeedLeaves leavesOf(const Selector::State& state, const SelectionSeeds& seeds) {
    const int factor = state.picture.factor;
    SeedLeaves leaves;
    for (const Pixel& p : seeds.add) leaves.add.push_back(state.superpixels.index(p.x / factor, p.y / factor));
    for (const Pixel& p : seeds.remove) leaves.remove.push_back(state.superpixels.index(p.x / factor, p.y / factor));
    return leaves;
}

ObjectGuess guessObject(const Selector::State& state, const SelectionSeeds& seeds, const SeedLeaves& leaves) {
    return Guess(state, seeds, leaves).run();
}

}  // namespace core
