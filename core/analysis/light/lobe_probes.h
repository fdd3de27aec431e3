// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/analysis/light/lobe.h"
#include "core/analysis/light/mirror_rays.h"

namespace core::analysis {

/// Lower bound of ρ, per channel.
inline constexpr float kMinRho = 0.02f;

/// Traces the whole lobe of pixels whose mirrored ray meets a true colour, and fits its width and ρ (`fitLobe`). Rays
/// that leave the picture find `missed` divided by `rho`, a first estimate. nullopt if too few pixels can be used.
[[nodiscard]] std::optional<LobeFit> probeLobes(const ReflectanceInput& in, std::span<const Mirror> mirrors,
                                                const DirectionalMap& missed, const Vector3f& rho,
                                                const Progress& progress);

}  // namespace core::analysis
