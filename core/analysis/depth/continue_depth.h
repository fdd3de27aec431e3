// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"

namespace core::analysis {

/// Pixels whose depth is to be continued from the others of their segment: gaps of a sensor, and what it got wrong.
struct DepthGaps {
    Image<std::uint8_t> isGap;  ///< 1 where depth is to be found; pixels without depth are no neighbours either
    int margin = 8;             ///< [px] of known pixels beside a gap that say how it goes on
    int reach = 16;             ///< [px] gaps farther from any known pixel are left as they are
};

/// Gives gap pixels the depth of the plane in inverse depth that fits the known pixels of their segment about them
/// best: weighted least squares, least weight for what is far off, as wide as the gap and the margin. A surface goes on
/// with its slope, up to an open outline too, where a membrane would end facing the camera, and jagged pixels beside
/// the gap do not run on into it. Slopes are limited to 75 degrees. Sets `isGap` of what was filled to 0.
void continueDepth(ImageF& depth, const LabelImage& labels, const Camera& camera, DepthGaps& gaps,
                   const Progress& progress);

}  // namespace core::analysis
