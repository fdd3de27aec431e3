// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>

#include "core/base/image.h"

namespace test {

/// Writes a file in MERL's binary format from a function of half angle, difference angle and azimuth of the difference
/// [rad], evaluated at the centres of the bins. Offsets are those of MERL's own BRDFRead.cpp, not of our reader.
inline void writeMerl(const std::string& path, const std::function<core::Vector3f(double, double, double)>& brdf) {
    using std::numbers::pi;
    constexpr std::array<std::int32_t, 3> kDimensions{90, 90, 180};
    constexpr std::size_t kEntries = 90 * 90 * 360 / 2;
    std::string bytes(sizeof(kDimensions) + 3 * kEntries * sizeof(double), '\0');
    std::memcpy(bytes.data(), kDimensions.data(), sizeof(kDimensions));
    for (std::size_t h = 0; h < 90; ++h)
        for (std::size_t d = 0; d < 90; ++d)
            for (std::size_t p = 0; p < 180; ++p) {
                const double t = (static_cast<double>(h) + 0.5) / 90;
                const core::Vector3f f = brdf(t * t * pi / 2, (static_cast<double>(d) + 0.5) * pi / 180,
                                              (static_cast<double>(p) + 0.5) * pi / 180);
                const std::size_t index = p + d * 360 / 2 + h * (360 / 2) * 90;
                const std::array<double, 3> stored{static_cast<double>(f.x()) * 1500.0,
                                                   static_cast<double>(f.y()) * 1500.0 / 1.15,
                                                   static_cast<double>(f.z()) * 1500.0 / 1.66};
                for (std::size_t channel = 0; channel < 3; ++channel)
                    std::memcpy(bytes.data() + sizeof(kDimensions) + (index + channel * kEntries) * sizeof(double),
                                &stored[channel], sizeof(double));
            }
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// White GGX of width `alpha` without Fresnel, from its textbook formula in double, in those coordinates.
inline core::Vector3f ggxInHalfDiff(double alpha, double thetaH, double thetaD, double phiD) {
    // wi in the frame of h, turned into the frame of the surface (phi_h = 0).
    const double dx = std::sin(thetaD) * std::cos(phiD);
    const double dz = std::cos(thetaD);
    const double iz = dz * std::cos(thetaH) - dx * std::sin(thetaH);
    const double oz = dz * std::cos(thetaH) + dx * std::sin(thetaH);
    if (iz <= 0 || oz <= 0) return {0, 0, 0};
    const double c2 = std::cos(thetaH) * std::cos(thetaH);
    const double t = c2 * (alpha * alpha - 1) + 1;
    const double d = alpha * alpha / (std::numbers::pi * t * t);
    const auto g1 = [alpha](double c) { return 2 / (1 + std::sqrt(1 + alpha * alpha * (1 - c * c) / (c * c))); };
    const double f = d * g1(iz) * g1(oz) / (4 * iz * oz);
    return core::Vector3f::Constant(static_cast<float>(f));
}

}  // namespace test
