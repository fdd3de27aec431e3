// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/scene/scene.h"

namespace core::analysis {

/// 1 = the pixel shows distant light: neither it nor any neighbour has depth (a neighbour's light could mix in), and
/// its region without depth reaches the border of the picture or covers at least a fiftieth of it. Smaller enclosed
/// regions are gaps of the sensor (shadows of its projector, shiny spots).
[[nodiscard]] Image<std::uint8_t> findDistantPixels(const ImageF& depth);

/// Colour of the distant pixel where a ray in direction `d` ends: the vanishing point of `d`, if it lies in the picture
/// and is distant.
[[nodiscard]] std::optional<Vector3f> distantColor(const Photo& photo, const Image<std::uint8_t>& distant,
                                                   const Vector3f& d);

}  // namespace core::analysis
