// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/image.h"
#include "core/base/progress.h"

namespace core {

/// Enlarges a depth map [m] to width × height, joint bilateral ([KCLU07]) where it has edges: there the surface before
/// and the surface behind the edge compete for a pixel by distance and by likeness of colour, and the pixel continues
/// the winner's plane, so that edges of depth follow edges of colour and no pixel lies between the surfaces. Elsewhere
/// inverse depth is interpolated by cubic B-splines: planes stay planes, curved surfaces have no facets. Invalid pixels
/// (0) compete in the same way: a lone one is filled, a hole remains, with the outline that the colours have.
///
/// `guide` is the photograph at the new size, or nullptr: then distance alone decides.
[[nodiscard]] ImageF upsampleDepth(const ImageF& depth, int width, int height, const ImageRgb* guide,
                                   const Progress& progress = {});

}  // namespace core
