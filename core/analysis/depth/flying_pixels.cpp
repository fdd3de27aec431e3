// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/flying_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/segment/support_planes.h"
#include "core/base/parallel.h"
#include "core/base/pixel.h"
#include "core/base/staged_progress.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// The reach of a ramp is the longer side of the picture divided by this.
constexpr int kReachParts = 60;
/// Samples of a window on each side of its centre.
constexpr int kGrid = 4;
/// Smallest fraction of the outline nearby that is blurred where there is a ramp.
constexpr float kMinRampFraction = 0.6f;
/// Smallest fraction of the outline nearby that is a strip where there is one: about half at the ends of a strip.
constexpr float kMinStripFraction = 0.3f;
/// The width of a ramp's foot is its reach divided by this.
constexpr int kFootParts = 8;
/// Width of the band along outlines [depth samples] in which an enlarged map mixes both surfaces, and its half-width of
/// the window in which depth must jump there, by this much relative to the nearer depth.
constexpr float kBandSamples = 2.5f;
constexpr int kBandWindow = 3;
constexpr float kBandJump = 0.03f;
/// Smallest fraction of the outlines with a jump that is blurred where the whole map counts as blurred.
constexpr float kMinBlurredMap = 0.1f;
/// Smallest jump [pixel widths per pixel of the reach] to what lies behind: less is relief.
constexpr float kMinJump = 8;
/// Steepest relief [pixel widths per pixel] that may lie in a gap.
constexpr float kMaxGapSlope = 3;
/// Second over first difference of inverse depth below which a surface is a plane.
constexpr float kMinBend = 0.15f;
// Fractions of the jump from the segment to what lies behind it.
/// An outline pixel farther back than this may be flying.
constexpr float kFlyingShare = 0.25f;
/// Pixels farther back than this are removed where most of the outline nearby is blurred.
constexpr float kRemovedShare = 0.12f;
/// A jump of this much at the outline itself is a clean edge.
constexpr float kCleanShare = 0.4f;

/// The two surfaces around an outline pixel.
struct Surfaces {
    float own = 0;     ///< [m] depth of the segment nearby
    float behind = 0;  ///< [m] depth of what lies behind it; not above `own` where there is nothing

    [[nodiscard]] float share(float z) const { return (z - own) / (behind - own); }
};

enum class Edge : std::uint8_t {
    None,     ///< not an outline pixel
    Clean,    ///< depth jumps at the outline
    Flying,   ///< an isolated pixel between the surfaces
    Blurred,  ///< depth does not jump at the outline
};

class Outlines {
  public:
    Outlines(const ImageF& depth, const LabelImage& labels, const Camera& camera, bool enlarged)
        : depth_(depth),
          labels_(labels),
          enlarged_(enlarged),
          footprint_(2 / (camera.fx + camera.fy)),
          reach_(std::max({kGrid, depth.width() / kReachParts, depth.height() / kReachParts})) {}

    [[nodiscard]] int reach() const { return reach_; }

    [[nodiscard]] bool isOutline(int x, int y) const {
        return std::ranges::any_of(kNeighbors, [&](Pixel step) {
            return labels_.contains(x + step.x, y + step.y) && labels_(x + step.x, y + step.y) != labels_(x, y);
        });
    }

    /// Kind of an outline pixel and, unless it is clean, the surfaces around it.
    [[nodiscard]] Edge classify(int x, int y, Surfaces& surfaces) const {
        const std::optional<Surfaces> around = surfacesAround(x, y);
        if (!around) return Edge::Clean;
        surfaces = *around;
        const float z = depth_(x, y);
        if (surfaces.behind - surfaces.own < kMinJump * static_cast<float>(reach_) * footprint_ * z ||
            surfaces.share(z) < kRemovedShare)
            return Edge::Clean;
        if (enlarged_ && fallsFasterThanBall(x, y)) return Edge::Blurred;
        if (surfaces.share(z) < kFlyingShare) return Edge::Clean;
        float beyond = z, inside = z;
        for (const Pixel& step : kNeighbors) {
            const int bx = x + 2 * step.x;
            const int by = y + 2 * step.y;
            if (!depth_.contains(bx, by) || depth_(bx, by) <= 0) continue;
            if (labels_(bx, by) != labels_(x, y))
                beyond = std::max(beyond, depth_(bx, by));
            else
                inside = std::min(inside, depth_(bx, by));
        }
        const float jump = surfaces.share(beyond) - surfaces.share(z);
        const float fall = surfaces.share(z) - surfaces.share(inside);
        if (jump < kCleanShare) return Edge::Blurred;
        return fall > kFlyingShare && fall > 0.5f * jump ? Edge::Flying : Edge::Clean;
    }

