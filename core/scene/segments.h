// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/base/image.h"
#include "core/base/message.h"
#include "core/scene/scene.h"

namespace core {

/// The scene with the pixels of `mask` (not 0) as the segment `labelOrName`. An existing segment keeps its edit and
/// becomes these pixels; a new one is called `labelOrName`, or gets it as its label when it is a number. Segments stay
/// disjoint: the pixels are taken from the others. One that loses all of them is dropped with a note, or is an
/// Error(Usage) when it has an edit. Throws Error(Usage) for an empty mask, a label outside 1 to 65535 and when no
/// label is free. `mask` has the photograph's size. `photo.source.segments` no longer describes the labels
/// (core/io/label_map.h saves them).
[[nodiscard]] Scene withSegment(const Scene& scene, const Image<std::uint8_t>& mask, const std::string& labelOrName,
                                Notes* notes = nullptr);

}  // namespace core
