// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/selector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/selection/choose_region.h"
#include "core/selection/cut_superpixels.h"
#include "core/selection/mask_operations.h"
#include "core/selection/refine_outline.h"
#include "core/selection/selector_state.h"

namespace core {

namespace {

/// Number of superpixels that is aimed at, and the sides of their grid cells [working px].
constexpr float kSuperpixels = 16000;
constexpr float kMinCell = 3;
constexpr float kMaxCell = 8;
/// Largest area that a further seed adds or takes away, in parts of what the first ones selected.
constexpr float kMaxAdded = 1.5f;
constexpr float kMaxRemoved = 0.5f;
/// How far the outline moves to meet the photograph's edges where depth does not fix it [working px].
constexpr int kOutlineBand = 2;
/// Weight of a colour difference (OKLab) against a distance [px] where a superpixel has seeds of both kinds.
constexpr float kColorDistance = 200;
/// Smallest proposal, as a part of the picture, and least share of its pixels that choose it.
constexpr float kMinProposal = 0.0004f;
constexpr float kMinProposalVotes = 0.4f;
constexpr std::size_t kLeavesPerCheckpoint = 256;

constexpr float kNoLimit = std::numeric_limits<float>::max();

void requireInside(const std::vector<Pixel>& seeds, const Image<PackedLab>& photo) {
    for (const Pixel& p : seeds)
        if (!photo.contains(p.x, p.y))
            throw Error(ErrorKind::Usage,
                        Message("messages", "The point %1, %2 lies outside the photograph of %3 pixels.")
                            .with(p.x, p.y, std::to_string(photo.width()) + "x" + std::to_string(photo.height())));
}

void requireConsistent(const SelectionSeeds& seeds) {
    for (const Pixel& p : seeds.add)
        for (const Pixel& q : seeds.remove)
            if (p.x == q.x && p.y == q.y)
                throw Error(ErrorKind::Usage,
                            Message("messages", "The point %1, %2 is both added and removed.").with(p.x, p.y));
}

/// Seeds by the superpixels they lie on.
struct SeedLeaves {
    std::vector<std::uint32_t> add, remove;
};

SeedLeaves leavesOf(const Selector::State& state, const SelectionSeeds& seeds) {
    const int factor = state.picture.factor;
    SeedLeaves leaves;
    for (const Pixel& p : seeds.add) leaves.add.push_back(state.superpixels.index(p.x / factor, p.y / factor));
    for (const Pixel& p : seeds.remove) leaves.remove.push_back(state.superpixels.index(p.x / factor, p.y / factor));
    return leaves;
}

/// The regions that the seeds choose one after the other.
SuperpixelPrior guess(const RegionTree& tree, const SeedLeaves& leaves) {
    const std::vector<std::uint8_t> barredAdd = markAncestors(tree, leaves.remove);
    const std::vector<std::uint8_t> barredRemove = markAncestors(tree, leaves.add);
    std::vector<std::uint32_t> object(tree.leafCount), corrected(tree.leafCount);
    float area = 0;
    for (const std::uint32_t leaf : leaves.add) {
        const std::uint32_t region = chooseRegion(tree, leaf, barredAdd, area > 0 ? kMaxAdded * area : kNoLimit);
        setLeaves(tree, region, 1, object);
        if (area > 0) setLeaves(tree, region, 1, corrected);
        area = std::max(area, tree.regions[region].area);
    }
    for (const std::uint32_t leaf : leaves.remove) {
        const std::uint32_t region = chooseRegion(tree, leaf, barredRemove, kMaxRemoved * area);
        setLeaves(tree, region, 0, object);
        setLeaves(tree, region, 1, corrected);
    }
    SuperpixelPrior prior{std::vector<std::uint8_t>(object.begin(), object.end()),
                          std::vector<std::uint8_t>(tree.leafCount),
                          std::vector<std::uint8_t>(corrected.begin(), corrected.end())};
    for (const std::uint32_t leaf : leaves.remove) prior.fixed[leaf] = 1, prior.object[leaf] = 0;
    for (const std::uint32_t leaf : leaves.add) prior.fixed[leaf] = 1, prior.object[leaf] = 1;
    return prior;
}

/// Leaves only what is linked with the added superpixels, over narrow gaps too.
void keepLinked(const Superpixels& superpixels, const std::vector<std::uint32_t>& add,
                std::vector<std::uint8_t>& object) {
    DisjointSets linked(object.size());
    for (const SuperpixelBorder& border : superpixels.borders)
        if (object[border.a] != 0 && object[border.b] != 0) linked.join(border.a, border.b);
    std::vector<std::uint8_t> kept(object.size());
    for (const std::uint32_t leaf : add) kept[linked.find(leaf)] = 1;
    for (std::uint32_t i = 0; i < object.size(); ++i)
        if (kept[linked.find(i)] == 0) object[i] = 0;
}

/// The superpixels of an object, in working pixels.
BinaryMask maskOf(const Superpixels& superpixels, const std::vector<std::uint8_t>& object) {
    BinaryMask mask(superpixels.index.width(), superpixels.index.height());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = object[superpixels.index[i]];
    return mask;
}

/// Divides superpixels with seeds of both kinds between these, by colour and distance.
void divideContested(const Selector::State& state, const SelectionSeeds& seeds, const SeedLeaves& leaves,
                     BinaryMask& mask) {
    std::vector<std::uint8_t> contested(state.tree.leafCount);
    bool any = false;
    for (const std::uint32_t a : leaves.add)
        if (std::ranges::find(leaves.remove, a) != leaves.remove.end()) contested[a] = 1, any = true;
    if (!any) return;
    const int factor = state.picture.factor;
    const auto nearest = [&](int x, int y, std::uint32_t leaf, const std::vector<Pixel>& points,
                             const std::vector<std::uint32_t>& on) {
        float least = kNoLimit;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (on[i] != leaf) continue;
            const float color = (unpackLab(state.lab(x, y)) - unpackLab(state.lab(points[i].x, points[i].y))).norm();
            const float distance = std::hypot(static_cast<float>(x - points[i].x), static_cast<float>(y - points[i].y));
            least = std::min(least, kColorDistance * static_cast<float>(factor) * color + distance);
        }
        return least;
    };
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            const std::uint32_t leaf = state.superpixels.index(x / factor, y / factor);
            if (contested[leaf] == 0) continue;
            mask(x, y) = nearest(x, y, leaf, seeds.add, leaves.add) <= nearest(x, y, leaf, seeds.remove, leaves.remove);
        }
}

