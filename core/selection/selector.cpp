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
#include "core/selection/enclosed_parts.h"
#include "core/selection/guess_object.h"
#include "core/selection/refine_outline.h"
#include "core/selection/selector_state.h"

namespace core {

namespace {

/// Number of superpixels that is aimed at, and the sides of their grid cells [working px].
constexpr float kSuperpixels = 16000;
constexpr float kMinCell = 3;
constexpr float kMaxCell = 8;
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

/// Draws the discs into `mask` and returns the working pixels that the outline may not cross: those of seeds and discs,
/// and of regions that further seeds chose. The user has looked at these.
BinaryMask settle(const Selector::State& state, const SelectionSeeds& seeds, const ObjectGuess& guess,
                  BinaryMask& mask) {
    BinaryMask settled(mask.width(), mask.height());
    for (std::size_t i = 0; i < settled.size(); ++i) settled[i] = guess.corrected[state.superpixels.index[i]];
    for (const auto* list : {&seeds.add, &seeds.remove})
        for (const Pixel& p : *list) settled(p.x / state.picture.factor, p.y / state.picture.factor) = 1;
    for (const CertainDisc& disc : guess.discs) {
        const int reach = static_cast<int>(disc.radius);
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                const int x = disc.at.x + dx, y = disc.at.y + dy;
                if (!mask.contains(x, y) || std::hypot(static_cast<float>(dx), static_cast<float>(dy)) > disc.radius)
                    continue;
                mask(x, y) = disc.value;
                settled(x, y) = 1;
            }
    }
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
    const ObjectGuess guess = guessObject(*state_, seeds, leaves);
    std::vector<std::uint8_t> object = cutSuperpixels(*state_, guess.prior, progress.part(0.1f, 0.4f));
    keepLinked(state_->superpixels, leaves.add, object);
    const SelectionPicture& picture = state_->picture;
    const int factor = picture.factor;
    BinaryMask mask = maskOf(state_->superpixels, object);
    const BinaryMask settled = settle(*state_, seeds, guess, mask);
    mask = refineOutline(mask, state_->workingLab, 1, outlineBand(picture.quality), settled, progress.part(0.4f, 0.7f));
    std::vector<Pixel> removed;
    for (const Pixel& p : seeds.remove) removed.push_back({p.x / factor, p.y / factor});
    takeEnclosed(picture, removed, mask);
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
