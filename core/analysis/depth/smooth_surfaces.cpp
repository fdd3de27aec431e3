// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/smooth_surfaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/analysis/depth/weak_plate.h"
#include "core/base/label_table.h"
#include "core/base/pixel.h"
#include "core/base/robust.h"
#include "core/base/staged_progress.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Turn [rad] within the smoothing length at which a plate begins to fold, unless kMedianFolds times the median turn is
/// more: a small ball turns fast everywhere and has no fold.
constexpr double kMinFold = 0.35;
constexpr double kMedianFolds = 3;
/// Second difference at which depth begins to count as broken [σ of the noise].
constexpr double kDataJump = 3;
/// Residual at which the weight of a measurement is a quarter [standard deviations].
constexpr double kDataOutlier = 2.5;
/// Upper bound of the smoothing length in cells of the level where weights are found.
constexpr double kMaxWeightedRatio = 12;
/// Smoothing length in cells of the coarsest level, about.
constexpr double kCoarsestRatio = 3;
/// Smoothing lengths [px] up to this one change nothing.
constexpr double kMinLength = 1;
/// Rounds of finding weights.
constexpr int kWeightRounds = 6;
/// Iterations of conjugate gradients on the level of the weights and coarser ones, and on finer ones.
constexpr int kIterations = 30;
constexpr int kFineIterations = 12;
/// Time to find the weights of a level, in iterations on it.
constexpr double kWeightCost = 6;

/// Weight of a residual in units of its scale.
double weightOf(double residual) { return gemanMcClure(residual * residual); }

double fourthPower(double x) { return x * x * x * x; }

/// Noise in cells of one level.
struct CellNoise {
    double sigma = 0;        ///< [1/m] of inverse depth, 0 = unknown
    double correlation = 1;  ///< [cells]
    double left = 1;         ///< fraction of it that the depth filter leaves
    bool rounded = false;

    /// Half the width [cells] of the largest structure that noise can produce: nothing narrower is a fold or a jump.
    [[nodiscard]] double shortest() const {
        if (sigma <= 0) return 0;
        return 0.5 * (rounded ? correlation : std::max(correlation - 1, 0.0));
    }
    /// Error [1/m] that noise can leave in the mean over a square of `count` cells.
    [[nodiscard]] double tolerance(double count) const {
        return rounded ? sigma : 2 * left * sigma * std::min(1.0, 2 * correlation / std::sqrt(count));
    }
};

/// Stiffness and trust of a plate, updated round by round.
class PlateWeights {
  public:
    /// `focalLength` [cells] of the plate's level.
    PlateWeights(WeakPlate& plate, double focalLength, const CellNoise& noise)
        : plate_(plate),
          focalLength_(focalLength),
          noise_(noise),
          measured_(plate.trust()),
          unbroken_(plate.cellCount(), 1),
          local_(plate.cellCount(), 1) {
        if (noise_.sigma <= 0) return;
        const std::size_t row = plate_.stride();
        forCells([&](std::size_t i) {
            for (const std::size_t cell : {i, i - 1, i + 1, i - row, i + row, i + row + 1})
                if (plate_.inside(cell) && !(measured_[cell] > 0)) return;
            unbroken_[i] = weightOf(plate_.bendOfData(i) / (kDataJump * noise_.sigma));
            plate_.setStiffness(i, unbroken_[i]);
        });
    }

