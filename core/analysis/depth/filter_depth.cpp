// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/filter_depth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/analysis/depth/continue_depth.h"
#include "core/analysis/depth/distant_pixels.h"
#include "core/analysis/depth/flying_pixels.h"
#include "core/analysis/depth/membrane.h"
#include "core/analysis/depth/smooth_surfaces.h"
#include "core/analysis/kernels.h"
#include "core/analysis/segment/segment_pixels.h"
#include "core/base/parallel.h"
#include "shaders/shared/depth_filter_block.h"

namespace core::analysis {
namespace {

/// Squared distance of two encoded colours, [0, 3].
float squaredDistance(std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const int difference = static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255);
        sum += difference * difference;
    }
    return static_cast<float>(sum) * (1.0f / (255 * 255));
}

/// 5×5 Gaussian with taps `step` apart, `sigma` in units of `step`; the centre's weight is 1.
FilterPass makePass(int step, float sigma, const NoiseCurve& range, float colorFactor) {
    FilterPass pass;
    std::size_t count = 0;
    for (int dy = 0; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            if (dy > 0 || dx > 0)
                pass.pairs[count++] = {dx * step, dy * step,
                                       2 * std::exp(static_cast<float>(-dx * dx - dy * dy) / (2 * sigma * sigma))};
    pass.reach = 2 * step;
    pass.range = range;
    pass.colorFactor = colorFactor;
    return pass;
}

/// Weight of a squared residual of depth in units of its range, after Geman and McClure: falls with the fourth power,
/// so that a lone outlier is drawn back to its surface and one surface does not feel another.
float robustWeight(float squared) { return 1 / ((1 + squared) * (1 + squared)); }

/// Tukey's biweight of a squared difference in units of its limit: 1 at 0, 0 from 1 on. Close to a Gaussian whose σ is
/// `kLimit` times smaller than the limit, without its exponential.
float biweight(float squared) {
    const float t = std::max(1 - squared, 0.0f);
    return t * t;
}
constexpr float kLimit = 2.18f;
constexpr float kRange = 1.7f;  ///< of `robustWeight`, in σ of the Gaussian it stands for

/// A pass and the images it looks at.
struct PassOverImage {
    const FilterPass& pass;
    const ImageF& inverseDepth;
    const Image<std::uint32_t>& color;
    const LabelImage& labels;

    [[nodiscard]] float filtered(int x, int y) const {
        const float w = inverseDepth(x, y);
        const float limit = pass.range.at(w);
        if (w <= 0 || limit <= 0) return w;
        const float factor = 1 / (limit * limit);
        const std::uint16_t label = labels(x, y);
        const std::uint32_t center = color(x, y);
        float sum = 0;
        float weight = 1;
        const std::ptrdiff_t width = inverseDepth.width();
        const int reach = pass.reach;
        const bool inside =
            x >= reach && y >= reach && x + reach < inverseDepth.width() && y + reach < inverseDepth.height();
        const std::size_t here = inverseDepth.index(x, y);
        const float* const values = inverseDepth.data() + here;
        const std::uint16_t* const segments = labels.data() + here;
        const std::uint32_t* const colors = color.data() + here;
        for (const FilterPass::Pair& pair : pass.pairs) {
            if (!inside &&
                (!inverseDepth.contains(x + pair.dx, y + pair.dy) || !inverseDepth.contains(x - pair.dx, y - pair.dy)))
                continue;
            const std::ptrdiff_t a = pair.dy * width + pair.dx;
            const float wa = values[a];
            const float wb = values[-a];
            const float residual = 0.5f * (wa + wb) - w;
            const float squared = residual * residual * factor;
            if (squared >= kernel::kMaxSquaredResidual || wa <= 0 || wb <= 0 || segments[a] != label || segments[-a] != label) continue;
            const float k =
                pair.weight * robustWeight(squared) *
                biweight((squaredDistance(colors[a], center) + squaredDistance(colors[-a], center)) * pass.colorFactor);
            sum += k * residual;
            weight += k;
        }
        return w + sum / weight;
    }
};

NoiseCurve scaled(NoiseCurve curve, float factor) {
    for (float& sigma : curve.sigma) sigma *= factor;
    return curve;
}

constexpr int kMaxPasses = 5;
constexpr float kLeastNoise = 2e-6f;  ///< of depth that was filtered: it is not exact, however smooth
constexpr float kAutomaticColorSigma = 0.25f;

/// Progress of pass `k`.
Progress partOf(int k, const Progress& progress) {
    const float from = 0.1f + 0.18f * static_cast<float>(k);
    return progress.part(from, from + 0.18f);
}

ImageF filterAutomatically(ImageF w, AnalysisKernels::DepthFilter& filter, const LabelImage& labels,
                           const Camera& camera, const DepthNoise& noise, float pixelsPerSample,
                           const Progress& progress) {
    // Between two steps of rounding it is not known where depth changes; paint would keep the terraces where they are.
    const float colorFactor =
        noise.quantised ? 0.0f : 1 / (kLimit * kLimit * kAutomaticColorSigma * kAutomaticColorSigma);
    const int base = std::max(1, static_cast<int>(std::lround(pixelsPerSample)));
    constexpr float kMinTilt = 0.02f;   // [rad], about a degree
    constexpr float kAllowance = 4.0f;  // range in σ of what is left: keeps most of what is noise
    // An enlarged map is smooth between its own pixels already.
    const int passes = base > 1 && !noise.quantised ? 3 : kMaxPasses;
    for (int k = 0; k < passes; ++k) {
        const int step = base << k;
        // Uncorrelated noise halves with every pass at least; correlated noise only once taps are farther apart.
        const float predicted =
            noise.quantised ? 1.0f : std::min(1.0f, 2 * noise.correlationLength / static_cast<float>(step));
        NoiseCurve left = scaled(noise.deviation, predicted);
        if (!noise.quantised) {
            const NoiseCurve measured =
                measureNoise(w, labels, step, Differences::Second, partOf(k, progress).part(0, 0));
            for (std::size_t i = 0; i < left.sigma.size(); ++i)
                if (measured.sigma[i] > 0) left.sigma[i] = std::min(left.sigma[i], measured.sigma[i]);
        }
        float tilt = 0;
        for (std::size_t i = 0; i < left.sigma.size(); ++i) {
            const float level = left.first + static_cast<float>(i) / left.cellsPerUnit;
            tilt = std::max(tilt, left.sigma[i] / level);
        }
        tilt *= std::max(camera.fx, camera.fy) / static_cast<float>(step);
        if (tilt < kMinTilt && step > static_cast<int>(noise.correlationLength)) break;
        w = filter.run(makePass(step, 1.0f, scaled(left, kAllowance), colorFactor), w, partOf(k, progress));
    }
    return w;
}

ImageF filterByHand(ImageF w, AnalysisKernels::DepthFilter& filter, const DepthFilterParams& params,
                    const Progress& progress) {
    const float colorSigma = std::max(params.colorSigma, 1e-4f);
    NoiseCurve range;
    range.cellsPerUnit = 1;  // σ(1/z) = σ(z)/z · 1/z
    for (std::size_t i = 0; i < range.sigma.size(); ++i)
        range.sigma[i] = kRange * params.depthSigma * static_cast<float>(i);
    // Variances add up: passes with a σ of t, 2t, 4t, ... pixels.
    int passes = 1;
    float variance = 1;
    while (variance < params.spatialSigma * params.spatialSigma && passes < kMaxPasses)
        variance += static_cast<float>(1 << (2 * passes++));
    const float sigma = std::min(params.spatialSigma / std::sqrt(variance), 1.5f);
    const float colorFactor = 1 / (kLimit * kLimit * colorSigma * colorSigma);
    for (int k = 0; k < passes; ++k)
        w = filter.run(makePass(1 << k, sigma, range, colorFactor), w, partOf(k, progress));
    return w;
}

/// Width of the bump, half a wave, that a weak plate halves, over the plate's length L: 1 / (1 + (2πL/λ)⁴) is left.
constexpr float kBumpOverLength = std::numbers::pi_v<float>;

/// How far each segment's surface is smoothed: as the user says, else by the noise. Noise σ of relative depth that errs
/// alike over n pixels tilts a plate of length L by about σ f n / L².
std::vector<SurfaceSmoothing> smoothingOf(const ImageF& depth, const Scene& scene, const DepthNoise& noise) {
    constexpr float kTilt = 0.1f;  // [rad] that is left in places; typically much less
    // Rounding whose σ makes a slope of 45 degrees over the distance of two measurements is coarse: cameras that round
    // so match pictures, and err alike over some pixels [px]. Finer rounding is noise like any other.
    constexpr float kTerraces = 4;
    constexpr float kTerraceOverSlope = 1.4f;  // a flat surface goes on without a step the longer the larger the step
    // Of the width of a segment (√pixels): the automatic length, and the bumps that the user smooths away, at most.
    constexpr float kLargestPart = 0.125f;
    constexpr float kLargestBump = 0.5f;
    const Photo& photo = *scene.photo;
    std::vector<double> sums(65536, 0.0);
    std::vector<std::size_t> counts(65536, 0);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (photo.labels[i] == 0 || depth[i] <= 0) continue;
        sums[photo.labels[i]] += 1.0 / static_cast<double>(depth[i]);
        ++counts[photo.labels[i]];
    }
    const float focalLength = 0.5f * (photo.camera.fx + photo.camera.fy);
    std::vector<SurfaceSmoothing> result;
    for (std::size_t label = 1; label < counts.size(); ++label) {
        if (counts[label] == 0) continue;
        SurfaceSmoothing& smoothing = result.emplace_back(SurfaceSmoothing{.label = static_cast<std::uint16_t>(label),
                                                                           .correlation = noise.correlationLength,
                                                                           .sample = photo.depthStep});
        const auto width = static_cast<float>(std::sqrt(static_cast<double>(counts[label])));
        const Segment* segment = scene.findSegment(smoothing.label);
        if (segment != nullptr && segment->smoothing) {
            smoothing.length = std::min(*segment->smoothing, kLargestBump * width) / kBumpOverLength;
            continue;
        }
        const auto w = static_cast<float>(sums[label] / static_cast<double>(counts[label]));
        smoothing.noise = noise.deviation.at(w);
        const float slope = smoothing.noise / w * focalLength;
        smoothing.rounded = noise.quantised && slope > photo.depthStep;
        if (smoothing.rounded)
            smoothing.correlation = std::max({smoothing.correlation, kTerraces, kTerraceOverSlope * slope});
        smoothing.length = std::min(std::sqrt(slope * (2 * smoothing.correlation - 1) / kTilt), kLargestPart * width);
    }
    return result;
}

