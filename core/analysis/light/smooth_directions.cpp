// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/smooth_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace core::analysis {
namespace {

constexpr std::array<float, 6> kTriedWidths{1, 2, 4, 8, 16, 32};  // tried, in texels of the equator
constexpr double kErrorTolerance = 1.01;
using Sum = Eigen::Array4f;  // radiance times weight, weight

/// Two box filters in a row; `at(i)` for i in [0, count), `wrap`: the ends meet.
template <class At>
void boxTwice(int count, int radius, bool wrap, std::vector<Sum>& prefix, std::vector<Sum>& line, const At& at) {
    if (radius <= 0) return;
    const int reach = std::min(radius, wrap ? (count - 1) / 2 : count - 1);
    line.resize(static_cast<std::size_t>(count));
    prefix.resize(static_cast<std::size_t>(count + 2 * reach + 1));
    for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = at(i);
        prefix[0] = Sum::Zero();
        for (int i = -reach; i < count + reach; ++i) {
            const int source = wrap ? (i + count) % count : i;
            const bool inside = source >= 0 && source < count;
            const auto k = static_cast<std::size_t>(i + reach);
            prefix[k + 1] = prefix[k] + (inside ? line[static_cast<std::size_t>(source)] : Sum(Sum::Zero()));
        }
        for (int i = 0; i < count; ++i)
            at(i) = (prefix[static_cast<std::size_t>(i + 2 * reach + 1)] - prefix[static_cast<std::size_t>(i)]) /
                    static_cast<float>(2 * reach + 1);
    }
}

/// Radius of the box that twice in a row has about the given standard deviation, both in texels.
int boxRadius(float sigma) { return static_cast<int>(std::lround(0.5f * (std::sqrt(6 * sigma * sigma + 1) - 1))); }

/// Weighted sums of radiance around every texel; `sigma` in texels of the equator.
Image<Sum> blurredSums(const DirectionalMap& map, float sigma) {
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    Image<Sum> sums(width, height, Sum::Zero());
    for (int y = 0; y < height; ++y) {
        const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
        for (int x = 0; x < width; ++x) {
            const float weight = solidAngle * map.coverage(x, y);
            if (weight > 0) sums(x, y) << weight * map.radiance(x, y).array(), weight;
        }
    }
    std::vector<Sum> prefix;
    std::vector<Sum> line;
    for (int y = 0; y < height; ++y) {
        const float sine =
            std::sin(std::numbers::pi_v<float> * (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
        boxTwice(width, boxRadius(sigma / sine), true, prefix, line, [&](int x) -> Sum& { return sums(x, y); });
    }
    for (int x = 0; x < width; ++x)
        boxTwice(height, boxRadius(sigma), false, prefix, line, [&](int y) -> Sum& { return sums(x, y); });
    return sums;
}

/// How `other` is predicted by `one` blurred, over the texels that both know.
double predictionError(const DirectionalMap& one, const DirectionalMap& other, float sigma) {
    const int width = one.radiance.width();
    const int height = one.radiance.height();
    const Image<Sum> sums = blurredSums(one, sigma);
    double error = 0;
    for (int y = 0; y < height; ++y) {
        const auto solidAngle = static_cast<double>(DirectionalMap::texelSolidAngle(y, width, height));
        for (int x = 0; x < width; ++x) {
            if (!(one.coverage(x, y) > 0) || !(other.coverage(x, y) > 0)) continue;
            const Sum& sum = sums(x, y);
            for (int c = 0; c < 3; ++c) {
                const float predicted = sum[c] / sum[3];
                const float seen = other.radiance(x, y)[c];
                const float scale = std::abs(predicted) + std::abs(seen);
                if (scale > 0) error += solidAngle * static_cast<double>(std::abs(predicted - seen) / scale);
            }
        }
    }
    return error;
}

}  // namespace

void smoothDirections(DirectionalMap& map, float sigma) {
    const float texels = sigma * static_cast<float>(map.radiance.height()) / std::numbers::pi_v<float>;
    const Image<Sum> sums = blurredSums(map, texels);
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (map.coverage[i] > 0 && sums[i][3] > 0) map.radiance[i] = (sums[i].head<3>() / sums[i][3]).matrix();
    map.clipped = {};
}

float agreementWidth(const DirectionalMap& one, const DirectionalMap& other) {
    const int width = one.radiance.width();
    const int height = one.radiance.height();
    double shared = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (one.coverage(x, y) > 0 && other.coverage(x, y) > 0)
                shared += static_cast<double>(DirectionalMap::texelSolidAngle(y, width, height));
    if (shared < kMinSharedSolidAngle) return 0;
    std::array<double, kTriedWidths.size() + 1> errors{};
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const float sigma = k == 0 ? 0 : kTriedWidths[k - 1];
        errors[k] = predictionError(one, other, sigma) + predictionError(other, one, sigma);
    }
    const double best = *std::ranges::min_element(errors);
    const auto chosen = static_cast<std::size_t>(
        std::ranges::find_if(errors, [&](double e) { return e <= kErrorTolerance * best; }) - errors.begin());
    return chosen == 0 ? 0 : kTriedWidths[chosen - 1] * std::numbers::pi_v<float> / static_cast<float>(height);
}

}  // namespace core::analysis
