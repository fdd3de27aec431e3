// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/directional_map.h"
#include "core/geometry/surface.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Albedo that no matt surface exceeds, per channel.
inline constexpr float kMostAlbedo = 0.9f;
/// Luminance of the albedo that it does not exceed.
inline constexpr float kMostLuminance = 0.8f;

/// Raises a light that is too weak for what the photograph shows. What is mirrored is a lower bound where the camera
/// clipped, and a guess where nothing mirrors it; wrong normals mix what is bright with what is dark beside it. The
/// matt segments, however, receive all of the light, and they reflect at most `kMostAlbedo` of it per channel and
/// `kMostLuminance` of it in luminance. Clipped pixels count as well: they are at least as bright.
///
/// Multiplied by one factor, the same for all channels, so that no colour cast arises, are the directions that are not
/// measured; with `exactShape` these are the ones without coverage and the clipped channels, without it all of them. It
/// is the least factor ≥ 1 with which at most one in a hundred of the pixels would have to reflect more (`Irradiance`
/// at the front's normals), and at most 4. Coverage is not changed. Nothing is changed where no matt segment has depth,
/// and where the shape is exact and the photograph cannot clip.
void raiseToMattSurfaces(const Scene& scene, const Surface& front, bool exactShape, DirectionalMap& light);

}  // namespace core::analysis
