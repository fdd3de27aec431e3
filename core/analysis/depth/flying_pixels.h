// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// Removes (sets to 0) measured depth along the outlines of segments that belongs to what lies behind them: flying
/// pixels between the two surfaces, the ramp of a map whose edges are blurred, and the background inside a generous
/// outline. An outline pixel counts as such when it lies well on the way from the segment nearby to what is behind, and
/// depth does not jump at the outline; a single pixel between the surfaces counts even beside a jump. Where most of the
/// outline nearby is of that kind, everything there that lies as far back is removed. The rim of a round object falls
/// away too, but jumps to the background at its outline. Supports (tables, walls) and unlabelled pixels are left alone.
/// `depth`: planar z [m], 0 = none.
///
/// `depthSampleSpacing` as in `Photo`: the ramps of enlarged maps are followed as far as they are steeper than relief.
/// Colours that guide the enlargement make ramps end in a jump; such ramps are recognised by their steepness, unless
/// depth falls like a plane seen at a grazing angle.
void removeFlyingPixels(ImageF& depth, const LabelImage& labels, const Camera& camera, float depthSampleSpacing,
                        const Progress& progress);

}  // namespace core::analysis
