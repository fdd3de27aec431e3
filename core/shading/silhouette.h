// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/image.h"

namespace core {

/// A mixed pixel: it lies at the outline of an edited segment and shows both the segment and what is behind it. Colour
/// is averaged over a pixel, labels are not: an edit that ends at the label leaves a fringe of the old material outside
/// and replaces the background's share inside.
///
/// After an edit it shows coverage · shown(source) + kept + blendOriginal · keptOriginal, where `shown` is the picture
/// without this correction.
struct SilhouettePixel {
    int x = 0, y = 0;
    int sourceX = 0, sourceY = 0;  ///< source of the new material: the pixel itself, or the nearest inside
    float coverage = 0;            ///< share of the pixel that shows the segment, [0, 1]
    Vector3f kept;                 ///< radiance of the other share in the photograph
    Vector3f keptOriginal;         ///< added in proportion to the weight of the photograph
};

/// Basis for estimating the coverage of a pixel.
enum class CoverageFrom : std::uint8_t {
    Colors,  ///< colours of the pixel and its neighbours
    Labels,  ///< labels around the pixel: for glossy segments, whose rims mirror what lies beside them
};

[[nodiscard]] constexpr CoverageFrom coverageFrom(bool glossy) {
    return glossy ? CoverageFrom::Labels : CoverageFrom::Colors;
}

/// The mixed pixels along the outline of `label`, by rows: one pixel inside, up to two outside, none of another segment
/// in `edited` (indexed by label) and none without the segment's depth inside.
///
/// From colours the coverage a is that of the mixture C = a F + (1 − a) B of the nearest clean inner colour F and the
/// nearest clean outer colour B, least squares in closed form. Where F and B hardly differ, or C is not a mixture
/// of them, it tends to the label (1 or 0). From labels it is that of the straight edge that explains their Gaussian
/// mean. Pixels whose coverage matches their label are not listed.
[[nodiscard]] std::vector<SilhouettePixel> findSilhouette(const ImageRgb& photo, const LabelImage& labels,
                                                          const ImageF& depth, std::uint16_t label,
                                                          const std::vector<std::uint8_t>& edited, CoverageFrom from);

}  // namespace core
