// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/analysis/analysis.h"

namespace core {

/// Diffuse albedo that explains the photograph's colours: colour over E(n)/π, where E is the irradiance of the
/// environment at the front's normal, without shadows and interreflection (spherical harmonics of order 2,
/// [Ramamoorthi and Hanrahan 2001, eq. 12]). Before there is an environment, E/π is what a grey of 18 % needs to show
/// the photograph's mean. At most 0.9 per channel, by scaling the whole colour. Grey of 50 % where nothing is known.

/// Of a segment: the median over its pixels per channel.
[[nodiscard]] Vector3f segmentAlbedo(const Photo& photo, const Analysis* analysis, std::uint16_t label);
/// At a pixel: over the pixels within 2 px of it that have its label.
[[nodiscard]] Vector3f albedoAt(const Photo& photo, const Analysis* analysis, int x, int y);

}  // namespace core