    /// Whether depth falls away at an outline pixel faster than at the rim of a ball as wide as the picture, but not
    /// like a plane: a face may be seen at any angle.
    [[nodiscard]] bool fallsFasterThanBall(int x, int y) const {
        const auto width = static_cast<float>(std::max(depth_.width(), depth_.height()));
        const int distance = 1 + reach_ / kFootParts;
        const float ofBall = std::sqrt(width) * (std::sqrt(static_cast<float>(distance) + 0.5f) - std::sqrt(0.5f));
        const float z = depth_(x, y);
        return std::ranges::any_of(kNeighbors, [&](Pixel step) {
            const auto inside = [&](int d) {
                const int u = x + d * step.x;
                const int v = y + d * step.y;
                return depth_.contains(u, v) && labels_(u, v) == labels_(x, y) ? depth_(u, v) : 0.0f;
            };
            const float near = inside(distance);
            if (near <= 0 || z - near < ofBall * footprint_ * z) return false;
            const float farther = inside(2 * distance);
            const float bend = farther > 0 ? 1 / z - 2 / near + 1 / farther : 1 / near;
            return std::abs(bend) > kMinBend * (1 / near - 1 / z);
        });
    }

    /// Whether the segment gets nearer within `distance` pixels by more than relief can.
    [[nodiscard]] bool isSteep(int x, int y, int distance) const {
        const float z = depth_(x, y);
        return std::ranges::any_of(kNeighbors, [&](Pixel step) {
            const int u = x + distance * step.x;
            const int v = y + distance * step.y;
            if (!depth_.contains(u, v) || labels_(u, v) != labels_(x, y) || depth_(u, v) <= 0) return false;
            return z - depth_(u, v) > kMaxGapSlope * static_cast<float>(distance) * footprint_ * z;
        });
    }

    /// Whether depth is continuous across the outline and jumps to the segment's own farther inside.
    [[nodiscard]] bool hasStrip(int x, int y) const {
        return std::ranges::any_of(kNeighbors, [&](Pixel inwards) { return stripWidth(x, y, inwards) > 0; });
    }

    /// Number of pixels from the outline inwards whose depth is that of what lies beyond the outline. The jump to the
    /// segment's own depth is steeper than relief, even across the gap that sensors leave beside it.
    [[nodiscard]] int stripWidth(int x, int y, Pixel inwards) const {
        const int ox = x - inwards.x;
        const int oy = y - inwards.y;
        if (!depth_.contains(ox, oy) || labels_(ox, oy) == labels_(x, y) || depth_(ox, oy) <= 0) return 0;
        int last = 0;
        for (int k = 1; k <= reach_; ++k) {
            const int u = x + k * inwards.x;
            const int v = y + k * inwards.y;
            if (!depth_.contains(u, v) || labels_(u, v) != labels_(x, y)) return 0;
            if (depth_(u, v) <= 0) continue;
            const float z = depth_(x + last * inwards.x, y + last * inwards.y);
            const float jump = z - depth_(u, v);
            const auto gap = static_cast<float>(k - last - 1);
            if (jump > (kMinJump + kMaxGapSlope * gap) * footprint_ * z)
                return std::abs(depth_(ox, oy) - depth_(x, y)) < kFlyingShare * jump ? last + 1 : 0;
            last = k;
        }
        return 0;
    }

  private:
    /// nullopt where either surface has too few samples.
    [[nodiscard]] std::optional<Surfaces> surfacesAround(int x, int y) const {
        constexpr std::size_t kSamples = (2 * kGrid + 1) * (2 * kGrid + 1);
        constexpr std::size_t kMinSamples = 4;
        std::array<float, kSamples> own, others;
        std::size_t ownCount = 0, otherCount = 0;
        for (int j = -kGrid; j <= kGrid; ++j) {
            for (int i = -kGrid; i <= kGrid; ++i) {
                const int sx = x + i * reach_ / kGrid;
                const int sy = y + j * reach_ / kGrid;
                if (!depth_.contains(sx, sy) || depth_(sx, sy) <= 0) continue;
                if (labels_(sx, sy) == labels_(x, y))
                    own[ownCount++] = depth_(sx, sy);
                else
                    others[otherCount++] = depth_(sx, sy);
            }
        }
        if (ownCount < kMinSamples || otherCount < kMinSamples) return std::nullopt;
        return Surfaces{quantile(std::span(own).first(ownCount), 0.08),
                        quantile(std::span(others).first(otherCount), 0.6)};
    }

