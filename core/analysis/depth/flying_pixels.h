// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// Removes (sets to 0) measured depth along the outlines of segments that belongs to what lies behind them: flying
/// pixels between the two surfaces, the ramp of a map whose edges are blurred, and the background that a generous
/// outline takes in. A pixel of the outline is of that kind when it lies well on the way from the segment near by to
/// what is behind, and depth does not jump where the outline is; where most of the outline near by is so, all that lies
/// as far back there is removed.
/// The rim of a round object does fall away too, but jumps to the background at its outline. Supports (tables, walls)
/// and what is not labelled are left alone. `depth`: planar z [m], 0 = none. `pixelsPerSample`: as Photo::depthStep;
/// the ramps of enlarged maps are followed as far as they are steeper than relief. Colours that guide the enlargement
/// make them end in a jump; they are told by how fast they fall, if no part of a plane seen at a small angle does.
void removeFlyingPixels(ImageF& depth, const LabelImage& labels, const Camera& camera, float pixelsPerSample,
                        const Progress& progress);

}  // namespace core::analysis
