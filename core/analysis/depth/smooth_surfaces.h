// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// How far the surface of a segment is smoothed.
struct SurfaceSmoothing {
    std::uint16_t label = 0;
    float length = 0;       ///< [px] of the plate: halves bumps and dents π times as wide, removes narrower ones
    float noise = 0;        ///< σ of inverse depth [1/m]; 0 = not known, and `length` is the same all over the segment
    float correlation = 1;  ///< [px] pixels farther apart than this err independently
    float sample = 1;       ///< [px] distance of the measurements, as Photo::depthStep
    bool rounded = false;   ///< the noise is rounding: it can err alike over any distance
};

/// Replaces the depth of segments, which `filterDepth` has freed of noise from pixel to pixel, by weak plates [BZ87]:
/// the inverse depth that bends least and follows the measured one. A mirror shows every error of slope; the plate has
/// none that is narrower than `length`. Where measurements are off to one side by more than their noise allows, there
/// is relief, and the length falls to what shows it, at least the correlation of the noise. In rounded maps
/// measurements far off stop to count; where the surface turns by more than about twenty degrees within the length, or
/// depth jumps, it may fold or break (weights of Geman and McClure, found anew six times). Planes stay, and the slope
/// at the outline; segments do not feel each other. What is not `measured` (0) is spanned by the plate. Solved from
/// coarse to fine; time per pixel does not grow with the length. The same result on any number of threads. Cancellable.
void smoothSurfaces(ImageF& depth, const Image<std::uint8_t>& measured, const LabelImage& labels, const Camera& camera,
                    std::span<const SurfaceSmoothing> segments, const Progress& progress);

}  // namespace core::analysis
