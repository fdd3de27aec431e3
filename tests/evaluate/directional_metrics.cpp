// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/directional_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/evaluate/metrics.h"

namespace evaluate {

namespace {

using core::DirectionalMap;
using core::ImageRgb;
using core::Vector3f;

constexpr double kBlurSigma = 10 * std::numbers::pi / 180;
constexpr int kBlurredRows = 48;  // texels of 3.75°, well below the blur
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Vector3f texelDirection(int x, int y, const ImageRgb& map) {
    return DirectionalMap::directionFromTexel({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, map.width(),
                                              map.height());
}

double weightedMedian(std::vector<std::pair<double, double>> valueAndWeight) {
    std::ranges::sort(valueAndWeight);
    double total = 0;
    for (const auto& entry : valueAndWeight) total += entry.second;
    double sum = 0;
    for (const auto& [value, weight] : valueAndWeight) {
        sum += weight;
        if (sum >= 0.5 * total) return value;
    }
    return kNone;
}

/// Calls `add(index, solidAngle)` for every texel whose known share is at least one half, or for all others.
template <class Add>
void forTexels(const ImageRgb& known, bool observed, const Add& add) {
    for (int y = 0; y < known.height(); ++y) {
        const double weight = DirectionalMap::texelSolidAngle(y, known.width(), known.height());
        for (int x = 0; x < known.width(); ++x)
            if ((known(x, y).x() >= 0.5f) == observed) add(known.index(x, y), weight);
    }
}

struct Maps {
    ImageRgb estimate, truth, known;
};

DirectionalError compareDirections(const Maps& fine, const Maps& blurred, bool observed) {
    DirectionalError result;
    std::vector<std::pair<double, double>> errors;
    double solidAngle = 0, sum = 0, trueSum = 0;
    forTexels(fine.known, observed, [&](std::size_t i, double weight) {
        const double value = luminance(fine.estimate[i]);
        const double expected = luminance(fine.truth[i]);
        errors.emplace_back(std::abs(value / std::max(expected, 1e-6) - 1), weight);
        solidAngle += weight;
        sum += weight * value;
        trueSum += weight * expected;
    });
    result.share = solidAngle / (4 * std::numbers::pi);
    result.medianError = weightedMedian(std::move(errors));
    result.meanRatio = trueSum > 0 ? sum / trueSum : kNone;

    double weights = 0, squared = 0, blurredSum = 0;
    forTexels(blurred.known, observed, [&](std::size_t i, double weight) {
        const double expected = luminance(blurred.truth[i]);
        const double difference = luminance(blurred.estimate[i]) - expected;
        weights += weight;
        squared += weight * difference * difference;
        blurredSum += weight * expected;
    });
    result.blurredRmse = blurredSum > 0 ? std::sqrt(squared / weights) / (blurredSum / weights) : kNone;
    return result;
}

}  // namespace

ImageRgb resampledMap(const ImageRgb& map, int height) {
    // Enough points per texel to reach every source texel.
    const int points = std::max(2, 2 * ((map.height() + height - 1) / height));
    const DirectionalMap source{map, {}};
    ImageRgb result(2 * height, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            Vector3f sum = Vector3f::Zero();
            float weights = 0;
            for (int j = 0; j < points; ++j) {
                const float v = static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(points);
                const float weight = std::sin(v / static_cast<float>(height) * std::numbers::pi_v<float>);
                for (int i = 0; i < points; ++i) {
                    const float u = static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / static_cast<float>(points);
                    const float scale = static_cast<float>(map.height()) / static_cast<float>(height);
                    sum += weight * source.lookupTexel({u * scale, v * scale});
                    weights += weight;
                }
            }
            result(x, y) = sum / weights;
        }
    }
    return result;
}

ImageRgb blurredMap(const ImageRgb& map, double sigma) {
    std::vector<Vector3f> directions;
    std::vector<float> solidAngles;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            directions.push_back(texelDirection(x, y, map));
            solidAngles.push_back(DirectionalMap::texelSolidAngle(y, map.width(), map.height()));
        }
    }
    ImageRgb result(map.width(), map.height());
    for (std::size_t i = 0; i < map.size(); ++i) {
        Vector3f sum = Vector3f::Zero();
        float weights = 0;
        for (std::size_t j = 0; j < map.size(); ++j) {
            const double cosine = std::clamp(directions[i].dot(directions[j]), -1.0f, 1.0f);
            const double angle = std::acos(cosine) / sigma;
            if (angle > 4) continue;
            const auto weight = solidAngles[j] * static_cast<float>(std::exp(-0.5 * angle * angle));
            sum += weight * map[j];
            weights += weight;
        }
        result[i] = sum / weights;
    }
    return result;
}

EnvironmentError compareEnvironment(const DirectionalMap& map, const ImageRgb& truth) {
    const int height = map.radiance.height();
    Maps fine{map.radiance, resampledMap(truth, height), ImageRgb(map.radiance.width(), height)};
    for (std::size_t i = 0; i < fine.known.size(); ++i)
        fine.known[i] = Vector3f::Constant(map.coverage[i] > 0 ? 1.0f : 0.0f);
    const int rows = std::min(height, kBlurredRows);
    const Maps blurred{blurredMap(resampledMap(map.radiance, rows), kBlurSigma),
                       blurredMap(resampledMap(truth, rows), kBlurSigma), resampledMap(fine.known, rows)};
    return {compareDirections(fine, blurred, true), compareDirections(fine, blurred, false)};
}

}  // namespace evaluate
