// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/irradiance.h"

#include "core/base/directional_map.h"

namespace core::analysis {

std::array<float, Irradiance::kTerms> Irradiance::harmonics(const Vector3f& d) {
    return {0.282095f,
            0.488603f * d.y(),
            0.488603f * d.z(),
            0.488603f * d.x(),
            1.092548f * d.x() * d.y(),
            1.092548f * d.y() * d.z(),
            0.315392f * (3 * d.z() * d.z() - 1),
            1.092548f * d.x() * d.z(),
            0.546274f * (d.x() * d.x() - d.y() * d.y())};
}

Irradiance::Irradiance(const ImageRgb& radiance) {
    // A_l / π
    constexpr std::array<float, kTerms> kCosine{1, 2.0f / 3, 2.0f / 3, 2.0f / 3, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f};
    terms_.fill(Vector3f::Zero());
    const int width = radiance.width();
    const int height = radiance.height();
    for (int y = 0; y < height; ++y) {
        const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
        for (int x = 0; x < width; ++x) {
            const std::array<float, kTerms> basis = harmonics(DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height));
            for (std::size_t i = 0; i < kTerms; ++i) terms_[i] += kCosine[i] * basis[i] * solidAngle * radiance(x, y);
        }
    }
}

Vector3f Irradiance::at(const Vector3f& normal) const {
    const std::array<float, kTerms> basis = harmonics(normal);
    Vector3f sum = Vector3f::Zero();
    for (std::size_t i = 0; i < kTerms; ++i) sum += basis[i] * terms_[i];
    return sum.cwiseMax(0.0f);
}

Vector3f Irradiance::mean() const { return 0.282095f * terms_[0]; }

}  // namespace core::analysis
