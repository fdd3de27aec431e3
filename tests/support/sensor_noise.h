// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/image.h"

namespace test {

/// Errors of a depth camera that triangulates. The defaults are a first-generation Kinect: disparity in eighths of a
/// pixel, and together with that rounding σ(z) = 1.43·10⁻³ m⁻¹·z², as measured by Khoshelham and Oude Elberink
/// (Sensors 12, 2012). Errors of pixels are independent, as if the sensor had the photograph's resolution.
struct SensorNoise {
    float focalBaseline = 43.5f;    ///< focal length times baseline [px·m]: disparity = focalBaseline/z
    float disparityStep = 0.125f;   ///< [px] quantum of measured disparity
    float disparitySigma = 0.051f;  ///< [px], Gaussian, before rounding
    float edgeJump = 0.03f;         ///< relative difference of depth between neighbours that makes an edge
    float flyingFraction = 0.35f;   ///< of the pixels at edges, measured between the two surfaces
};

/// True planar depth [m] as measured by such a camera. A pixel has depth afterwards exactly if it had depth before. The
/// same seed gives the same noise.
[[nodiscard]] core::ImageF withSensorNoise(const core::ImageF& depth, const SensorNoise& noise = {},
                                           std::uint32_t seed = 1);

/// Whether a neighbour's depth (of eight) differs from the pixel's by more than `edgeJump` of the nearer one.
[[nodiscard]] bool isDepthEdge(const core::ImageF& depth, int x, int y, float edgeJump);

}  // namespace test
