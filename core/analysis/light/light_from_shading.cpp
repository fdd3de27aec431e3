// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/light_from_shading.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/analysis/light/reflectance.h"
#include "core/base/color.h"

namespace core::analysis {
namespace {

constexpr std::size_t kMaxShadedPixels = 60000;
constexpr int kMaxIterations = 20;
constexpr float kMeanReflectance = 0.18f;  // what light meters are calibrated to
constexpr float kLargestReflectance = 0.8f;
constexpr double kBrightQuantile = 0.99;
constexpr float kMaxGradient = 1.2f;         // |v|
constexpr float kOutlier = 0.25f;            // of log luminance
constexpr float kPriorWeight = 0.002f;       // of the prior against one pixel
const Vector3f kPriorGradient{0, -0.4f, 0};  // from above
constexpr float kSmallestIrradiance = 0.1f;  // of the mean one; keeps the logarithm finite

struct ShadedPixel {
    Vector3f normal;
    float logLuminance;
    std::uint16_t label;
};

float irradiance(const Vector3f& gradient, const Vector3f& normal) {
    return std::max(1 + gradient.dot(normal), kSmallestIrradiance);
}

Vector3f clampedGradient(const Vector3f& gradient) {
    const float length = gradient.norm();
    return length > kMaxGradient ? Vector3f(kMaxGradient / length * gradient) : gradient;
}

/// v of E(n) ∝ 1 + v·n: Gauss-Newton with Huber's weights, the albedos eliminated as means per segment.
Vector3f fitGradient(const std::vector<ShadedPixel>& pixels) {
    Vector3f gradient = kPriorGradient;
    if (pixels.empty()) return gradient;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
        struct Mean {
            double weight = 0, residual = 0;
            Eigen::Vector3d slope = Eigen::Vector3d::Zero();
        };
        std::map<std::uint16_t, Mean> means;
        std::map<std::uint16_t, double> albedo;  // logarithm
        // Huber's weights need the residuals, those the albedos: two rounds.
        for (int round = 0; round < 2; ++round) {
            means.clear();
            for (const ShadedPixel& pixel : pixels) {
                const float e = irradiance(gradient, pixel.normal);
                const double residual = static_cast<double>(pixel.logLuminance - std::log(e));
                const double off = round == 0 ? 0 : std::abs(residual - albedo[pixel.label]);
                const double weight = off > kOutlier ? kOutlier / off : 1;
                Mean& mean = means[pixel.label];
                mean.weight += weight;
                mean.residual += weight * residual;
                mean.slope += weight * (pixel.normal / e).cast<double>();
            }
            for (auto& [label, mean] : means) {
                mean.residual /= mean.weight;
                mean.slope /= mean.weight;
                albedo[label] = mean.residual;
            }
        }
        const double prior = static_cast<double>(kPriorWeight) * static_cast<double>(pixels.size());
        Eigen::Matrix3d matrix = prior * Eigen::Matrix3d::Identity();
        Eigen::Vector3d vector = prior * (kPriorGradient - gradient).cast<double>();
        for (const ShadedPixel& pixel : pixels) {
            const float e = irradiance(gradient, pixel.normal);
            const Mean& mean = means[pixel.label];
            const double residual = static_cast<double>(pixel.logLuminance - std::log(e)) - mean.residual;
            const double weight = std::abs(residual) > kOutlier ? kOutlier / std::abs(residual) : 1;
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

}  // namespace

float ShadingLight::radiance(const Vector3f& d) const {
    const float k = concentration;
    const float scale = k < 1e-3f ? 1.0f : k / std::sinh(k);
    return mean * scale * std::exp(k * axis.dot(d));
}

ShadingLight lightFromShading(const Photo& photo, const Surface& front, const Progress& progress) {
    progress.checkpoint(0);
    std::vector<float> luminances;
    std::vector<std::size_t> shaded;
    Eigen::Vector3d meanNormal = Eigen::Vector3d::Zero();
    double sum = 0;
    for (std::size_t i = 0; i < photo.color.size(); ++i) {
        const float y = luminance(photo.color[i]);
        if (!(front.depth[i] > 0) || !std::isfinite(y)) continue;
        luminances.push_back(std::max(y, 0.0f));
        sum += static_cast<double>(luminances.back());
        meanNormal += front.normal[i].cast<double>();
        if (photo.labels[i] != 0 && y > 0) shaded.push_back(i);
    }
    ShadingLight light;
    if (luminances.empty() || !(sum > 0)) return light;

    std::vector<ShadedPixel> pixels;
    const std::size_t stride = shaded.size() / kMaxShadedPixels + 1;
    for (std::size_t k = 0; k < shaded.size(); k += stride) {
        const std::size_t i = shaded[k];
        const int x = static_cast<int>(i) % photo.color.width();
        const int y = static_cast<int>(i) / photo.color.width();
        if (clippedChannels(photo, x, y) != 0 || !isInterior(photo.labels, front.depth, x, y)) continue;
        pixels.push_back({front.normal[i], std::log(luminance(photo.color[i])), photo.labels[i]});
    }
    progress.checkpoint(0);
    const Vector3f gradient = fitGradient(pixels);
    const float length = gradient.norm();
    if (length > 1e-4f) light.axis = gradient / length;
    light.concentration = concentrationOf(0.5f * length);

    const auto bright =
        luminances.begin() + static_cast<std::ptrdiff_t>(kBrightQuantile * static_cast<double>(luminances.size() - 1));
    std::ranges::nth_element(luminances, bright);
    const auto average = static_cast<float>(sum / static_cast<double>(luminances.size()));
    const Vector3f facing = (meanNormal / static_cast<double>(luminances.size())).cast<float>();
    light.mean = std::min(average / kMeanReflectance, *bright / kLargestReflectance) / irradiance(gradient, facing);
    return light;
}

}  // namespace core::analysis