/// Continues segments into what the sensor missed beside their surfaces.
void continueSegments(ImageF& depth, const Photo& photo, const Progress& progress) {
    constexpr int kGapMargin = 8;    // [px] at least, and samples of the depth map
    constexpr int kReachParts = 30;  // the longer side over it
    DepthGaps gaps{Image<std::uint8_t>(depth.width(), depth.height(), 0),
                   kGapMargin * std::max(1, static_cast<int>(std::lround(photo.depthStep))),
                   std::max(depth.width(), depth.height()) / kReachParts};
    for (std::size_t i = 0; i < depth.size(); ++i) gaps.isGap[i] = photo.labels[i] != 0 && depth[i] <= 0 ? 1 : 0;
    continueDepth(depth, photo.labels, photo.camera, gaps, progress);
}

}  // namespace

Image<std::uint32_t> encodeColor(const ImageRgb& color, const Progress& progress) {
    Image<std::uint32_t> encoded(color.width(), color.height());
    parallelFor(progress, color.height(), [&](int y) {
        for (int x = 0; x < color.width(); ++x) {
            const Vector3f& c = color(x, y);
            std::uint32_t packed = 0;
            for (int k = 2; k >= 0; --k)
                packed = packed << 8 | static_cast<std::uint32_t>(255 * std::sqrt(std::clamp(c[k], 0.0f, 1.0f)) + 0.5f);
            encoded(x, y) = packed;
        }
    });
    return encoded;
}