    const ImageF& depth_;
    const LabelImage& labels_;
    bool enlarged_;    ///< ramps are drawn out
    float footprint_;  ///< width of a pixel at a distance of 1
    int reach_;        ///< [px] of a ramp
};

/// Calls `visitor(x, y)` for the pixels of the centre's segment within `radius`.
template <class Visitor>
void forDisk(const LabelImage& labels, Pixel center, int radius, const Visitor& visitor) {
    for (int y = std::max(center.y - radius, 0); y <= std::min(center.y + radius, labels.height() - 1); ++y)
        for (int x = std::max(center.x - radius, 0); x <= std::min(center.x + radius, labels.width() - 1); ++x) {
            const int dx = x - center.x;
            const int dy = y - center.y;
            if (dx * dx + dy * dy <= radius * radius && labels(x, y) == labels(center.x, center.y)) visitor(x, y);
        }
}

/// The outline pixels of a picture by kind.
struct ClassifiedOutlines {
    Image<Edge> edges;
    Image<std::uint8_t> isStrip;  ///< depth continues across the outline and jumps farther inside
    Image<Surfaces> surfaces;     ///< valid where flying or blurred
};

ClassifiedOutlines classify(const Outlines& outlines, const ImageF& measured, const LabelImage& labels,
                            const Progress& progress) {
    ClassifiedOutlines result{Image<Edge>(labels.width(), labels.height(), Edge::None),
                              Image<std::uint8_t>(labels.width(), labels.height(), 0),
                              Image<Surfaces>(labels.width(), labels.height())};
    const std::vector<bool> supports = findSupports(labels);
    parallelFor(progress, labels.height(), [&](int y) {
        for (int x = 0; x < labels.width(); ++x) {
            if (labels(x, y) == 0 || supports[labels(x, y)] || measured(x, y) <= 0 || !outlines.isOutline(x, y))
                continue;
            result.edges(x, y) = outlines.classify(x, y, result.surfaces(x, y));
            result.isStrip(x, y) = outlines.hasStrip(x, y) ? 1 : 0;
        }
    });
    return result;
}

/// Removes flying pixels, blurred outlines and strips of background; returns 1 for what belongs to a ramp.
Image<std::uint8_t> removeOutlines(const Outlines& outlines, const ClassifiedOutlines& classified,
                                   const ImageF& measured, const LabelImage& labels, ImageF& depth,
                                   const Progress& progress) {
    const auto& [edges, isStrip, surfaces] = classified;
    // Ramps and strips extend along the outline; a sensor's noise makes single pixels of a clean one look the same.
    const auto isMostly = [&](Pixel pixel, float fraction, const auto& isAlike) {
        int alike = 0, count = 0;
        forDisk(labels, pixel, outlines.reach(), [&](int x, int y) {
            if (edges(x, y) == Edge::None) return;
            ++count;
            if (isAlike(x, y)) ++alike;
        });
        return static_cast<float>(alike) > fraction * static_cast<float>(count);
    };
    const auto isBlurred = [&](int x, int y) { return edges(x, y) == Edge::Blurred; };
    const auto isInStrip = [&](int x, int y) { return isStrip(x, y) != 0; };
    Image<std::uint8_t> ramp(depth.width(), depth.height(), 0);
    for (int y = 0; y < depth.height(); ++y) {
        progress.checkpoint(static_cast<float>(y) / static_cast<float>(depth.height()));
        for (int x = 0; x < depth.width(); ++x) {
            if (isInStrip(x, y) && isMostly({x, y}, kMinStripFraction, isInStrip))
                for (const Pixel& inwards : kNeighbors)
                    for (int k = outlines.stripWidth(x, y, inwards) - 1; k >= 0; --k)
                        depth(x + k * inwards.x, y + k * inwards.y) = 0;
            if (edges(x, y) != Edge::Flying && edges(x, y) != Edge::Blurred) continue;
            depth(x, y) = 0;
            if (edges(x, y) == Edge::Flying || !isMostly({x, y}, kMinRampFraction, isBlurred)) continue;
            forDisk(labels, {x, y}, outlines.reach(), [&, &between = surfaces(x, y)](int u, int v) {
                if (between.share(measured(u, v)) > kRemovedShare) ramp(u, v) = 1;
            });
        }
    }
    return ramp;
}

