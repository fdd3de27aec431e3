// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/smooth_surfaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/analysis/depth/weak_plate.h"
#include "core/analysis/segment/segment_pixels.h"

namespace core::analysis {
namespace {

constexpr double kFold = 0.35;    ///< [rad] turn within the smoothing length at which a plate begins to fold
constexpr double kUsualFold = 3;  ///< or so many times the turn that half of it has: a small ball is no fold
constexpr double kJump = 3;       ///< second difference, in σ of the noise, at which depth begins to count as broken
constexpr double kFarOff = 2.5;   ///< residual at which a measurement counts a quarter, in standard deviations
constexpr double kFinestRatio = 12;  ///< smoothing length over the width of the cells that weights are found on
constexpr double kCoarsestRatio = 3;
constexpr double kShortest = 1;  ///< [px] lengths below which there is nothing to smooth
constexpr int kRounds = 6;       ///< of finding weights
constexpr int kIterations = 30;  ///< of conjugate gradients on each level
constexpr int kFollowing = 12;   ///< those on levels finer than the weights'

double gemanMcClure(double x) { return 1 / ((1 + x * x) * (1 + x * x)); }
double fourthPower(double x) { return x * x * x * x; }

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Noise in cells of one level.
struct CellNoise {
    double sigma = 0;        ///< of inverse depth [1/m], 0 = not known
    double correlation = 1;  ///< [cells]
    double left = 1;         ///< part of it that the depth filter before leaves
    bool rounded = false;

    /// Half the width of what noise alone may look like: nothing shorter is a fold or a jump.
    [[nodiscard]] double shortest() const {
        if (sigma <= 0) return 0;
        return 0.5 * (rounded ? correlation : std::max(correlation - 1, 0.0));
    }
    /// What the mean over a square of `count` cells may be off by.
    [[nodiscard]] double tolerance(double count) const {
        return rounded ? sigma : 2 * left * sigma * std::min(1.0, 2 * correlation / std::sqrt(count));
    }
};

/// Finds what a plate may do where, round by round.
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
            unbroken_[i] = gemanMcClure(plate_.bendOfData(i) / (kJump * noise_.sigma));
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
                // Bounded, so that a narrow groove does not stand for all around it.
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

    /// Stiffness by how much the plate turns, trust by how far measurements are off. Maps in few steps come from
    /// cameras that find depth by matching pictures: lines painted on a surface are grooves in it. Of other maps all is
    /// trusted, for what seems far off may be the surface turning away at its outline.
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
        const double spread = std::max(off.empty() ? 0.0 : 1.4826 * medianOf(off), noise_.sigma);
        const double fold = std::max(kFold, kUsualFold * medianOf(all));
        const double least = fourthPower(std::min(1.0, noise_.shortest() / plate_.length()));
        forCells([&](std::size_t i) {
            if (noise_.rounded) {
                const double limit = kFarOff * std::max(spread, 1e-7 * std::abs(plate_.value(i)));
                plate_.setTrust(i, measured_[i] * gemanMcClure((plate_.data(i) - plate_.value(i)) / limit));
            }
            plate_.setStiffness(
                i, least + (1 - least) * gemanMcClure(turns[i] / fold) * fourthPower(local_[i]) * unbroken_[i]);
        });
    }

    /// Takes the lengths that were found on the coarser level.
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
    std::vector<double> measured_;  ///< trust before
    std::vector<double> unbroken_;  ///< stiffness that jumps of the data leave
    std::vector<double> local_;     ///< local smoothing length over the plate's
};

