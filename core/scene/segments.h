// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/binary_mask.h"
#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace core {

// Changes of the label map together with the list of segments. All return a changed scene and leave the old one as it
// is. They have in common:
//
// - Segments stay disjoint: pixels that one gets are taken from the others. A segment that loses all of its pixels is
//   dropped with a note, or is an Error(Usage) when it has an edit.
// - Pixels of locked segments never change. A request that is about locked ones only is an Error(Usage) naming one of
//   them; otherwise they are left out with a note.
// - Edits keep their painted masks, which have the photograph's size whatever the segment's pixels are.
// - A mask has the photograph's size. One without any pixel is an Error(Usage), and so is a label that is none.
// - Changed labels have no file yet, so `photo.source.segments` becomes "" (saveProject writes one).

/// The scene with the pixels of `mask` as the segment `labelOrName`. An existing segment keeps its edit and becomes
/// these pixels; a new one is called `labelOrName`, or gets it as its label when it is a number. Throws Error(Usage)
/// for a label outside 1 to 65535 and when no label is free.
[[nodiscard]] Scene withSegment(const Scene& scene, const BinaryMask& mask, const std::string& labelOrName,
                                Notes* notes = nullptr);

/// The pixels of an existing segment changed by a mask. Throws Error(Usage) when there is nothing to take away, and
/// when nothing would be left of the segment and it has an edit.
[[nodiscard]] Scene combineSegment(const Scene& scene, std::uint16_t label, const BinaryMask& mask, MaskUse use,
                                   Notes* notes = nullptr);

/// A new segment from `mask` with everything else as in the segment `label`, and a name made from its name.
[[nodiscard]] Scene duplicateSegment(const Scene& scene, std::uint16_t label, const BinaryMask& mask,
                                     Notes* notes = nullptr);

/// All of them as one, with the name, edit and flags of the first. Notes say which edits are lost. Throws Error(Usage)
/// for less than two.
[[nodiscard]] Scene mergeSegments(const Scene& scene, std::span<const std::uint16_t> labels, Notes* notes = nullptr);

/// One segment for each 4-connected piece; specks belong to the nearest one (segmentPieces in segment_areas.h). The
/// largest keeps label and name, the others have everything else of it. Throws Error(Usage) when it is in one piece,
/// and Error(Cancelled).
[[nodiscard]] Scene splitSegment(const Scene& scene, std::uint16_t label, Notes* notes = nullptr,
                                 const Progress& progress = {});

/// Their pixels belong to no segment, and their edits are gone.
[[nodiscard]] Scene deleteSegments(const Scene& scene, std::span<const std::uint16_t> labels, Notes* notes = nullptr);

/// New segments called "object 1", "object 2" ..., or after another `name`, from a label map of objects that were
/// found. They get only pixels without a segment; an object of which segments cover more than half is left out. Throws
/// Error(Usage) when none is new. When the labels run out, a note says how many are missing.
[[nodiscard]] Scene withSegments(const Scene& scene, const LabelImage& objects, Notes* notes = nullptr,
                                 const std::string& name = "object");

/// New segments from a label map that was drawn elsewhere: called `name` if it has one label, otherwise `name` and the
/// label, which they keep where it is free. Throws Error(Usage) when it has none, or more than are free.
[[nodiscard]] Scene withImportedSegments(const Scene& scene, const LabelImage& labels, const std::string& name,
                                         Notes* notes = nullptr);

/// A mask of the pixels of some segments.
[[nodiscard]] BinaryMask maskOfSegments(const LabelImage& labels, std::span<const std::uint16_t> chosen);

}  // namespace core
