// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/light_from_shading.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/analysis/light/mirror_rays.h"
#include "core/base/color.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

constexpr std::size_t kMaxShadedPixels = 60000;
constexpr int kMaxIterations = 20;
/// Mean reflectance that light meters are calibrated to.
constexpr float kMeanReflectance = 0.18f;
constexpr float kMaxReflectance = 0.8f;
/// Quantile of luminance that has at most `kMaxReflectance`.
constexpr double kBrightQuantile = 0.99;
/// Maximum length of v.
constexpr float kMaxGradient = 1.2f;
/// Residual of log luminance beyond which a pixel is an outlier (Huber).
constexpr float kOutlier = 0.25f;
/// Weight of the prior relative to one pixel.
constexpr float kPriorWeight = 0.002f;
/// Light from above.
const Vector3f kPriorGradient{0, -0.4f, 0};
/// Minimum irradiance relative to the mean; keeps the logarithm finite.
constexpr float kMinIrradiance = 0.1f;

/// κ of the lamp: half of it lies within 13 degrees.
constexpr double kLampConcentration = 27;

/// κ/sinh κ·exp(κ c), whose mean over the sphere is 1.
double lobe(double concentration, double cosine) {
    if (concentration < 1e-3) return 1;
    return 2 * concentration / (1 - std::exp(-2 * concentration)) * std::exp(concentration * (cosine - 1));
}

/// A pixel the gradient is fitted to.
struct ShadedPixel {
    Vector3f normal;
    float logLuminance;
    std::uint16_t label;
};

float irradiance(const Vector3f& gradient, const Vector3f& normal) {
    return std::max(1 + gradient.dot(normal), kMinIrradiance);
}

Vector3f clampedGradient(const Vector3f& gradient) {
    const float length = gradient.norm();
    return length > kMaxGradient ? Vector3f(kMaxGradient / length * gradient) : gradient;
}

/// Weighted means over the pixels of one segment.
struct SegmentMean {
    double weight = 0;
    double residual = 0;                              ///< log luminance over irradiance: logarithm of the albedo
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();  ///< derivative of log irradiance by v
};
using SegmentMeans = std::map<std::uint16_t, SegmentMean>;

double residualOf(const ShadedPixel& pixel, float irradiance) {
    return static_cast<double>(pixel.logLuminance - std::log(irradiance));
}

double huberWeight(double residual) {
    const double off = std::abs(residual);
    return off > kOutlier ? kOutlier / off : 1;
}

/// Albedo and mean slope of every segment. Huber's weights need the residuals and these the albedos, hence two rounds.
SegmentMeans segmentMeans(const std::vector<ShadedPixel>& pixels, const Vector3f& gradient) {
    SegmentMeans means;
    for (int round = 0; round < 2; ++round) {
        SegmentMeans next;
        for (const ShadedPixel& pixel : pixels) {
            const float e = irradiance(gradient, pixel.normal);
            const double residual = residualOf(pixel, e);
            const double weight = round == 0 ? 1 : huberWeight(residual - means[pixel.label].residual);
            SegmentMean& mean = next[pixel.label];
            mean.weight += weight;
            mean.residual += weight * residual;
            mean.slope += weight * (pixel.normal / e).cast<double>();
        }
        for (auto& [label, mean] : next) {
            mean.residual /= mean.weight;
            mean.slope /= mean.weight;
        }
        means = std::move(next);
    }
    return means;
}

/// v of E(n) ∝ 1 + v·n: Gauss-Newton with Huber's weights, the albedos eliminated as means per segment.
Vector3f fitGradient(const std::vector<ShadedPixel>& pixels) {
    Vector3f gradient = kPriorGradient;
    if (pixels.empty()) return gradient;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
        SegmentMeans means = segmentMeans(pixels, gradient);
        const double prior = static_cast<double>(kPriorWeight) * static_cast<double>(pixels.size());
        Eigen::Matrix3d matrix = prior * Eigen::Matrix3d::Identity();
        Eigen::Vector3d vector = prior * (kPriorGradient - gradient).cast<double>();
        for (const ShadedPixel& pixel : pixels) {
            const float e = irradiance(gradient, pixel.normal);
            const SegmentMean& mean = means[pixel.label];
            const double residual = residualOf(pixel, e) - mean.residual;
            const double weight = huberWeight(residual);
            const Eigen::Vector3d slope = (pixel.normal / e).cast<double>() - mean.slope;
            matrix += weight * slope * slope.transpose();
            vector += weight * residual * slope;
        }
        const Vector3f next = clampedGradient(gradient + matrix.ldlt().solve(vector).cast<float>());
        const bool done = (next - gradient).norm() < 1e-4f;
        gradient = next;
        if (done) break;
    }
    return gradient;
}