/// Grows ramps by up to `distance` pixels, as long as depth falls faster than relief does over the width of a foot.
void followRamps(const Outlines& outlines, const ImageF& measured, const LabelImage& labels, int distance, int foot,
                 Image<std::uint8_t>& ramp) {
    std::vector<Pixel> front, next;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (ramp(x, y) == 1) front.push_back({x, y});
    for (int k = 0; k < distance && !front.empty(); ++k) {
        next.clear();
        for (const auto& [x, y] : front)
            for (const Pixel& step : kNeighbors) {
                const int u = x + step.x;
                const int v = y + step.y;
                if (!labels.contains(u, v) || labels(u, v) != labels(x, y) || ramp(u, v) == 1 || measured(u, v) <= 0 ||
                    !outlines.isSteep(u, v, foot))
                    continue;
                ramp(u, v) = 1;
                next.push_back({u, v});
            }
        front.swap(next);
    }
}

/// Whether depth around an outline pixel jumps, in either direction.
bool jumpsAround(const ImageF& measured, Pixel pixel, int spacing) {
    float nearest = measured(pixel.x, pixel.y), farthest = nearest;
    for (int j = -kBandWindow; j <= kBandWindow; ++j)
        for (int i = -kBandWindow; i <= kBandWindow; ++i) {
            const int u = pixel.x + i * spacing;
            const int v = pixel.y + j * spacing;
            if (!measured.contains(u, v) || measured(u, v) <= 0) continue;
            nearest = std::min(nearest, measured(u, v));
            farthest = std::max(farthest, measured(u, v));
        }
    return farthest > (1 + kBandJump) * nearest;
}

/// Removes the band along outlines with a jump where the samples of an enlarged map mix both surfaces, unless nothing
/// of the segment would be left nearby to continue.
void removeMixedBand(const ClassifiedOutlines& classified, const ImageF& measured, const LabelImage& labels,
                     float depthSampleSpacing, ImageF& depth) {
    const int width = static_cast<int>(std::lround(kBandSamples * depthSampleSpacing));
    const int spacing = std::max(1, static_cast<int>(std::lround(depthSampleSpacing)));
    Image<std::uint8_t> band(labels.width(), labels.height(), 0);
    std::size_t jumps = 0, blurred = 0;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) {
            if (classified.edges(x, y) == Edge::None || !jumpsAround(measured, {x, y}, spacing)) continue;
            ++jumps;
            if (classified.edges(x, y) == Edge::Blurred) ++blurred;
            forDisk(labels, {x, y}, width, [&](int u, int v) { band(u, v) = 1; });
        }
    if (static_cast<float>(blurred) < kMinBlurredMap * static_cast<float>(jumps)) return;
    std::vector<Pixel> front, next;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) != 0 && band(x, y) == 0 && depth(x, y) > 0) front.push_back({x, y});
    for (int k = 0; k < 2 * width && !front.empty(); ++k) {
        next.clear();
        for (const auto& [x, y] : front)
            for (const Pixel& step : kNeighbors) {
                const int u = x + step.x;
                const int v = y + step.y;
                if (!labels.contains(u, v) || labels(u, v) != labels(x, y) || band(u, v) == 0) continue;
                band(u, v) = 0;
                depth(u, v) = 0;
                next.push_back({u, v});
            }
        front.swap(next);
    }
}

}  // namespace

void removeFlyingPixels(ImageF& depth, const LabelImage& labels, const Camera& camera, float depthSampleSpacing,
                        const Progress& progress) {
    constexpr double kRemovalCost = 0.5;
    const ImageF measured = depth;
    const bool enlarged = depthSampleSpacing > 1;
    const Outlines outlines(measured, labels, camera, enlarged);
    const int foot = 1 + outlines.reach() / kFootParts;
    StagedProgress stages(progress, 1);
    const ClassifiedOutlines classified = classify(outlines, measured, labels, stages.next(1 - kRemovalCost));
    Image<std::uint8_t> ramp = removeOutlines(outlines, classified, measured, labels, depth, stages.next(kRemovalCost));
    if (enlarged) followRamps(outlines, measured, labels, outlines.reach(), foot, ramp);
    // The rest of a ramp cannot be distinguished from relief: its foot is removed, too.
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            if (ramp(x, y) == 1) forDisk(labels, {x, y}, foot, [&](int u, int v) { depth(u, v) = 0; });
    if (enlarged) removeMixedBand(classified, measured, labels, depthSampleSpacing, depth);
}

}  // namespace core::analysis
