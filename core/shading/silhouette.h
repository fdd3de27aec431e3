// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/image.h"

namespace core {

/// A pixel at the outline of an edited segment that shows both the segment and what is behind it. Colour is averaged
/// over a pixel, labels are not: an edit that simply ends at the label leaves a fringe of the old material outside, and
/// takes the background's part inside.
///
/// What it shows after an edit is coverage · shown(source) + kept + blendOriginal · keptOriginal, where shown is the
/// picture without this correction.
struct SilhouettePixel {
    int x = 0, y = 0;
    int sourceX = 0, sourceY = 0;  ///< where the new material is taken from: the pixel itself, or the nearest inside
    float coverage = 0;            ///< share of the pixel that shows the segment, [0, 1]
    Vector3f kept;                 ///< the other share's part of the photograph's radiance
    Vector3f keptOriginal;         ///< what the photograph's own weight adds to it
};

/// What the coverage of a pixel is estimated from.
enum class CoverageFrom : std::uint8_t {
    Colors,  ///< of the pixel and of those beside it
    Labels,  ///< around the pixel: for glossy segments, since a mirror's rim shows what is beside it
};

[[nodiscard]] constexpr CoverageFrom coverageFrom(bool glossy) {
    return glossy ? CoverageFrom::Labels : CoverageFrom::Colors;
}

/// The mixed pixels of `label`'s outline, by rows: one pixel inside, up to two outside, none of another segment in
/// `edited` (indexed by label) and none without the segment's depth inside.
///
/// From colours the coverage a is that of the mixture C = a F + (1 − a) B of the nearest clean inner colour F and the
/// nearest clean outer colour B, least squares in closed form. Where F and B hardly differ, or C is no mixture of them,
/// it tends to what the label says (1 or 0). From labels it is that of the straight edge that explains their Gaussian
/// mean. Pixels that are what their label says are not listed.
[[nodiscard]] std::vector<SilhouettePixel> findSilhouette(const ImageRgb& photo, const LabelImage& labels,
                                                          const ImageF& depth, std::uint16_t label,
                                                          const std::vector<std::uint8_t>& edited, CoverageFrom from);

}  // namespace core
