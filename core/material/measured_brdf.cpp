// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/measured_brdf.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "core/base/error.h"
#include "core/base/files.h"
#include "shaders/brdf/measured.h"

namespace core {

namespace {

static_assert(std::endian::native == std::endian::little, "MERL's files are little-endian");

using kernel::kMeasuredPhiD;
using kernel::kMeasuredRows;
using kernel::kMeasuredRowSize;
using kernel::kMeasuredThetaD;
using kernel::kMeasuredThetaH;
using kernel::kMeasuredValues;

constexpr std::array<std::int32_t, 3> kDimensions{90, 90, 180};
constexpr std::array<const char*, 3> kPlanes{MESSAGE_TEXT("messages", "red"), MESSAGE_TEXT("messages", "green"),
                                             MESSAGE_TEXT("messages", "blue")};
constexpr std::array<double, 3> kScale{1 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
constexpr std::size_t kEntries = std::size_t{kMeasuredThetaH} * kMeasuredThetaD * kMeasuredPhiD;
constexpr std::size_t kFileBytes = sizeof(kDimensions) + 3 * kEntries * sizeof(double);

/// Minimum probability of the cosine lobe: bounds the weight of samples that the half-angle tables miss.
constexpr float kMinCosineChance = 0.1f;

kernel::vec3 direction(double theta, double phi) {
    return {static_cast<float>(std::sin(theta) * std::cos(phi)), static_cast<float>(std::sin(theta) * std::sin(phi)),
            static_cast<float>(std::cos(theta))};
}

/// Fills one row of the sampling tables. The reflected light is split into a constant BRDF, sampled by the cosine, and
/// the excess over it, whose distribution over the half angle is tabulated.
void tabulateSampling(std::vector<float>& table, std::uint32_t row) {
    using std::numbers::pi;
    kernel::BrdfParams b{};
    b.measured = table.data();
    const kernel::vec3 wo = direction((row + 0.5) * (pi / 2) / kMeasuredRows, 0);
    const auto level = [&](const kernel::vec3& wi) {
        const kernel::vec3 f = kernel::measured_eval(b, wo, wi);
        return static_cast<double>(f.x + f.y + f.z) / 3;
    };

    constexpr int kSide = 24;
    std::vector<double> levels;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j)
            levels.push_back(level(kernel::sample_cosine_hemisphere(
                {(static_cast<float>(i) + 0.5f) / kSide, (static_cast<float>(j) + 0.5f) / kSide})));
    const auto quartile = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 4);
    std::nth_element(levels.begin(), quartile, levels.end());
    const double base = *quartile;

    constexpr int kPhi = 64;
    std::array<double, kMeasuredThetaH> lobe{};
    double sum = 0;
    for (std::uint32_t bin = 0; bin < kMeasuredThetaH; ++bin) {
        const double t = (bin + 0.5) / kMeasuredThetaH;
        const double solidAngle =
            4 * pi * static_cast<double>(kernel::measured_edge(bin + 1) - kernel::measured_edge(bin));
        for (int j = 0; j < kPhi; ++j) {
            const kernel::vec3 h = direction(t * t * pi / 2, (j + 0.5) * 2 * pi / kPhi);
            const float c = kernel::dot(wo, h);
            const kernel::vec3 wi = h * (2 * c) - wo;
            if (c <= 0 || wi.z <= 0) continue;
            lobe[bin] += std::max(level(wi) - base, 0.0) * static_cast<double>(4 * c * wi.z) * solidAngle / kPhi;
        }
        sum += lobe[bin];
    }
    const double total = base * pi + sum;
    float* out = table.data() + std::size_t{row} * kMeasuredRowSize;
    out[0] = sum > 1e-4 * total ? std::max(static_cast<float>(base * pi / total), kMinCosineChance) : 1.0f;
    double cumulative = 0;
    for (std::uint32_t bin = 0; bin < kMeasuredThetaH; ++bin) {
        out[1 + bin] = sum > 0 ? static_cast<float>(cumulative / sum) : 0.0f;
        cumulative += lobe[bin];
    }
    out[1 + kMeasuredThetaH] = 1;
}

}  // namespace

std::shared_ptr<const MeasuredBrdf> loadMeasuredBrdf(const std::string& path) {
    const std::size_t size = checkedFileSize(path);
    const Message expected =
        Message("messages",
                "expected a measured BRDF in MERL's binary format: dimensions 90, 90, 180, then %1 bytes of values")
            .with(kFileBytes - sizeof(kDimensions));
    if (size != kFileBytes)
        throw Error(
            ErrorKind::Input,
            Message("messages", "\"%1\" has %2 bytes, %3, %4 bytes in all.").with(path, size, expected, kFileBytes));
    const std::string bytes = readFile(path, kFileBytes);
    std::array<std::int32_t, 3> dimensions{};
    std::memcpy(dimensions.data(), bytes.data(), sizeof(dimensions));
    if (dimensions != kDimensions)
        throw Error(ErrorKind::Input, Message("messages", "\"%1\" has the dimensions %2, %3, %4, %5.")
                                          .with(path, dimensions[0], dimensions[1], dimensions[2], expected));
    std::vector<float> table(kernel::kMeasuredSize);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const char* plane = bytes.data() + sizeof(dimensions) + channel * kEntries * sizeof(double);
        for (std::size_t i = 0; i < kEntries; ++i) {
            double value = 0;
            std::memcpy(&value, plane + i * sizeof(double), sizeof(double));
            const auto f = static_cast<float>(value * kScale[channel]);
            if (!std::isfinite(f))
                throw Error(ErrorKind::Input,
                            Message("messages", "\"%1\": value %2 of the %3 plane is not a finite number; %4.")
                                .with(path, i, Message("messages", kPlanes.at(channel)), expected));
            table[kMeasuredValues + 3 * i + channel] = std::max(f, 0.0f);
        }
    }
    for (std::uint32_t row = 0; row < kMeasuredRows; ++row) tabulateSampling(table, row);
    return std::make_shared<const MeasuredBrdf>(MeasuredBrdf{std::move(table)});
}

}  // namespace core