/// How far the outline of superpixels may be off [working px].
int outlineBand(const DepthQuality& quality) {
    if (!quality.present) return kOutlineBand;
    return quality.edgeOffset > 0 ? quality.edgeOffset + kOutlineBand : 0;
}

/// Working pixels that the outline may not cross: those of seeds, and of regions that further seeds chose. The user has
/// looked at these.
std::vector<Pixel> settledPixels(const Selector::State& state, const SelectionSeeds& seeds,
                                 const SuperpixelPrior& prior) {
    std::vector<Pixel> settled;
    for (const auto* list : {&seeds.add, &seeds.remove})
        for (const Pixel& p : *list) settled.push_back({p.x / state.picture.factor, p.y / state.picture.factor});
    const Image<std::uint32_t>& index = state.superpixels.index;
    for (int y = 0; y < index.height(); ++y)
        for (int x = 0; x < index.width(); ++x)
            if (prior.corrected[index(x, y)] != 0) settled.push_back({x, y});
    return settled;
}

}  // namespace

Selector::Selector(const SelectionInput& input, const Progress& progress) {
    auto state = std::make_shared<State>();
    state->picture = makeSelectionPicture(input, state->lab, progress.part(0, 0.3f));
    const BoundaryStrength boundary = findBoundaries(state->picture, progress.part(0.3f, 0.6f));
    state->workingLab = Image<PackedLab>(state->picture.lab.width(), state->picture.lab.height());
    std::ranges::transform(state->picture.lab.pixels(), state->workingLab.pixels().begin(), packLab);
    const auto pixels = static_cast<float>(state->picture.lab.size());
    const auto cell = static_cast<int>(std::clamp(std::sqrt(pixels / kSuperpixels), kMinCell, kMaxCell));
    state->superpixels = findSuperpixels(state->picture, boundary, cell, progress.part(0.6f, 0.8f));
    state->supportOf =
        findSupports(state->superpixels, state->picture.camera, state->picture.quality, progress.part(0.8f, 0.85f));
    state->tree = buildRegionTree(state->superpixels, state->supportOf, progress.part(0.85f, 1.0f));
    state_ = std::move(state);
}

