// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/segment_areas.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "core/base/disjoint_sets.h"

namespace core {

namespace {

/// Calls `use(label, run)` for all runs of equal labels but 0.
template <class Use>
void visitRuns(const LabelImage& labels, const Use& use) {
    for (int y = 0; y < labels.height(); ++y) {
        const std::uint16_t* row =
            labels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(labels.width());
        for (int x = 0; x < labels.width();) {
            const int x0 = x;
            const std::uint16_t label = row[x];
            while (x < labels.width() && row[x] == label) ++x;
            if (label != 0) use(label, PixelRun{y, x0, x - 1});
        }
    }
}

/// The set of each run, where touching runs are in one.
std::vector<std::uint32_t> joinedRuns(const std::vector<PixelRun>& runs) {
    DisjointSets sets(runs.size());
    std::size_t above = 0;  // first run of the row above that may touch
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const PixelRun& run = runs[i];
        while (runs[above].y < run.y - 1 || (runs[above].y == run.y - 1 && runs[above].x1 < run.x0)) ++above;
        for (std::size_t j = above; runs[j].y == run.y - 1 && runs[j].x0 <= run.x1; ++j)
            sets.join(static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i));
    }
    std::vector<std::uint32_t> set(runs.size());
    for (std::uint32_t i = 0; i < runs.size(); ++i) set[i] = sets.find(i);
    return set;
}

/// Numbers the sets by size, the largest first.
void rankPieces(const std::vector<std::uint32_t>& set, SegmentPieces& pieces) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(set.size(), kNone);
    std::vector<std::size_t> pixels;
    pieces.piece.resize(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) {
        std::uint32_t& known = number[set[i]];
        if (known == kNone) {
            known = static_cast<std::uint32_t>(pixels.size());
            pixels.push_back(0);
        }
        pieces.piece[i] = known;
        pixels[known] += static_cast<std::size_t>(pieces.runs[i].x1 - pieces.runs[i].x0 + 1);
    }
    std::vector<std::uint32_t> order(pixels.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t piece) { return pixels[piece]; });
    std::vector<std::uint32_t> rank(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    for (std::uint32_t& piece : pieces.piece) piece = rank[piece];
    pieces.pixels.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) pieces.pixels[rank[i]] = pixels[i];
    pieces.count = 0;
    while (pieces.count < pieces.pixels.size() && (pieces.count == 0 || pieces.pixels[pieces.count] >= kSmallestPiece))
        ++pieces.count;
}

/// Lets the pieces grow over the rectangle around all of them until each speck has been reached. The queue holds the
/// larger piece first at each distance, so ties are its.
class SpeckOwners {
  public:
    SpeckOwners(const SegmentPieces& pieces, const Progress& progress) : owner_(pieces.pixels.size()) {
        std::iota(owner_.begin(), owner_.end(), 0U);
        missing_ = owner_.size() - pieces.count;
        placeRuns(pieces);
        constexpr std::size_t kBetweenReports = 1U << 16U;
        for (std::size_t head = 0; head < queue_.size() && missing_ > 0; ++head) {
            // It may end long before the whole rectangle is reached.
            if (head % kBetweenReports == 0)
                progress.checkpoint(static_cast<float>(head) / static_cast<float>(reached_.size()));
            grow(pieces, queue_[head]);
        }
    }
    /// The piece to which a piece belongs.
    [[nodiscard]] std::uint32_t operator[](std::size_t piece) const { return owner_[piece]; }

  private:
    void placeRuns(const SegmentPieces& pieces) {
        int x1 = 0;
        x0_ = std::numeric_limits<int>::max();
        y0_ = pieces.runs.front().y;
        for (const PixelRun& run : pieces.runs) {
            x0_ = std::min(x0_, run.x0);
            x1 = std::max(x1, run.x1);
        }
        reached_ = Image<std::uint32_t>(x1 - x0_ + 1, pieces.runs.back().y - y0_ + 1, 0);
        specks_ = reached_;
        std::vector<std::uint32_t> byPiece(pieces.runs.size());
        std::iota(byPiece.begin(), byPiece.end(), 0U);
        std::ranges::stable_sort(byPiece, {}, [&](std::uint32_t i) { return pieces.piece[i]; });
        for (const std::uint32_t i : byPiece) {
            const PixelRun& run = pieces.runs[i];
            const bool speck = pieces.piece[i] >= pieces.count;
            for (int x = run.x0; x <= run.x1; ++x) {
                const std::size_t at = reached_.index(x - x0_, run.y - y0_);
                (speck ? specks_ : reached_)[at] = pieces.piece[i] + 1;
                if (!speck) queue_.push_back(static_cast<std::uint32_t>(at));
            }
        }
    }

    void grow(const SegmentPieces& pieces, std::uint32_t from) {
        const int width = reached_.width();
        const int x = static_cast<int>(from) % width, y = static_cast<int>(from) / width;
        const std::uint32_t own = reached_[from];
        for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            if (!reached_.contains(x + dx, y + dy)) continue;
            const std::size_t at = reached_.index(x + dx, y + dy);
            if (reached_[at] != 0) continue;
            reached_[at] = own;
            queue_.push_back(static_cast<std::uint32_t>(at));
            if (specks_[at] == 0) continue;
            const std::uint32_t speck = specks_[at] - 1;
            if (owner_[speck] < pieces.count) continue;
            owner_[speck] = own - 1;
            --missing_;
        }
    }

    int x0_ = 0, y0_ = 0;
    Image<std::uint32_t> reached_;  ///< 1 + the piece that came first; 0 = none yet
    Image<std::uint32_t> specks_;   ///< 1 + the speck; 0 = none
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint32_t> owner_;
    std::size_t missing_ = 0;
};

}  // namespace

LabelTable<SegmentExtent> segmentExtents(const LabelImage& labels) {
    LabelTable<SegmentExtent> extents;
    visitRuns(labels, [&](std::uint16_t label, const PixelRun& run) {
        SegmentExtent& extent = extents[label];
        if (extent.pixels == 0) extent = {.x0 = run.x0, .y0 = run.y, .x1 = run.x1, .hash = 0xcbf29ce484222325ULL};
        extent.pixels += static_cast<std::size_t>(run.x1 - run.x0 + 1);
        extent.x0 = std::min(extent.x0, run.x0);
        extent.x1 = std::max(extent.x1, run.x1);
        extent.y1 = run.y;
        for (const int value : {run.y, run.x0, run.x1})
            extent.hash = (extent.hash ^ static_cast<std::uint64_t>(value)) * 0x100000001b3ULL;
    });
    return extents;
}

SegmentPieces segmentPieces(const LabelImage& labels, std::uint16_t label, bool joinSpecks, const Progress& progress) {
    SegmentPieces pieces;
    visitRuns(labels, [&](std::uint16_t found, const PixelRun& run) {
        if (found == label) pieces.runs.push_back(run);
    });
    CORE_ASSERT(!pieces.runs.empty(), "a segment has pixels");
    rankPieces(joinedRuns(pieces.runs), pieces);
    if (!joinSpecks || pieces.count == pieces.pixels.size()) return pieces;
    const SpeckOwners owners(pieces, progress);
    for (std::size_t piece = pieces.count; piece < pieces.pixels.size(); ++piece)
        pieces.pixels[owners[piece]] += pieces.pixels[piece];
    pieces.pixels.resize(pieces.count);
    for (std::uint32_t& piece : pieces.piece) piece = owners[piece];
    return pieces;
}

}  // namespace core
