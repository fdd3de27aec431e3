// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/continue_depth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/analysis/segment/segment_pixels.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

constexpr int kSamples = 10;         ///< of a window on each side of its centre
constexpr int kRounds = 7;           ///< of reweighting
constexpr double kStiffness = 1e-4;  ///< against slopes that nothing tells
constexpr double kSteepest = 3.7;    ///< tangent of 75 degrees
constexpr std::size_t kLeastSamples = 4;
constexpr int kSmoothings = 3;  ///< at each distance of the pairs

/// One known pixel in a window, relative to its centre.
struct WindowSample {
    double u, v;  ///< [window radii]
    double w;     ///< inverse depth
    double weight;
};

/// Inverse depth at the centre of the plane through the samples; `steepest` bounds its slope over its mean.
double planeAtCenter(const std::vector<WindowSample>& samples, double steepest) {
    Eigen::Vector2d slope = Eigen::Vector2d::Zero(), center = Eigen::Vector2d::Zero();
    double mean = 0, scale = 0;
    for (int round = 0; round < kRounds; ++round) {
        const auto weightOf = [&](const WindowSample& s) {
            if (round == 0) return s.weight;
            const double off = (s.w - mean - slope.dot(Eigen::Vector2d(s.u, s.v) - center)) / scale;
            // Least absolute offsets first: a start that outliers cannot draw away.
            return round < kRounds / 2 ? s.weight / (0.1 + std::abs(off))
                                       : s.weight / ((1 + off * off) * (1 + off * off));
        };
        double total = 0, sum = 0;
        Eigen::Vector2d moment = Eigen::Vector2d::Zero();
        std::vector<double> weights;
        weights.reserve(samples.size());
        for (const WindowSample& s : samples) {
            const double k = weights.emplace_back(weightOf(s));
            total += k;
            sum += k * s.w;
            moment += k * Eigen::Vector2d(s.u, s.v);
        }
        mean = sum / total;
        center = moment / total;
        Eigen::Matrix2d normal = kStiffness * total * Eigen::Matrix2d::Identity();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Eigen::Vector2d d = Eigen::Vector2d(samples[i].u, samples[i].v) - center;
            normal += weights[i] * d * d.transpose();
            right += weights[i] * (samples[i].w - mean) * d;
        }
        slope = normal.inverse() * right;
        if (slope.norm() > steepest * mean) slope *= steepest * mean / slope.norm();
        std::vector<double> offsets;
        offsets.reserve(samples.size());
        for (const WindowSample& s : samples)
            offsets.push_back(std::abs(s.w - mean - slope.dot(Eigen::Vector2d(s.u, s.v) - center)));
        const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
        std::nth_element(offsets.begin(), middle, offsets.end());
        scale = std::max(3 * *middle, 1e-6 * mean);
    }
    return std::max(mean - slope.dot(center), 0.2 * mean);
}

/// Draws each filled pixel towards the means of pairs of opposite filled ones of its segment, far ones first: what
/// differs between the planes of neighbours goes, planes stay planes, jagged pixels beside the gap stay out.
void smoothFilled(ImageF& depth, const LabelImage& labels, const Image<std::uint16_t>& filled, int margin,
                  const Progress& progress) {
    constexpr std::array<Pixel, 4> kDirections{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
    for (int stride = std::max(1, margin / 2); stride >= 1; stride /= 2) {
        for (int round = 0; round < kSmoothings; ++round) {
            const ImageF before = depth;
            parallelFor(progress, depth.height(), [&](int y) {
                for (int x = 0; x < depth.width(); ++x) {
                    if (filled(x, y) == 0) continue;
                    const auto inverse = [&](int u, int v) {
                        return labels.contains(u, v) && labels(u, v) == labels(x, y) && filled(u, v) != 0
                                   ? 1 / before(u, v)
                                   : 0.0f;
                    };
                    std::array<float, kDirections.size()> means{};
                    std::size_t count = 0;
                    for (const Pixel& d : kDirections) {
                        const float a = inverse(x + stride * d.x, y + stride * d.y);
                        const float b = inverse(x - stride * d.x, y - stride * d.y);
                        if (a <= 0 || b <= 0) continue;
                        const float mean = 0.5f * (a + b);
                        std::size_t at = count++;
                        for (; at > 0 && means[at - 1] > mean; --at) means[at] = means[at - 1];
                        means[at] = mean;
                    }
                    if (count == 0) continue;
                    // Their median: one of them may end at a jagged pixel.
                    const float middle = 0.5f * (means[(count - 1) / 2] + means[count / 2]);
                    const float own = 1 / before(x, y);
                    depth(x, y) = 1 / (own + 0.8f * (middle - own));
                }
            });
        }
    }
}

}  // namespace

void continueDepth(ImageF& depth, const LabelImage& labels, const Camera& camera, DepthGaps& gaps,
                   const Progress& progress) {
    Image<std::uint8_t>& isGap = gaps.isGap;
    const ImageF known = depth;
    const Image<std::uint8_t> wasGap = isGap;
    const auto isKnown = [&](int x, int y) { return labels(x, y) != 0 && known(x, y) > 0 && wasGap(x, y) == 0; };
    // Distance to the nearest known pixel along the segment, ring by ring.
    Image<std::uint16_t> distance(depth.width(), depth.height(), 0);
    std::vector<Pixel> ring, next;
    const auto reachFrom = [&](int x, int y, std::uint16_t d) {
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const int u = x + i;
                const int v = y + j;
                if (!labels.contains(u, v) || labels(u, v) != labels(x, y) || isGap(u, v) == 0 || distance(u, v) != 0)
                    continue;
                distance(u, v) = d;
                next.push_back({u, v});
            }
    };
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            if (isKnown(x, y)) reachFrom(x, y, 1);
    for (int d = 2; d <= gaps.reach && !next.empty(); ++d) {
        ring.swap(next);
        next.clear();
        for (const auto& [x, y] : ring) reachFrom(x, y, static_cast<std::uint16_t>(d));
    }

    parallelFor(progress, depth.height(), [&](int y) {
        std::vector<WindowSample> samples;
        for (int x = 0; x < depth.width(); ++x) {
            if (distance(x, y) == 0) continue;
            const int radius = gaps.margin + 2 * distance(x, y);
            const int stride = (radius + kSamples - 1) / kSamples;
            samples.clear();
            for (int j = -kSamples; j <= kSamples; ++j)
                for (int i = -kSamples; i <= kSamples; ++i) {
                    const int u = x + i * stride;
                    const int v = y + j * stride;
                    const int squared = (i * i + j * j) * stride * stride;
                    if (squared > radius * radius || !labels.contains(u, v) || labels(u, v) != labels(x, y) ||
                        !isKnown(u, v))
                        continue;
                    const double r = radius;
                    samples.push_back({i * stride / r, j * stride / r, 1.0 / static_cast<double>(known(u, v)),
                                       std::exp(-2.0 * squared / (r * r))});
                }
            if (samples.size() < kLeastSamples) {
                distance(x, y) = 0;
                continue;
            }
            const double steepest = kSteepest * 2 * radius / static_cast<double>(camera.fx + camera.fy);
            depth(x, y) = static_cast<float>(1 / planeAtCenter(samples, steepest));
            isGap(x, y) = 0;
        }
    });
    smoothFilled(depth, labels, distance, gaps.margin, progress.part(1, 1));
}

}  // namespace core::analysis
