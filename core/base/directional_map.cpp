// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/directional_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {
namespace {
constexpr float kPi = std::numbers::pi_v<float>;
}

Vector2f DirectionalMap::texelFromDirection(const Vector3f& d, int width, int height) {
    const float u = 0.5f + std::atan2(d.x(), d.z()) / (2 * kPi);
    // acos(−y) loses half its digits at the poles; atan2 does not.
    const float v = std::atan2(std::hypot(d.x(), d.z()), -d.y()) / kPi;
    return {u * static_cast<float>(width), v * static_cast<float>(height)};
}

Vector3f DirectionalMap::directionFromTexel(const Vector2f& texel, int width, int height) {
    const float phi = 2 * kPi * (texel.x() / static_cast<float>(width) - 0.5f);
    const float theta = kPi * texel.y() / static_cast<float>(height);
    return {std::sin(theta) * std::sin(phi), -std::cos(theta), std::sin(theta) * std::cos(phi)};
}

float DirectionalMap::texelSolidAngle(int y, int width, int height) {
    const double step = std::numbers::pi / height;
    return static_cast<float>(2 * std::numbers::pi / width * (std::cos(y * step) - std::cos((y + 1) * step)));
}

Vector3f DirectionalMap::lookup(const Vector3f& d) const {
    return lookupTexel(texelFromDirection(d, radiance.width(), radiance.height()));
}

Vector3f DirectionalMap::lookupTexel(const Vector2f& coordinates) const {
    if (empty()) return Vector3f::Zero();
    const int width = radiance.width();
    const int height = radiance.height();
    const Vector2f texel = coordinates - Vector2f(0.5f, 0.5f);
    const float floorX = std::floor(texel.x());
    const float floorY = std::floor(texel.y());
    const float fx = texel.x() - floorX;
    const float fy = texel.y() - floorY;
    const int x0 = (static_cast<int>(floorX) % width + width) % width;
    const int x1 = (x0 + 1) % width;
    const int y0 = std::clamp(static_cast<int>(floorY), 0, height - 1);
    const int y1 = std::clamp(static_cast<int>(floorY) + 1, 0, height - 1);
    return (1 - fy) * ((1 - fx) * radiance(x0, y0) + fx * radiance(x1, y0)) +
           fy * ((1 - fx) * radiance(x0, y1) + fx * radiance(x1, y1));
}

Vector3f DirectionalMap::mean(float minCoverage) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0;
    for (int y = 0; y < radiance.height(); ++y) {
        const double solidAngle = texelSolidAngle(y, radiance.width(), radiance.height());
        for (int x = 0; x < radiance.width(); ++x) {
            if (minCoverage > 0 && coverage(x, y) < minCoverage) continue;
            sum += solidAngle * radiance(x, y).cast<double>();
            weight += solidAngle;
        }
    }
    if (weight <= 0) return Vector3f::Zero();
    return (sum / weight).cast<float>();
}

}  // namespace core
