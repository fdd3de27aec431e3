// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/fill_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/depth/membrane.h"
#include "core/analysis/depth/plane_fit.h"
#include "core/base/label_table.h"
#include "core/base/parallel.h"
#include "core/base/pixel.h"
#include "core/base/staged_progress.h"

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
/// Margins around gaps of a sensor [depth samples] and around holes in exact depth [px]. The latter have no ragged
/// edge, and the nearest pixels follow a curved surface best.
constexpr int kGapMargin = 8;
constexpr int kExactGapMargin = 1;
/// Planes reach into gaps of a sensor by the longer side of the picture divided by this.
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

/// Median of the means of pairs of opposite filled pixels at a distance, in inverse depth; a median because one pair
/// may cross a ragged pixel. 0 if there is no pair.
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

/// Distance of the first pairs when filled pixels are smoothed; halved down to 1.
int firstDistance(int margin) { return std::max(1, margin / 2); }

int smoothingPasses(int margin) {
    int passes = 0;
    for (int distance = firstDistance(margin); distance >= 1; distance /= 2) passes += kSmoothingRounds;
    return passes;
}

/// Evens out what differs between the planes of neighbouring filled pixels. Draws each towards the means of pairs of
/// opposite ones, distant pairs first: planes stay planes, and ragged pixels along the gap have no influence.
void smoothFilled(ImageF& depth, const LabelImage& labels, const Image<std::uint16_t>& filled, int margin,
                  const Progress& progress) {
    constexpr float kStep = 0.8f;
    StagedProgress stages(progress, smoothingPasses(margin));
    for (int distance = firstDistance(margin); distance >= 1; distance /= 2) {
        for (int round = 0; round < kSmoothingRounds; ++round) {
            const ImageF before = depth;
            parallelFor(stages.next(1), depth.height(), [&](int y) {
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

// Expected times [ns on two cores].

double timeOfPlanes(std::size_t pixels, double gapPixels) {
    constexpr double kTimePerPixel = 60;
    constexpr double kTimePerPlane = 20000;
    return kTimePerPixel * static_cast<double>(pixels) + kTimePerPlane * gapPixels;
}

double timeOfSmoothing(std::size_t pixels, double gapPixels, int margin) {
    constexpr double kTimePerPixel = 1.5;
    constexpr double kTimePerGapPixel = 40;
    return smoothingPasses(margin) * (kTimePerPixel * static_cast<double>(pixels) + kTimePerGapPixel * gapPixels);
}

double timeOfMembrane(std::size_t pixels, double gapPixels) {
    constexpr double kTimePerPixel = 5;
    constexpr double kTimePerGapPixel = 300;
    return kTimePerPixel * static_cast<double>(pixels) + kTimePerGapPixel * gapPixels;
}

/// Gaps of a sensor: labelled pixels without depth.
DepthGaps sensorGaps(const ImageF& depth, const Photo& photo, bool exact) {
    const int spacing = wholeSpacing(photo.depthSampleSpacing);
    DepthGaps gaps{Image<std::uint8_t>(depth.width(), depth.height(), 0),
                   exact && spacing == 1 ? kExactGapMargin : kGapMargin * spacing,
                   std::max(depth.width(), depth.height()) / kFillReachParts};
    for (std::size_t i = 0; i < depth.size(); ++i) gaps.isGap[i] = photo.labels[i] != 0 && depth[i] <= 0 ? 1 : 0;
    return gaps;
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
    const ImageF input = depth;
    Image<std::uint8_t> known(depth.width(), depth.height(), 0);
    for (std::size_t i = 0; i < depth.size(); ++i)
        known[i] = labels[i] != 0 && depth[i] > 0 && gaps.isGap[i] == 0 ? 1 : 0;
    Image<std::uint16_t> distance = distanceIntoGaps(labels, gaps, known);
    const auto near = std::ranges::count_if(distance.pixels(), [](std::uint16_t d) { return d > 0; });
    if (near == 0) return;
    const double planesTime = timeOfPlanes(depth.size(), static_cast<double>(near));
    const double smoothingTime = timeOfSmoothing(depth.size(), static_cast<double>(near), gaps.margin);
    StagedProgress stages(progress, planesTime + smoothingTime);
    parallelFor(stages.next(planesTime), depth.height(), [&](int y) {
        std::vector<PlaneSample> samples;
        for (int x = 0; x < depth.width(); ++x) {
            if (distance(x, y) == 0) continue;
            const int radius = gaps.margin + 2 * distance(x, y);
            sampleWindow(input, labels, known, {x, y}, radius, samples);
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
    smoothFilled(depth, labels, distance, gaps.margin, stages.next(smoothingTime));
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

void fillDepth(ImageF& depth, const Photo& photo, bool exact, const Progress& progress) {
    DepthGaps gaps = sensorGaps(depth, photo, exact);
    const auto count = static_cast<double>(std::ranges::count(gaps.isGap.pixels(), 1));
    if (count == 0) return;
    const double planesTime = timeOfPlanes(depth.size(), count) + timeOfSmoothing(depth.size(), count, gaps.margin);
    const double membraneTime = timeOfMembrane(depth.size(), count);
    StagedProgress stages(progress, planesTime + membraneTime);
    fillWithPlanes(depth, photo.labels, photo.camera, gaps, stages.next(planesTime));
    fillWithMembrane(depth, photo.labels, stages.next(membraneTime));
}

double expectedFillTime(const ImageF& depth, const Photo& photo) {
    const DepthGaps gaps = sensorGaps(depth, photo, false);
    const auto count = static_cast<double>(std::ranges::count(gaps.isGap.pixels(), 1));
    if (count == 0) return 0;
    return timeOfPlanes(depth.size(), count) + timeOfSmoothing(depth.size(), count, gaps.margin) +
           timeOfMembrane(depth.size(), count);
}

}  // namespace core::analysis