/// Smooths `levels[0]`, whose data are set and which is the only one.
void smoothPlate(std::vector<WeakPlate>& levels, double focalLength, const SurfaceSmoothing& smoothing,
                 const Progress& progress) {
    const double length = levels[0].length();
    while (levels.back().length() > kCoarsestRatio && std::min(levels.back().width(), levels.back().height()) > 4)
        levels.push_back(levels.back().coarser());
    std::size_t weighted = 0;
    const auto tooFine = [&](std::size_t level) {
        return levels[level].length() > kFinestRatio ||
               2 * length / levels[level].length() <= static_cast<double>(smoothing.sample);
    };
    while (tooFine(weighted) && weighted + 1 < levels.size()) ++weighted;
    const auto weightsOf = [&](std::size_t level) {
        constexpr double kFilterReach = 8;  // [px] correlation of noise that the depth filter cannot tell from shape
        const double scale = levels[level].length() / length;
        return PlateWeights(levels[level], focalLength * scale,
                            {.sigma = static_cast<double>(smoothing.noise),
                             .correlation = static_cast<double>(smoothing.correlation) * scale,
                             .left = std::min(1.0, static_cast<double>(smoothing.correlation) / kFilterReach),
                             .rounded = smoothing.rounded});
    };
    const auto progressOf = [&](int round) { return static_cast<float>(round) / static_cast<float>(kRounds + 1); };

    std::vector<PlateWeights> weights;
    weights.reserve(weighted + 1);
    weights.push_back(weightsOf(weighted));
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t k = weighted + 1; k < levels.size(); ++k) levels[k].restrictFrom(levels[k - 1]);
        for (std::size_t k = levels.size(); k-- > weighted;) {
            if (k + 1 < levels.size()) levels[k].prolongFrom(levels[k + 1]);
            levels[k].relax(kIterations, progress.part(progressOf(round), progressOf(round + 1)));
        }
        weights.back().shorten();
        weights.back().update();
    }
    for (std::size_t k = weighted; k-- > 0;) {
        levels[k].prolongFrom(levels[k + 1]);
        weights.push_back(weightsOf(k));
        weights.back().takeLengths(weights[weights.size() - 2]);
        weights.back().update();
        levels[k].relax(kFollowing, progress.part(progressOf(kRounds), 1));
    }
}

}  // namespace

void smoothSurfaces(ImageF& depth, const Image<std::uint8_t>& measured, const LabelImage& labels, const Camera& camera,
                    std::span<const SurfaceSmoothing> segments, const Progress& progress) {
    struct Extent {
        PixelBox box;
        std::size_t count = 0;
        float nearest = 0, farthest = 0;
    };
    std::vector<Extent> extents(65536);
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const float z = depth(x, y);
            if (labels(x, y) == 0 || z <= 0) continue;
            Extent& extent = extents[labels(x, y)];
            extent.box.add({x, y});
            extent.nearest = extent.count > 0 ? std::min(extent.nearest, z) : z;
            extent.farthest = std::max(extent.farthest, z);
            ++extent.count;
        }
    }
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const auto share = [&](std::size_t done) {
            return static_cast<float>(done) / static_cast<float>(segments.size());
        };
        const Progress own = progress.part(share(s), share(s + 1));
        const std::uint16_t label = segments[s].label;
        const auto& [box, count, nearest, farthest] = extents[label];
        const auto length = static_cast<double>(segments[s].length);
        if (label == 0 || count == 0 || !(length > kShortest)) continue;
        own.checkpoint(0);
        std::vector<WeakPlate> levels;
        WeakPlate& plate = levels.emplace_back(box.width(), box.height(), length);
        const auto pixels = [&](const auto& body) {
            for (int y = 0; y < box.height(); ++y)
                for (int x = 0; x < box.width(); ++x)
                    if (labels(box.x0 + x, box.y0 + y) == label && depth(box.x0 + x, box.y0 + y) > 0)
                        body(x, y, depth(box.x0 + x, box.y0 + y));
        };
        pixels([&](int x, int y, float z) {
            plate.setCell(x, y, 1.0 / static_cast<double>(z), measured(box.x0 + x, box.y0 + y) != 0 ? 1.0 : 0.0);
        });
        smoothPlate(levels, 0.5 * static_cast<double>(camera.fx + camera.fy), segments[s], own);
        const float low = 0.8f * nearest;
        const float high = 1.25f * farthest;
        pixels([&](int x, int y, float& z) {
            const double w = levels[0].value(levels[0].at(x, y));
            if (w > 0) z = std::clamp(static_cast<float>(1 / w), low, high);
        });
    }
}

}  // namespace core::analysis