    /// Shortens the smoothing length where the plate misses relief.
    void shorten() {
        if (noise_.sigma <= 0) return;
        constexpr double kShorter = 0.4;
        constexpr double kSlopeWindow = 0.25;  // of the smoothing length to each side
        const std::size_t row = plate_.stride();
        std::vector<double> sums(plate_.cellCount(), 0), counts(plate_.cellCount(), 0);
        for (int y = 0; y < plate_.height(); ++y) {
            for (int x = 0; x < plate_.width(); ++x) {
                const std::size_t i = plate_.at(x, y);
                const double count = plate_.inside(i) ? measured_[i] : 0;
                // Bounded, so that a narrow groove does not dominate its surroundings.
                const double off = std::clamp(plate_.data(i) - plate_.value(i), -2 * noise_.sigma, 2 * noise_.sigma);
                sums[i] = count * off + sums[i - 1] + sums[i - row] - sums[i - row - 1];
                counts[i] = count + counts[i - 1] + counts[i - row] - counts[i - row - 1];
            }
        }
        const double least = std::min(1.0, std::max(noise_.correlation, 1.0) / plate_.length());
        tbb::parallel_for(0, plate_.height(), [&](int y) {
            for (int x = 0; x < plate_.width(); ++x) {
                const std::size_t i = plate_.at(x, y);
                if (!plate_.inside(i)) continue;
                const int half = std::max(1, static_cast<int>(std::lround(kSlopeWindow * plate_.length() * local_[i])));
                const int x0 = std::max(x - half, 0) - 1;
                const int y0 = std::max(y - half, 0) - 1;
                const int x1 = std::min(x + half, plate_.width() - 1);
                const int y1 = std::min(y + half, plate_.height() - 1);
                const auto over = [&](const std::vector<double>& v) {
                    return v[plate_.at(x1, y1)] - v[plate_.at(x0, y1)] - v[plate_.at(x1, y0)] + v[plate_.at(x0, y0)];
                };
                const double count = over(counts);
                if (count >= 1 && std::abs(over(sums)) > count * noise_.tolerance(count))
                    local_[i] = std::max(local_[i] * kShorter, least);
            }
        });
    }

    /// Sets stiffness from how much the plate turns, trust from residuals. Rounded maps come from cameras that match
    /// pictures, which turn lines painted on a surface into grooves. In other maps everything is trusted, because an
    /// apparent outlier may be the surface turning away at its outline.
    void update() {
        const std::size_t stride = plate_.cellCount() / 100000 + 1;
        std::vector<double> turns(plate_.cellCount(), 0), off, all;
        forCells([&](std::size_t i) {
            turns[i] = plate_.bendOfValues(i) * local_[i] * plate_.length() * focalLength_ / std::abs(plate_.value(i));
        });
        for (std::size_t i = 0; i < plate_.cellCount(); i += stride) {
            if (!plate_.inside(i)) continue;
            all.push_back(turns[i]);
            if (noise_.rounded && measured_[i] > 0) off.push_back(std::abs(plate_.data(i) - plate_.value(i)));
        }
        if (all.empty()) return;
        const double spread = std::max(off.empty() ? 0.0 : 1.4826 * median(off), noise_.sigma);
        const double fold = std::max(kMinFold, kMedianFolds * median(all));
        const double least = fourthPower(std::min(1.0, noise_.shortest() / plate_.length()));
        forCells([&](std::size_t i) {
            if (noise_.rounded) {
                const double limit = kDataOutlier * std::max(spread, 1e-7 * std::abs(plate_.value(i)));
                plate_.setTrust(i, measured_[i] * weightOf((plate_.data(i) - plate_.value(i)) / limit));
            }
            plate_.setStiffness(
                i, least + (1 - least) * weightOf(turns[i] / fold) * fourthPower(local_[i]) * unbroken_[i]);
        });
    }

    /// Takes over the lengths found on the coarser level.
    void takeLengths(const PlateWeights& coarse) {
        for (int y = 0; y < plate_.height(); ++y)
            for (int x = 0; x < plate_.width(); ++x)
                local_[plate_.at(x, y)] = coarse.local_[coarse.plate_.at(x / 2, y / 2)];
    }

  private:
    template <class Body>
    void forCells(const Body& body) const {
        tbb::parallel_for(0, plate_.height(), [&](int y) {
            for (std::size_t i = plate_.at(0, y); i < plate_.at(plate_.width(), y); ++i)
                if (plate_.inside(i)) body(i);
        });
    }

