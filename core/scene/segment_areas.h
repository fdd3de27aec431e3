// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/image.h"
#include "core/base/label_table.h"
#include "core/base/progress.h"

namespace core {

/// Where the pixels of a label are.
struct SegmentExtent {
    std::size_t pixels = 0;
    int x0 = 0, y0 = 0;    ///< first column and row [px]
    int x1 = -1, y1 = -1;  ///< last column and row [px]
    /// Of the exact pixels: equal for two label maps of one size that agree about this label.
    std::uint64_t hash = 0;

    bool operator==(const SegmentExtent&) const = default;
};

/// The extents of all labels; those that do not occur have no pixels.
[[nodiscard]] LabelTable<SegmentExtent> segmentExtents(const LabelImage& labels);

/// Smaller 4-connected pieces [px] are specks of the one they lie nearest to.
inline constexpr std::size_t kSmallestPiece = 10;

/// Pixels x0 to x1 of row y, both included.
struct PixelRun {
    int y = 0, x0 = 0, x1 = 0;
};

/// The pixels of one label, apart where they do not hang together.
struct SegmentPieces {
    std::vector<PixelRun> runs;        ///< in reading order
    std::vector<std::uint32_t> piece;  ///< of each run
    std::vector<std::size_t> pixels;   ///< of each piece
    std::size_t count = 0;             ///< of pieces without specks, ≥ 1
};

/// The 4-connected pieces of a label, the largest first, equal ones in reading order. A piece smaller than
/// kSmallestPiece is a speck, unless it is the first. With `joinSpecks` specks become part of the piece nearest to them
/// by city-block distance, of the larger one where two are as near; otherwise they stay behind the `count` others.
/// Throws Error(Cancelled).
[[nodiscard]] SegmentPieces segmentPieces(const LabelImage& labels, std::uint16_t label, bool joinSpecks,
                                          const Progress& progress = {});

}  // namespace core
