// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/scene/scene.h"

namespace core::analysis {

/// 1 = the pixel shows distant light: it has no depth and no neighbour with depth, which would mix with it, and the
/// region without depth that it is part of reaches the border of the picture or covers at least a fiftieth of it.
/// Smaller enclosed regions are what a sensor missed (shadows of its projector, shiny spots), not the distance.
[[nodiscard]] Image<std::uint8_t> findDistantPixels(const ImageF& depth);

/// The colour of the distant pixel that a ray leaving in direction `d` ends in: at the vanishing point of `d`, when it
/// lies in the picture and is distant.
[[nodiscard]] std::optional<Vector3f> distantColor(const Photo& photo, const Image<std::uint8_t>& distant,
                                                   const Vector3f& d);

}  // namespace core::analysis