    WeakPlate& plate_;
    double focalLength_;
    CellNoise noise_;
    std::vector<double> measured_;  ///< initial trust
    std::vector<double> unbroken_;  ///< stiffness factor, low at jumps of the data
    std::vector<double> local_;     ///< local smoothing length over the plate's
};

/// Sizes of a plate's levels, which of them does what, and how long that takes.
class PlateSchedule {
  public:
    PlateSchedule(int width, int height, const SurfaceSmoothing& smoothing) {
        auto length = static_cast<double>(smoothing.length);
        cells_.push_back(static_cast<double>(width) * height);
        std::vector<double> lengths{length};
        while (lengths.back() > kCoarsestRatio && std::min(width, height) > 4) {
            width = (width + 1) / 2;
            height = (height + 1) / 2;
            cells_.push_back(static_cast<double>(width) * height);
            lengths.push_back(lengths.back() / 2);
        }
        const auto tooFine = [&](std::size_t level) {
            return lengths[level] > kMaxWeightedRatio ||
                   2 * length / lengths[level] <= static_cast<double>(smoothing.depthSampleSpacing);
        };
        while (tooFine(weighted_) && weighted_ + 1 < lengths.size()) ++weighted_;
    }

    [[nodiscard]] std::size_t levelCount() const { return cells_.size(); }
    /// Finest level on which weights are found in rounds; finer ones take them over.
    [[nodiscard]] std::size_t weighted() const { return weighted_; }

    // Costs in units of one iteration on one cell.
    [[nodiscard]] double costOfRelaxing(std::size_t level) const {
        return cells_[level] * (level < weighted_ ? kFineIterations : kIterations);
    }
    [[nodiscard]] double costOfWeights(std::size_t level) const { return cells_[level] * kWeightCost; }
    [[nodiscard]] double cost() const {
        double sum = kWeightRounds * costOfWeights(weighted_);
        for (std::size_t level = 0; level < cells_.size(); ++level)
            sum += level < weighted_ ? costOfWeights(level) + costOfRelaxing(level)
                                     : kWeightRounds * costOfRelaxing(level);
        return sum;
    }

  private:
    std::vector<double> cells_;
    std::size_t weighted_ = 0;
};

/// Weights of one of `levels`.
PlateWeights weightsOf(std::vector<WeakPlate>& levels, std::size_t level, double focalLength,
                       const SurfaceSmoothing& smoothing) {
    /// [px] correlation of noise that the depth filter cannot distinguish from shape.
    constexpr double kFilterReach = 8;
    const double scale = levels[level].length() / levels[0].length();
    return {levels[level], focalLength * scale,
            CellNoise{.sigma = static_cast<double>(smoothing.noise),
                      .correlation = static_cast<double>(smoothing.correlation) * scale,
                      .left = std::min(1.0, static_cast<double>(smoothing.correlation) / kFilterReach),
                      .rounded = smoothing.rounded}};
}

/// Smooths `plate`, whose data are set.
void smoothPlate(WeakPlate& plate, double focalLength, const SurfaceSmoothing& smoothing, const PlateSchedule& schedule,
                 const Progress& progress) {
    StagedProgress stages(progress, schedule.cost());
    std::vector<WeakPlate> levels{std::move(plate)};
    while (levels.size() < schedule.levelCount()) levels.push_back(levels.back().coarser());
    const std::size_t weighted = schedule.weighted();
    std::vector<PlateWeights> weights;
    weights.reserve(weighted + 1);
    weights.push_back(weightsOf(levels, weighted, focalLength, smoothing));
    for (int round = 0; round < kWeightRounds; ++round) {
        for (std::size_t k = weighted + 1; k < levels.size(); ++k) levels[k].restrictFrom(levels[k - 1]);
        for (std::size_t k = levels.size(); k-- > weighted;) {
            if (k + 1 < levels.size()) levels[k].prolongFrom(levels[k + 1]);
            levels[k].relax(kIterations, stages.next(schedule.costOfRelaxing(k)));
        }
        weights.back().shorten();
        weights.back().update();
        stages.next(schedule.costOfWeights(weighted)).checkpoint(1);
    }
    for (std::size_t k = weighted; k-- > 0;) {
        levels[k].prolongFrom(levels[k + 1]);
        weights.push_back(weightsOf(levels, k, focalLength, smoothing));
        weights.back().takeLengths(weights[weights.size() - 2]);
        weights.back().update();
        stages.next(schedule.costOfWeights(k)).checkpoint(1);
        levels[k].relax(kFineIterations, stages.next(schedule.costOfRelaxing(k)));
    }
    plate = std::move(levels[0]);
}

