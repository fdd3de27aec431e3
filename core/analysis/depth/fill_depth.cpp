// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/fill_depth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/depth/membrane.h"
#include "core/analysis/depth/plane_fit.h"
#include "core/base/label_table.h"
#include "core/base/parallel.h"
#include "core/base/pixel.h"

namespace core::analysis {
namespace {

/// Samples of a window on each side of its centre.
constexpr int kWindowSamples = 10;
/// Fewest known samples that a plane is fitted to.
constexpr std::size_t kMinWindowSamples = 4;
/// Steepest slope of a filled surface: tangent of 75 degrees.
constexpr double kMaxFilledSlope = 3.7;
/// Rounds of smoothing at each distance of the pairs.
constexpr int kSmoothingRounds = 3;
/// Margin of gaps of a sensor [depth samples].
constexpr int kGapMargin = 8;
/// The picture's longer side over the reach of planes into gaps of a sensor.
constexpr int kFillReachParts = 30;

/// Distance [px] of every gap pixel from the known pixels of its segment, along the segment; 0 beyond the reach and
/// outside the gaps.
Image<std::uint16_t> distanceIntoGaps(const LabelImage& labels, const DepthGaps& gaps,
                                      const Image<std::uint8_t>& known) {
    Image<std::uint16_t> distance(labels.width(), labels.height(), 0);
    std::vector<Pixel> ring, next;
    const auto reachFrom = [&](int x, int y, std::uint16_t d) {
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const int u = x + i;
                const int v = y + j;
                if (!labels.contains(u, v) || labels(u, v) != labels(x, y) || gaps.isGap(u, v) == 0 ||
                    distance(u, v) != 0)
                    continue;
                distance(u, v) = d;
                next.push_back({u, v});
            }
    };
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (known(x, y) != 0) reachFrom(x, y, 1);
    for (int d = 2; d <= gaps.reach && !next.empty(); ++d) {
        ring.swap(next);
        next.clear();
        for (const auto& [x, y] : ring) reachFrom(x, y, static_cast<std::uint16_t>(d));
    }
    return distance;
}

/// Known pixels of the centre's segment on a grid over a disk, with coordinates in units of its radius [px].
void sampleWindow(const ImageF& depth, const LabelImage& labels, const Image<std::uint8_t>& known, Pixel center,
                  int radius, std::vector<PlaneSample>& samples) {
    const int stride = (radius + kWindowSamples - 1) / kWindowSamples;
    samples.clear();
    for (int j = -kWindowSamples; j <= kWindowSamples; ++j)
        for (int i = -kWindowSamples; i <= kWindowSamples; ++i) {
            const int u = center.x + i * stride;
            const int v = center.y + j * stride;
            const int squared = (i * i + j * j) * stride * stride;
            if (squared > radius * radius || !labels.contains(u, v) || labels(u, v) != labels(center.x, center.y) ||
                known(u, v) == 0)
                continue;
            const double r = radius;
            samples.push_back({i * stride / r, j * stride / r, 1.0 / static_cast<double>(depth(u, v)),
                               std::exp(-2.0 * squared / (r * r))});
        }
}

/// Median of the means of pairs of opposite filled pixels at a distance, in inverse depth, 0 without any pair: one
/// of the pairs may cross a ragged pixel.
float medianOfPairs(const ImageF& depth, const LabelImage& labels, const Image<std::uint16_t>& filled, Pixel center,
                    int distance) {
    constexpr std::array<Pixel, 4> kDirections{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
    const auto inverse = [&](int u, int v) {
        return labels.contains(u, v) && labels(u, v) == labels(center.x, center.y) && filled(u, v) != 0
                   ? 1 / depth(u, v)
                   : 0.0f;
    };
    std::array<float, kDirections.size()> means{};  // in increasing order
    std::size_t count = 0;
    for (const Pixel& d : kDirections) {
        const float a = inverse(center.x + distance * d.x, center.y + distance * d.y);
        const float b = inverse(center.x - distance * d.x, center.y - distance * d.y);
        if (a <= 0 || b <= 0) continue;
        const float mean = 0.5f * (a + b);
        std::size_t at = count++;
        for (; at > 0 && means[at - 1] > mean; --at) means[at] = means[at - 1];
        means[at] = mean;
    }
    if (count == 0) return 0;
    return 0.5f * (means[(count - 1) / 2] + means[count / 2]);
}

/// Evens out what differs between the planes of neighbouring filled pixels. Draws each towards the means of pairs of
/// opposite ones, distant pairs first: planes stay planes, and ragged pixels along the gap have no influence.
void smoothFilled(ImageF& depth, const LabelImage& labels, const Image<std::uint16_t>& filled, int margin,
                  const Progress& progress) {
    constexpr float kStep = 0.8f;
    for (int distance = std::max(1, margin / 2); distance >= 1; distance /= 2) {
        for (int round = 0; round < kSmoothingRounds; ++round) {
            const ImageF before = depth;
            parallelFor(progress, depth.height(), [&](int y) {
                for (int x = 0; x < depth.width(); ++x) {
                    if (filled(x, y) == 0) continue;
                    const float middle = medianOfPairs(before, labels, filled, {x, y}, distance);
                    if (middle <= 0) continue;
                    const float own = 1 / before(x, y);
                    depth(x, y) = 1 / (own + kStep * (middle - own));
                }
            });
        }
    }
}

/// One segment's known and missing pixels.
struct SegmentGaps {
    PixelBox box;
    double sum = 0;  ///< of the known inverse depths [1/m]
    std::size_t known = 0, missing = 0;
};

}  // namespace

void fillWithPlanes(ImageF& depth, const LabelImage& labels, const Camera& camera, DepthGaps& gaps,
                    const Progress& progress) {
    const ImageF measured = depth;
    Image<std::uint8_t> known(depth.width(), depth.height(), 0);
    for (std::size_t i = 0; i < depth.size(); ++i)
        known[i] = labels[i] != 0 && depth[i] > 0 && gaps.isGap[i] == 0 ? 1 : 0;
    Image<std::uint16_t> distance = distanceIntoGaps(labels, gaps, known);
    parallelFor(progress, depth.height(), [&](int y) {
        std::vector<PlaneSample> samples;
        for (int x = 0; x < depth.width(); ++x) {
            if (distance(x, y) == 0) continue;
            const int radius = gaps.margin + 2 * distance(x, y);
            sampleWindow(measured, labels, known, {x, y}, radius, samples);
            if (samples.size() < kMinWindowSamples) {
                distance(x, y) = 0;
                continue;
            }
            const double maxSlope = kMaxFilledSlope * 2 * radius / static_cast<double>(camera.fx + camera.fy);
            const RobustPlane plane = fitRobustPlane(samples, {.maxSlope = maxSlope});
            depth(x, y) = static_cast<float>(1 / std::max(plane.at(0, 0), 0.2 * plane.mean));
            gaps.isGap(x, y) = 0;
        }
    });
    smoothFilled(depth, labels, distance, gaps.margin, progress);
}

void fillSmallHoles(ImageF& depth, const LabelImage& labels, int radius) {
    if (radius <= 0) return;
    radius = std::min(radius, 64);
    const ImageF original = depth;
    Image<std::uint8_t> visited(depth.width(), depth.height(), 0);
    // A hole of which every pixel is within `radius` of valid depth cannot be longer than its outline allows, so the
    // flood stops early only in area: a thin scratch across the segment is a small hole too.
    const auto nearValid = [&](int x, int y) {
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (dx * dx + dy * dy <= radius * radius && depth.contains(x + dx, y + dy) &&
                    labels(x + dx, y + dy) == labels(x, y) && original(x + dx, y + dy) > 0)
                    return true;
        return false;
    };
    const auto fill = [&](int x, int y) {
        // Plane in inverse depth: weighted least squares about the hole pixel, nearest neighbours first.
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
        double low = 1e30;
        double high = 0;
        const int reach = radius + 2;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                if (!depth.contains(x + dx, y + dy) || labels(x + dx, y + dy) != labels(x, y)) continue;
                const double z = original(x + dx, y + dy);
                if (z <= 0) continue;
                const double squared = dx * dx + dy * dy;
                const Eigen::Vector3d row(1, dx, dy);
                const double weight = 1 / (squared * squared);
                normal += weight * row * row.transpose();
                rhs += weight / z * row;
                low = std::min(low, 1 / z);
                high = std::max(high, 1 / z);
            }
        }
        normal.diagonal() += Eigen::Vector3d(0, 1e-9, 1e-9) * normal(0, 0);
        const double w = normal.ldlt().solve(rhs)[0];
        return static_cast<float>(1 / std::clamp(w, low, high));
    };

    std::vector<std::array<int, 2>> hole;
    for (int startY = 0; startY < depth.height(); ++startY) {
        for (int startX = 0; startX < depth.width(); ++startX) {
            if (visited(startX, startY) != 0 || original(startX, startY) > 0 || labels(startX, startY) == 0) continue;
            const std::uint16_t label = labels(startX, startY);
            hole.assign(1, {startX, startY});
            visited(startX, startY) = 1;
            bool small = true;
            for (std::size_t next = 0; next < hole.size(); ++next) {
                const auto [x, y] = hole[next];
                small = small && nearValid(x, y);
                for (const auto& [dx, dy] : kNeighbors) {
                    const int nx = x + dx;
                    const int ny = y + dy;
                    if (!depth.contains(nx, ny) || visited(nx, ny) != 0 || labels(nx, ny) != label ||
                        original(nx, ny) > 0)
                        continue;
                    visited(nx, ny) = 1;
                    hole.push_back({nx, ny});
                }
            }
            if (!small) continue;
            for (const auto& [x, y] : hole) depth(x, y) = fill(x, y);
        }
    }
}

