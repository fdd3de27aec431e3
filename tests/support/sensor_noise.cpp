// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaders/shared/rng.h"

namespace test {

namespace {

bool isValid(float z) { return std::isfinite(z) && z > 0; }

/// Depth of the neighbour (of eight) with valid depth that differs most from the pixel's.
float mostDifferentNeighbour(const core::ImageF& depth, int x, int y) {
    const float own = depth(x, y);
    float found = own;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (!depth.contains(x + dx, y + dy) || !isValid(depth(x + dx, y + dy))) continue;
            const float z = depth(x + dx, y + dy);
            if (std::abs(z - own) > std::abs(found - own)) found = z;
        }
    }
    return found;
}

bool isJump(float a, float b, float edgeJump) { return std::abs(a - b) > edgeJump * std::min(a, b); }

/// Standard normal, by Box and Muller.
float gaussian(float u, float v) {
    return std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * std::numbers::pi_v<float> * v);
}

}  // namespace

bool isDepthEdge(const core::ImageF& depth, int x, int y, float edgeJump) {
    return isValid(depth(x, y)) && isJump(depth(x, y), mostDifferentNeighbour(depth, x, y), edgeJump);
}

core::ImageF withSensorNoise(const core::ImageF& depth, const SensorNoise& noise, std::uint32_t seed) {
    core::ImageF measured(depth.width(), depth.height());
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (!isValid(depth(x, y))) continue;
            const auto pixel = static_cast<std::uint32_t>(depth.index(x, y));
            float disparity = noise.focalBaseline / depth(x, y);
            const kernel::vec2 flying = kernel::rng_vec2(pixel, 0, 0, seed);
            const float other = mostDifferentNeighbour(depth, x, y);
            if (isJump(depth(x, y), other, noise.edgeJump) && flying.x < noise.flyingFraction)
                disparity += flying.y * (noise.focalBaseline / other - disparity);
            const kernel::vec2 u = kernel::rng_vec2(pixel, 0, 2, seed);
            disparity += noise.disparitySigma * gaussian(u.x, u.y);
            const float steps = std::max(std::round(disparity / noise.disparityStep), 1.0f);
            measured(x, y) = noise.focalBaseline / (steps * noise.disparityStep);
        }
    }
    return measured;
}

}  // namespace test
