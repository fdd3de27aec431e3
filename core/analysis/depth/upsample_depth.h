// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/image.h"
#include "core/base/progress.h"

namespace core {

/// Enlarges a depth map [m] to width × height, joint bilateral ([KCLU07]) where it has edges: there the surfaces in
/// front of and behind the edge compete for a pixel by distance and similarity of colour, and the pixel lies on the
/// winner's plane. Thus edges of depth follow edges of colour, and no pixel lies between the surfaces. Elsewhere
/// inverse depth is interpolated by cubic B-splines: planes stay planes, curved surfaces have no facets. Invalid pixels
/// (0) compete in the same way: a single one is filled, a hole remains, with the outline given by the colours.
///
/// `guide`: the photograph at the new size, or nullptr to decide by distance alone.
[[nodiscard]] ImageF upsampleDepth(const ImageF& depth, int width, int height, const ImageRgb* guide,
                                   const Progress& progress = {});

}  // namespace core
