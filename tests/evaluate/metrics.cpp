// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/metrics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/color.h"

namespace evaluate {

namespace {

double ssimOverMask(const core::ImageRgb& a, const core::ImageRgb& b, const core::Image<std::uint8_t>& mask) {
    constexpr int kRadius = 5;
    constexpr double kSigma = 1.5;
    constexpr double kC1 = 0.01 * 0.01;
    constexpr double kC2 = 0.03 * 0.03;
    double sum = 0;
    std::size_t count = 0;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == 0) continue;
            double weight = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
            for (int dy = -kRadius; dy <= kRadius; ++dy) {
                for (int dx = -kRadius; dx <= kRadius; ++dx) {
                    // Only masked neighbours: pixels outside the edited segment do not count.
                    if (!mask.contains(x + dx, y + dy) || mask(x + dx, y + dy) == 0) continue;
                    const double w = std::exp(-(dx * dx + dy * dy) / (2 * kSigma * kSigma));
                    const double va = luminance(a(x + dx, y + dy));
                    const double vb = luminance(b(x + dx, y + dy));
                    weight += w;
                    ma += w * va;
                    mb += w * vb;
                    aa += w * va * va;
                    bb += w * vb * vb;
                    ab += w * va * vb;
                }
            }
            ma /= weight;
            mb /= weight;
            const double varA = aa / weight - ma * ma;
            const double varB = bb / weight - mb * mb;
            const double cov = ab / weight - ma * mb;
            sum += (2 * ma * mb + kC1) * (2 * cov + kC2) / ((ma * ma + mb * mb + kC1) * (varA + varB + kC2));
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

float luminance(const core::Vector3f& c) { return 0.2126f * c.x() + 0.7152f * c.y() + 0.0722f * c.z(); }

double quantile(std::vector<float> values, double q) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto rank = static_cast<std::ptrdiff_t>(std::lround(q * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

double angleDegrees(const core::Vector3f& a, const core::Vector3f& b) {
    const Eigen::Vector3d u = a.cast<double>();
    const Eigen::Vector3d v = b.cast<double>();
    return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

core::Image<std::uint8_t> erodedMask(const core::LabelImage& labels, std::uint16_t label, int erosion) {
    core::Image<std::uint8_t> mask(labels.width(), labels.height());
    for (std::size_t i = 0; i < labels.size(); ++i) mask[i] = labels[i] == label ? 1 : 0;
    for (int round = 0; round < erosion; ++round) {
        const auto before = mask;
        for (int y = 0; y < mask.height(); ++y) {
            for (int x = 0; x < mask.width(); ++x) {
                for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    if (!mask.contains(x + dx, y + dy) || before(x + dx, y + dy) == 0) mask(x, y) = 0;
                }
            }
        }
    }
    return mask;
}

float displayExposure(const core::ImageRgb& picture) {
    std::vector<float> values;
    values.reserve(picture.size());
    for (const auto& pixel : picture.pixels()) values.push_back(luminance(pixel));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return 1.0f / std::max(*at, 1e-6f);
}

core::ImageRgb displayEncoded(const core::ImageRgb& linear, float exposure) {
    core::ImageRgb encoded(linear.width(), linear.height());
    for (std::size_t i = 0; i < linear.size(); ++i)
        for (int c = 0; c < 3; ++c) encoded[i][c] = core::srgbEncode(std::clamp(exposure * linear[i][c], 0.0f, 1.0f));
    return encoded;
}

Metrics compare(const core::ImageRgb& picture, const core::ImageRgb& truth, const core::Image<std::uint8_t>& mask,
                float exposure) {
    const core::ImageRgb a = displayEncoded(picture, exposure);
    const core::ImageRgb b = displayEncoded(truth, exposure);
    double squared = 0, sumPicture = 0, sumTruth = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        squared += (a[i] - b[i]).cast<double>().squaredNorm() / 3;
        sumPicture += picture[i].cast<double>().sum() / 3;
        sumTruth += truth[i].cast<double>().sum() / 3;
        ++count;
    }
    Metrics metrics;
    if (count == 0) return metrics;
    const auto n = static_cast<double>(count);
    metrics.psnr = squared > 0 ? -10 * std::log10(squared / n) : std::numeric_limits<double>::infinity();
    metrics.meanRatio = sumPicture / std::max(sumTruth, 1e-12);

    const double floor = 0.01 * (sumTruth / n) * (sumTruth / n);
    std::vector<double> errors;
    errors.reserve(count);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        double error = 0;
        for (int c = 0; c < 3; ++c) {
            const double t = truth[i][c];
            const double d = picture[i][c] - t;
            error += d * d / (t * t + floor) / 3;
        }
        errors.push_back(error);
    }
    const auto kept = static_cast<std::ptrdiff_t>(0.999 * n);
    std::nth_element(errors.begin(), errors.begin() + kept, errors.end());
    double sum = 0;
    for (auto it = errors.begin(); it != errors.begin() + kept; ++it) sum += *it;
    metrics.relMse = sum / static_cast<double>(std::max<std::ptrdiff_t>(kept, 1));
    metrics.ssim = ssimOverMask(a, b, mask);
    return metrics;
}

}  // namespace evaluate
