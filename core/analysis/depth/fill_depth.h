// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Gives every labelled pixel a depth when its segment has any: planes near what was measured (`fillWithPlanes`), a
/// membrane in what is left (`fillWithMembrane`). Sensors miss glossy, dark and thin parts and the strip along an
/// outline; a pixel that the user marked belongs to its object all the same, and would otherwise keep its old material.
/// Unlabelled pixels without depth stay without it. `exact`: the depth has no noise; unless the map was enlarged,
/// planes then follow only the nearest pixels.
void fillDepth(ImageF& depth, const Photo& photo, bool exact, const Progress& progress);

/// Expected time of `fillDepth` [ns on two cores].
[[nodiscard]] double expectedFillTime(const ImageF& depth, const Photo& photo);

/// Pixels whose depth is to be replaced by that of the surface around them: gaps of a sensor, and wrong measurements.
struct DepthGaps {
    Image<std::uint8_t> isGap;  ///< 1 where depth is to be found; other pixels without depth are ignored
    int margin = 8;             ///< [px] width of the strip at the edge of a gap to which its planes are fitted
    int reach = 16;             ///< [px] greatest distance from known pixels at which gaps are filled
};

/// Fills gaps with the planes in inverse depth that fit the known pixels of their segment around them best, robustly
/// and over a disk whose radius is the margin plus twice the distance to known pixels. A surface continues with its
/// slope, up to an open outline too, where a membrane would end facing the camera. Ragged pixels along the gap do not
/// spread into it. Slopes are limited to 75 degrees. Sets `isGap` of what was filled to 0.
void fillWithPlanes(ImageF& depth, const LabelImage& labels, const Camera& camera, DepthGaps& gaps,
                    const Progress& progress);

/// Fills all labelled pixels without depth whose segment has some, with a membrane: Laplace's equation in inverse depth
/// between the segment's other pixels.
void fillWithMembrane(ImageF& depth, const LabelImage& labels, const Progress& progress = {});

}  // namespace core::analysis