BinaryMask Selector::refine(const BinaryMask& mask, int radius, const Progress& progress) const {
    CORE_ASSERT(mask.sameSize(state_->lab) && radius > 0, "a selection in this photograph");
    return refineOutline(mask, state_->lab, 1, radius, {}, progress);
}

int Selector::width() const { return state_->lab.width(); }
int Selector::height() const { return state_->lab.height(); }

BinaryMask Selector::select(const SelectionSeeds& seeds, const Progress& progress) const {
    progress.checkpoint(0);
    requireInside(seeds.add, state_->lab);
    requireInside(seeds.remove, state_->lab);
    requireConsistent(seeds);
    if (seeds.add.empty()) return BinaryMask(width(), height());
    const SeedLeaves leaves = leavesOf(*state_, seeds);
    const SuperpixelPrior prior = guess(state_->tree, leaves);
    std::vector<std::uint8_t> object = cutSuperpixels(*state_, prior, progress.part(0.1f, 0.4f));
    keepLinked(state_->superpixels, leaves.add, object);
    const SelectionPicture& picture = state_->picture;
    const int factor = picture.factor;
    BinaryMask mask =
        refineOutline(maskOf(state_->superpixels, object), state_->workingLab, 1, outlineBand(picture.quality),
                      settledPixels(*state_, seeds, prior), progress.part(0.4f, 0.7f));
    if (factor > 1) mask = refineOutline(mask, state_->lab, factor, 1, {}, progress.part(0.7f, 1.0f));
    divideContested(*state_, seeds, leaves, mask);
    for (const Pixel& p : seeds.add) mask(p.x, p.y) = 1;
    for (const Pixel& p : seeds.remove) mask(p.x, p.y) = 0;
    return mask;
}

LabelImage Selector::propose(const Progress& progress) const {
    const State& state = *state_;
    const RegionTree& tree = state.tree;
    LabelImage labels(width(), height());
    if (!state.picture.quality.present) return labels;
    const std::vector<std::uint8_t> unbarred(tree.regions.size());
    std::vector<float> votes(tree.regions.size());
    for (std::uint32_t leaf = 0; leaf < tree.leafCount; ++leaf) {
        if (leaf % kLeavesPerCheckpoint == 0)
            progress.checkpoint(0.5f * static_cast<float>(leaf) / static_cast<float>(tree.leafCount));
        if (state.supportOf[leaf] != kNoSupport) continue;
        votes[chooseRegion(tree, leaf, unbarred, kNoLimit)] += tree.regions[leaf].area;
    }
    const float least = kMinProposal * static_cast<float>(state.picture.lab.size());
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < votes.size(); ++i) {
        const Region& region = tree.regions[i];
        const bool object = region.area >= least && votes[i] >= kMinProposalVotes * region.area &&
                            2 * region.depthArea > region.area && 2 * region.supportArea < region.area;
        if (object) order.push_back(i);
    }
    std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t i) { return tree.regions[i].area; });
    std::vector<std::uint32_t> labelOf(tree.leafCount);
    std::uint32_t count = 0;
    // Regions are nested or disjoint; smaller ones come later and cut themselves out of larger ones.
    for (const std::uint32_t region : order)
        if (count < std::numeric_limits<std::uint16_t>::max()) setLeaves(tree, region, ++count, labelOf);
    for (int y = 0; y < height(); ++y) {
        progress.checkpoint(0.5f + 0.5f * static_cast<float>(y) / static_cast<float>(height()));
        for (int x = 0; x < width(); ++x)
            labels(x, y) = static_cast<std::uint16_t>(
                labelOf[state.superpixels.index(x / state.picture.factor, y / state.picture.factor)]);
    }
    return labels;
}

}  // namespace core