void fillWithMembrane(ImageF& depth, const LabelImage& labels, const Progress& progress) {
    LabelTable<SegmentGaps> segments;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            SegmentGaps& segment = segments[labels(x, y)];
            segment.box.add({x, y});
            if (depth(x, y) > 0)
                segment.sum += 1.0 / static_cast<double>(depth(x, y)), ++segment.known;
            else
                ++segment.missing;
        }
    }
    for (std::size_t label = 1; label < segments.size(); ++label) {
        const auto& [box, sum, known, missing] = segments[label];
        if (known == 0 || missing == 0) continue;
        const auto mean = static_cast<float>(sum / static_cast<double>(known));
        Image<MembraneCell> cells(box.width(), box.height());
        const auto depthAt = [&](int x, int y) -> float& { return depth(box.x0 + x, box.y0 + y); };
        for (int y = 0; y < cells.height(); ++y) {
            for (int x = 0; x < cells.width(); ++x) {
                if (labels(box.x0 + x, box.y0 + y) != label) continue;
                const float z = depthAt(x, y);
                cells(x, y) = z > 0 ? MembraneCell{1 / z, MembraneCell::Kind::Fixed}
                                    : MembraneCell{mean, MembraneCell::Kind::Free};
            }
        }
        solveMembrane(cells, progress);
        for (int y = 0; y < cells.height(); ++y)
            for (int x = 0; x < cells.width(); ++x)
                if (cells(x, y).kind == MembraneCell::Kind::Free) depthAt(x, y) = 1 / cells(x, y).value;
    }
}

void fillDepth(ImageF& depth, const Photo& photo, int holeRadius, const Progress& progress) {
    fillSmallHoles(depth, photo.labels, holeRadius);
    DepthGaps gaps{Image<std::uint8_t>(depth.width(), depth.height(), 0),
                   kGapMargin * std::max(1, static_cast<int>(std::lround(photo.depthSampleSpacing))),
                   std::max(depth.width(), depth.height()) / kFillReachParts};
    for (std::size_t i = 0; i < depth.size(); ++i) gaps.isGap[i] = photo.labels[i] != 0 && depth[i] <= 0 ? 1 : 0;
    fillWithPlanes(depth, photo.labels, photo.camera, gaps, progress);
    fillWithMembrane(depth, photo.labels, progress);
}

}  // namespace core::analysis
