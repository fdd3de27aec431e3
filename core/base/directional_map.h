// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/image.h"

namespace core {

/// Radiance over the sphere of directions, latitude-longitude, width = 2·height, camera frame: for a unit direction
/// d = (x, y, z): U = 0.5 + atan2(x, z)/(2π), V = acos(−y)/π; texel centres at +0.5; U wraps around. The centre of the
/// map is the camera's forward direction, its top is up (−y).
struct DirectionalMap {
    ImageRgb radiance;
    /// Observations per texel; 0 = filled by interpolation. Same size as `radiance`.
    ImageF coverage;
    /// Bit c: the camera clipped every observation of channel c, so its radiance is at least the observed one; the
    /// excess is estimated from surrounding pixels. Empty = nothing clipped.
    Image<std::uint8_t> clipped = {};

    [[nodiscard]] bool empty() const { return radiance.empty(); }

    /// Continuous texel coordinates (U·width, V·height) of a unit direction.
    [[nodiscard]] static Vector2f texelFromDirection(const Vector3f& d, int width, int height);
    /// Unit direction of continuous texel coordinates; inverse of `texelFromDirection`.
    [[nodiscard]] static Vector3f directionFromTexel(const Vector2f& texel, int width, int height);
    /// Solid angle [sr] of one texel of row `y`: exact, (2π/width)·(cos θ₀ − cos θ₁).
    [[nodiscard]] static float texelSolidAngle(int y, int width, int height);
    /// Bilinear look-up, wrapping in U, clamped in V.
    [[nodiscard]] Vector3f lookup(const Vector3f& d) const;
    /// Same as `lookup`, at continuous texel coordinates; U may exceed the map.
    [[nodiscard]] Vector3f lookupTexel(const Vector2f& texel) const;
    /// Solid-angle weighted mean radiance; with `minCoverage` > 0 only over texels with at least that coverage
    /// (zero when none has it).
    [[nodiscard]] Vector3f mean(float minCoverage = 0) const;
};

}  // namespace core