/// Pixels with depth of one segment.
struct SegmentDepth {
    PixelBox box;
    std::size_t count = 0;
    float nearest = 0, farthest = 0;  ///< [m]
};

LabelTable<SegmentDepth> depthOfSegments(const ImageF& depth, const LabelImage& labels) {
    LabelTable<SegmentDepth> segments;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const float z = depth(x, y);
            if (labels(x, y) == 0 || z <= 0) continue;
            SegmentDepth& segment = segments[labels(x, y)];
            segment.box.add({x, y});
            segment.nearest = segment.count > 0 ? std::min(segment.nearest, z) : z;
            segment.farthest = std::max(segment.farthest, z);
            ++segment.count;
        }
    }
    return segments;
}

void smoothSegment(ImageF& depth, const Image<std::uint8_t>& measured, const LabelImage& labels, double focalLength,
                   const SurfaceSmoothing& smoothing, const SegmentDepth& segment, const Progress& progress) {
    progress.checkpoint(0);
    const PixelBox& box = segment.box;
    const auto forPixels = [&](const auto& body) {
        for (int y = 0; y < box.height(); ++y)
            for (int x = 0; x < box.width(); ++x)
                if (labels(box.x0 + x, box.y0 + y) == smoothing.label && depth(box.x0 + x, box.y0 + y) > 0)
                    body(x, y, depth(box.x0 + x, box.y0 + y));
    };
    WeakPlate plate(box.width(), box.height(), static_cast<double>(smoothing.length));
    forPixels([&](int x, int y, float z) {
        plate.setCell(x, y, 1.0 / static_cast<double>(z), measured(box.x0 + x, box.y0 + y) != 0 ? 1.0 : 0.0);
    });
    smoothPlate(plate, focalLength, smoothing, {box.width(), box.height(), smoothing}, progress);
    const float low = 0.8f * segment.nearest;
    const float high = 1.25f * segment.farthest;
    forPixels([&](int x, int y, float& z) {
        const double w = plate.value(plate.at(x, y));
        if (w > 0) z = std::clamp(static_cast<float>(1 / w), low, high);
    });
}

/// Expected time [ns on two cores] of smoothing a segment; 0 when there is nothing to do.
double timeOf(const SurfaceSmoothing& smoothing, const SegmentDepth& segment) {
    constexpr double kTimePerIteration = 20;
    if (smoothing.label == 0 || segment.count == 0 || !(static_cast<double>(smoothing.length) > kMinLength)) return 0;
    return kTimePerIteration * PlateSchedule(segment.box.width(), segment.box.height(), smoothing).cost();
}

/// Sum of the known inverse depths of a segment.
struct SumOfInverseDepth {
    double sum = 0;
    std::size_t count = 0;
};