ImageF runFilterPass(const FilterPass& pass, const ImageF& inverseDepth, const Image<std::uint32_t>& color,
                     const LabelImage& labels, const Progress& progress) {
    ImageF result(inverseDepth.width(), inverseDepth.height());
    const PassOverImage filter{pass, inverseDepth, color, labels};
    parallelFor(progress, result.height(), [&](int y) {
        for (int x = 0; x < result.width(); ++x) result(x, y) = filter.filtered(x, y);
    });
    return result;
}

ImageF filterDepth(const ImageF& depth, const ImageRgb& color, const LabelImage& labels, const Camera& camera,
                   const DepthFilterParams& params, const DepthNoise& noise, float pixelsPerSample,
                   const StepContext& context) {
    if (!params.enabled) return depth;
    const bool nothing = params.automatic ? noise.relative <= 0 : params.spatialSigma <= 0 || params.depthSigma <= 0;
    if (nothing) return depth;
    const Image<std::uint32_t> encoded = encodeColor(color, context.progress.part(0, 0.1f));
    const auto filter = context.kernels.depthFilter(encoded, labels);
    ImageF w = inverseOf(depth);
    w = params.automatic
            ? filterAutomatically(std::move(w), *filter, labels, camera, noise, pixelsPerSample, context.progress)
            : filterByHand(std::move(w), *filter, params, context.progress);
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = depth[i] > 0 ? 1 / w[i] : 0.0f;
    return w;
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

void completeSegments(ImageF& depth, const LabelImage& labels, const Progress& progress) {
    struct Part {
        PixelBox box;
        double sum = 0;  ///< of inverse depth
        std::size_t known = 0, missing = 0;
    };
    std::vector<Part> parts(65536);
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            Part& part = parts[labels(x, y)];
            part.box.add({x, y});
            if (depth(x, y) > 0)
                part.sum += 1.0 / static_cast<double>(depth(x, y)), ++part.known;
            else
                ++part.missing;
        }
    }
    for (std::size_t label = 1; label < parts.size(); ++label) {
        const auto& [box, sum, known, missing] = parts[label];
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

Step filterDepthStep() {
    Step step;
    step.task = Task::RecoverDepth;
    step.reads = {Item::Photo};
    step.writes = Item::Depth;
    step.params = [](const Scene& scene, Hash& hash) {
        addParams(hash, Stage::Geometry, scene);
        for (const Segment& segment : scene.segments) addParams(hash.add(segment.label), Stage::Geometry, segment);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        auto result = std::make_shared<FilteredDepth>();
        ImageF depth = photo.depth;
        for (float& z : depth.pixels())
            if (!(z > 0) || !std::isfinite(z)) z = 0;
        if (std::ranges::none_of(depth.pixels(), [](float z) { return z > 0; }))
            throw Error(ErrorKind::Input,
                        "The depth map has no valid pixel: all of its " + std::to_string(depth.size()) +
                            " values are zero or not finite, but at least one positive depth is needed. Load a depth "
                            "map that belongs to the photograph, or check its unit and kind.");
        const DepthNoise noise =
            estimateDepthNoise(inverseOf(depth), photo.labels, photo.depthStep, context.progress.part(0, 0));
        const bool measured = noise.relative > 0 || photo.depthStep > 1;
        if (board.scene->depthFilter.enabled && measured)
            removeFlyingPixels(depth, photo.labels, photo.camera, photo.depthStep, context.progress.part(0, 0));
        result->depth = filterDepth(depth, photo.color, photo.labels, photo.camera, board.scene->depthFilter, noise,
                                    photo.depthStep, context);
        result->relativeNoise = noise.relative;
        if (board.scene->depthFilter.enabled && noise.relative > 0) {
            const ImageF left = inverseOf(result->depth);
            result->relativeNoise = std::max(
                kLeastNoise,
                relativeNoise(measureNoise(left, photo.labels, 1, Differences::Fourth, context.progress.part(1, 1)),
                              left));
        }
        if (board.scene->depthFilter.enabled)
            fillSmallHoles(result->depth, photo.labels, board.scene->depthFilter.holeRadius);
        continueSegments(result->depth, photo, context.progress.part(1, 1));
        completeSegments(result->depth, photo.labels, context.progress.part(1, 1));
        if (board.scene->depthFilter.enabled) {
            Image<std::uint8_t> known(depth.width(), depth.height());
            for (std::size_t i = 0; i < depth.size(); ++i) known[i] = depth[i] > 0 ? 1 : 0;
            const std::vector<SurfaceSmoothing> segments = smoothingOf(result->depth, *board.scene, noise);
            smoothSurfaces(result->depth, known, photo.labels, photo.camera, segments, context.progress.part(1, 1));
            for (const SurfaceSmoothing& segment : segments)
                result->smoothing[segment.label] = kBumpOverLength * segment.length;
        }
        result->distant = findDistantPixels(result->depth);
        board.depth = std::move(result);
    };
    return step;
}

}  // namespace core::analysis