/// κ whose mean direction has length `m`: inverse of coth κ − 1/κ.
float concentrationOf(float m) {
    float low = 0;
    float high = 20;
    for (int i = 0; i < 40; ++i) {
        const float middle = 0.5f * (low + high);
        const float length = middle < 1e-2f ? middle / 3 : 1 / std::tanh(middle) - 1 / middle;
        (length < m ? low : high) = middle;
    }
    return 0.5f * (low + high);
}

/// All pixels with depth.
struct Brightness {
    std::vector<std::size_t> pixels;  ///< by index
    std::vector<float> luminances;
    double sum = 0;                   ///< of the luminances
    std::vector<std::size_t> shaded;  ///< labelled pixels with light, by index
};

Brightness measureBrightness(const Photo& photo, const Surface& front) {
    Brightness result;
    for (std::size_t i = 0; i < photo.color.size(); ++i) {
        const float y = luminance(photo.color[i]);
        if (!(front.depth[i] > 0) || !std::isfinite(y)) continue;
        result.pixels.push_back(i);
        result.luminances.push_back(std::max(y, 0.0f));
        result.sum += static_cast<double>(result.luminances.back());
        if (photo.labels[i] != 0 && y > 0) result.shaded.push_back(i);
    }
    return result;
}

/// Mean radiance of the light that explains the photograph's brightness. The brightest surfaces are judged by the light
/// that falls on them, which is more than on most: otherwise what faces the light would be edited to pure white.
float meanRadiance(Brightness brightness, const Surface& front, const Vector3f& gradient) {
    double received = 0;
    for (std::size_t k = 0; k < brightness.pixels.size(); ++k) {
        const float e = irradiance(gradient, front.normal[brightness.pixels[k]]);
        received += static_cast<double>(e);
        brightness.luminances[k] /= e;
    }
    const auto average = static_cast<float>(brightness.sum / received);
    const float bright = quantile(brightness.luminances, kBrightQuantile);
    return std::min(average / kMeanReflectance, bright / kMaxReflectance);
}

/// At most about `kMaxShadedPixels`, without clipped ones and outlines.
std::vector<ShadedPixel> shadedPixels(const Photo& photo, const Surface& front,
                                      const std::vector<std::size_t>& candidates) {
    std::vector<ShadedPixel> pixels;
    const std::size_t stride = candidates.size() / kMaxShadedPixels + 1;
    for (std::size_t k = 0; k < candidates.size(); k += stride) {
        const std::size_t i = candidates[k];
        const int x = static_cast<int>(i) % photo.color.width();
        const int y = static_cast<int>(i) / photo.color.width();
        if (clippedChannels(photo, x, y) != 0 || !isInterior(photo.labels, front.depth, x, y)) continue;
        pixels.push_back({front.normal[i], std::log(luminance(photo.color[i])), photo.labels[i]});
    }
    return pixels;
}

}  // namespace

float ShadingLight::radiance(const Vector3f& d) const {
    const auto k = static_cast<double>(concentration);
    const auto c = static_cast<double>(axis.dot(d));
    const auto most = static_cast<double>(limit);
    const double broad = static_cast<double>(mean) * lobe(k, c);
    if (!(static_cast<double>(mean) * lobe(k, 1) > most)) return static_cast<float>(broad);
    // Half the integral of B − limit over the cosines above that at which B reaches the limit.
    const double edge = std::max(std::log(most / (static_cast<double>(mean) * lobe(k, 0))) / k, -1.0);
    const double above = static_cast<double>(mean) * (lobe(k, 1) - lobe(k, edge)) / k;
    const double excess = 0.5 * (above - most * (1 - edge));
    return static_cast<float>(std::min(broad, most) + excess * lobe(kLampConcentration, c));
}

ShadingLight lightFromShading(const Photo& photo, const Surface& front, const Progress& progress) {
    progress.checkpoint(0);
    Brightness brightness = measureBrightness(photo, front);
    ShadingLight light;
    if (brightness.luminances.empty() || !(brightness.sum > 0)) return light;

    const std::vector<ShadedPixel> pixels = shadedPixels(photo, front, brightness.shaded);
    progress.checkpoint(0.5f);
    const Vector3f gradient = fitGradient(pixels);
    const float length = gradient.norm();
    if (length > 1e-4f) light.axis = gradient / length;
    light.concentration = concentrationOf(0.5f * length);

    light.limit = quantile(std::vector<float>(brightness.luminances), kBrightQuantile);
    light.mean = std::min(meanRadiance(std::move(brightness), front, gradient), light.limit);
    return light;
}

}  // namespace core::analysis
