// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/back/mirror_image.h"

namespace core::analysis {

/// The back of boxes, books and other objects with flat faces and sharp edges: where a flat visible face ends at the
/// outline, a hidden face continues behind that edge at a right angle to it. The object is what all hidden faces
/// enclose.
struct FlatFaces {
    BackSamples samples;  ///< not covered where the pixel's ray meets no hidden face
    /// Share of the known outline where a flat face ends in a straight edge, [0, 1].
    float outline = 0;
    /// Maximum of 1 − `outline` and the share of the front that lies outside a hidden face.
    float error = 1;
    int faces = 0;  ///< hidden faces found
};
[[nodiscard]] FlatFaces continueFlatFaces(const SegmentPixels& segment);

}  // namespace core::analysis
