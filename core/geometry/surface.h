// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/image.h"

namespace core {

/// One layer of surface: what the photograph shows (front) or what is assumed behind it (back).
struct Surface {
    ImageF depth;      ///< planar z [m], 0 = none
    ImageV3 normal;    ///< unit, outward: front n·p < 0, back n·p > 0; zero where there is no surface
    ImageV3 position;  ///< [m], camera frame; zero where there is no surface
    ImageF area;       ///< patch area [m²], z³/(fx·fy·|n·p|) (docs/method.md#depth); 0 where there is no surface
    ImageRgb color;    ///< radiance: the photograph, or its mirror image on the back
};

}  // namespace core
