// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/image.h"

namespace core::analysis {

/// What a matt surface of albedo 1 shows in a light, E(n)/π, without shadows and interreflection: spherical harmonics
/// of order 2 ([Ramamoorthi and Hanrahan 2001, eq. 12]).
class Irradiance {
  public:
    /// `radiance`: latitude-longitude, as in DirectionalMap.
    explicit Irradiance(const ImageRgb& radiance);
    /// At a unit normal; ≥ 0 per channel.
    [[nodiscard]] Vector3f at(const Vector3f& normal) const;
    /// Mean radiance over the sphere, which is also E/π averaged over all normals.
    [[nodiscard]] Vector3f mean() const;

  private:
    static constexpr std::size_t kTerms = 9;
    [[nodiscard]] static std::array<float, kTerms> harmonics(const Vector3f& d);
    std::array<Vector3f, kTerms> terms_;
};

}  // namespace core::analysis
