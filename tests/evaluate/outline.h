// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/image.h"

namespace evaluate {

/// A closed polygon, continuous pixel coordinates.
using Outline = std::vector<core::Vector2f>;

[[nodiscard]] Outline ellipseOutline(const core::Vector2f& center, const core::Vector2f& radii);

/// The closed curve through the points (uniform Catmull-Rom splines), as a fine polygon. A polygon through a
/// few points would cut off round outlines.
[[nodiscard]] Outline curveOutline(const Outline& points);

/// Gives `label` to every pixel whose centre lies inside an odd number of the outlines: a second one inside the first
/// is a hole. Pixels where `mask` (optional, same size) is 0 keep their label.
void fillOutlines(core::LabelImage& labels, const std::vector<Outline>& outlines, std::uint16_t label,
                  const core::ImageF* mask = nullptr);

}  // namespace evaluate
