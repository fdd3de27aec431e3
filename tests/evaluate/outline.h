// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/image.h"

namespace evaluate {

/// A closed polygon, continuous pixel coordinates.
using Outline = std::vector<core::Vector2f>;

[[nodiscard]] Outline ellipseOutline(const core::Vector2f& center, const core::Vector2f& radii);

/// The closed curve through the points (uniform Catmull-Rom splines), as a fine polygon: a few points on a rounded
/// thing, taken as corners, would cut off its roundness.
[[nodiscard]] Outline curveOutline(const Outline& points);

/// Gives `label` to every pixel whose centre lies inside an odd number of the outlines: a second one inside the first
/// is a hole. `mask`, where given (same size), keeps out pixels in which it is 0.
void fillOutlines(core::LabelImage& labels, const std::vector<Outline>& outlines, std::uint16_t label,
                  const core::ImageF* mask = nullptr);

}  // namespace evaluate
