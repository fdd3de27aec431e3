// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "core/base/image.h"

namespace evaluate {

// Pictures for people: display-encoded RGB in [0, 1].

/// Unit normals as colours, 0.5 + 0.5·(x, −y, −z): surfaces facing the camera are blue; black = none.
[[nodiscard]] core::ImageRgb normalPicture(const core::ImageV3& normals);

/// Depths from red (near) to blue (far); black = none.
[[nodiscard]] core::ImageRgb depthPicture(const core::ImageF& depth, std::pair<double, double> range);
/// The 2 % and 98 % quantiles of the valid depths.
[[nodiscard]] std::pair<double, double> depthRange(const core::ImageF& depth);

/// Values from black (0) over red and yellow to white (`largest` and more).
[[nodiscard]] core::ImageRgb heatPicture(const core::ImageF& values, double largest);

/// Absolute difference of two display-encoded pictures, times two.
[[nodiscard]] core::ImageRgb differencePicture(const core::ImageRgb& a, const core::ImageRgb& b);

struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< [x0, x1) × [y0, y1)
};
/// Bounds of the non-zero pixels, widened by `margin` and clipped to the image; the whole image if there are none.
[[nodiscard]] Rect boundsOf(const core::Image<std::uint8_t>& mask, int margin);
[[nodiscard]] core::ImageRgb cropped(const core::ImageRgb& image, const Rect& rect);

/// Scaled to fit into width × height at the same aspect ratio: reduced by area averages, enlarged bilinearly.
[[nodiscard]] core::ImageRgb fitted(const core::ImageRgb& image, int width, int height);

/// 8-bit PNG of a display-encoded picture. Throws core::Error(Output).
void savePicture(const core::ImageRgb& picture, const std::string& path);

}  // namespace evaluate