/// Smoothing length that the noise requires, for a segment at inverse depth `w` that is `width` pixels wide. Noise of
/// relative σ with errors of one sign over n pixels tilts a plate of length L by about σ f n / L².
void followNoise(SurfaceSmoothing& smoothing, float w, float width, const DepthNoise& noise, float focalLength) {
    /// [rad] slope error that may remain in places; it is typically much smaller.
    constexpr float kMaxTilt = 0.1f;
    // Rounding whose σ makes a slope of 45 degrees over the distance of two measurements is coarse. Cameras that round
    // this coarsely compute depth by matching pictures; their errors keep one sign over at least this many pixels.
    // Finer rounding is noise like any other.
    constexpr float kMinTerrace = 4;
    /// A flat surface continues without a step for longer, the larger the step is.
    constexpr float kTerraceOverSlope = 1.4f;
    constexpr float kMaxLengthOverWidth = 0.125f;
    smoothing.noise = noise.deviation.at(w);
    const float slope = smoothing.noise / w * focalLength;
    smoothing.rounded = noise.quantised && slope > smoothing.depthSampleSpacing;
    if (smoothing.rounded)
        smoothing.correlation = std::max({smoothing.correlation, kMinTerrace, kTerraceOverSlope * slope});
    smoothing.length =
        std::min(std::sqrt(slope * (2 * smoothing.correlation - 1) / kMaxTilt), kMaxLengthOverWidth * width);
}

}  // namespace

std::vector<SurfaceSmoothing> chooseSmoothing(const ImageF& depth, const Scene& scene, const DepthNoise& noise) {
    constexpr float kMaxBumpOverWidth = 0.5f;
    const Photo& photo = *scene.photo;
    LabelTable<SumOfInverseDepth> means;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (photo.labels[i] == 0 || depth[i] <= 0) continue;
        means[photo.labels[i]].sum += 1.0 / static_cast<double>(depth[i]);
        ++means[photo.labels[i]].count;
    }
    const float focalLength = 0.5f * (photo.camera.fx + photo.camera.fy);
    std::vector<SurfaceSmoothing> result;
    for (std::size_t label = 1; label < means.size(); ++label) {
        const auto& [sum, count] = means[label];
        if (count == 0) continue;
        SurfaceSmoothing& smoothing =
            result.emplace_back(SurfaceSmoothing{.label = static_cast<std::uint16_t>(label),
                                                 .correlation = noise.correlationLength,
                                                 .depthSampleSpacing = photo.depthSampleSpacing});
        const auto width = static_cast<float>(std::sqrt(static_cast<double>(count)));
        const Segment* segment = scene.findSegment(smoothing.label);
        if (segment != nullptr && segment->smoothing)
            smoothing.length =
                std::min(*segment->smoothing, kMaxBumpOverWidth * width) / SurfaceSmoothing::kBumpOverLength;
        else
            followNoise(smoothing, static_cast<float>(sum / static_cast<double>(count)), width, noise, focalLength);
    }
    return result;
}

double expectedSmoothingTime(const ImageF& depth, const LabelImage& labels,
                             std::span<const SurfaceSmoothing> segments) {
    const LabelTable<SegmentDepth> depths = depthOfSegments(depth, labels);
    double time = 0;
    for (const SurfaceSmoothing& smoothing : segments) time += timeOf(smoothing, depths[smoothing.label]);
    return time;
}

std::map<std::uint16_t, float> bumpWidths(std::span<const SurfaceSmoothing> segments) {
    std::map<std::uint16_t, float> widths;
    for (const SurfaceSmoothing& smoothing : segments)
        widths[smoothing.label] = SurfaceSmoothing::kBumpOverLength * smoothing.length;
    return widths;
}

void smoothSurfaces(ImageF& depth, const Image<std::uint8_t>& measured, const LabelImage& labels, const Camera& camera,
                    std::span<const SurfaceSmoothing> segments, const Progress& progress) {
    const LabelTable<SegmentDepth> depths = depthOfSegments(depth, labels);
    const double focalLength = 0.5 * static_cast<double>(camera.fx + camera.fy);
    StagedProgress stages(progress, expectedSmoothingTime(depth, labels, segments));
    for (const SurfaceSmoothing& smoothing : segments)
        if (const double time = timeOf(smoothing, depths[smoothing.label]); time > 0)
            smoothSegment(depth, measured, labels, focalLength, smoothing, depths[smoothing.label], stages.next(time));
}

}  // namespace core::analysis
