// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/image.h"

namespace evaluate {

/// Error of a picture against ground truth over the masked pixels.
struct Metrics {
    double psnr = 0;       ///< [dB], of the display-encoded pictures (exposure, sRGB curve, clipped at 1)
    double ssim = 0;       ///< of display-encoded luma, 11×11 Gaussian window (σ = 1.5), mean over the mask
    double relMse = 0;     ///< of linear radiance: mean((x − t)² / (t² + 0.01·mean(t)²)), 0.1 % largest left out
    double meanRatio = 0;  ///< mean linear radiance relative to the true mean
};

/// Pixels with `label`, eroded `erosion` times by their four neighbours.
[[nodiscard]] core::Image<std::uint8_t> erodedMask(const core::LabelImage& labels, std::uint16_t label, int erosion);

/// Factor that maps the picture's 99th percentile of luminance to 1.
[[nodiscard]] float displayExposure(const core::ImageRgb& picture);

/// sRGB-encoded, clipped to [0, 1].
[[nodiscard]] core::ImageRgb displayEncoded(const core::ImageRgb& linear, float exposure);

/// Rec.709 luminance of linear radiance.
[[nodiscard]] float luminance(const core::Vector3f& c);

/// The value below which the fraction `q` of the values lies; NaN for no values.
[[nodiscard]] double quantile(std::vector<float> values, double q);

/// Angle between two vectors [degrees], accurate for small angles too.
[[nodiscard]] double angleDegrees(const core::Vector3f& a, const core::Vector3f& b);

[[nodiscard]] Metrics compare(const core::ImageRgb& picture, const core::ImageRgb& truth,
                              const core::Image<std::uint8_t>& mask, float exposure);

}  // namespace evaluate
