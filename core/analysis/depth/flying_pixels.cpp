// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/flying_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/analysis/segment/segment_pixels.h"
#include "core/analysis/segment/support_planes.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

constexpr int kReachParts = 60;         ///< the longer side over the reach of a ramp
constexpr int kGrid = 4;                ///< samples of a window on each side of its centre
constexpr float kRampPart = 0.6f;       ///< of the outline near by that is blurred where a ramp is
constexpr int kFootParts = 8;           ///< the reach over the width of a ramp's foot
constexpr float kLeastJump = 8;         ///< [pixel widths per pixel of the reach] to what lies behind: less is relief
constexpr float kFlyingShare = 0.25f;   ///< of that jump: an outline pixel farther back than this may be flying
constexpr float kRemovedShare = 0.12f;  ///< of that jump: what is farther back near a flying one goes with it
constexpr float kCleanShare = 0.4f;     ///< of that jump: this much at the outline itself is a clean edge
constexpr float kLeastBend = 0.15f;     ///< second over first difference of inverse depth: less is a plane
constexpr float kGapSlope = 3;          ///< [pixel widths per pixel] of relief that may lie in a gap
constexpr float kStripPart = 0.3f;      ///< of the outline near by that is a strip where one is; its ends have half

/// The two surfaces about one pixel of an outline.
struct Surfaces {
    float own = 0;     ///< depth of the segment near by [m]
    float behind = 0;  ///< depth of what lies behind it [m]; not above `own` where there is nothing

    [[nodiscard]] float share(float z) const { return (z - own) / (behind - own); }
};

enum class Edge : std::uint8_t {
    None,     ///< no pixel of an outline
    Clean,    ///< depth jumps at the outline
    Flying,   ///< between the surfaces, by itself
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

    /// What an outline pixel is, and, unless it is clean, the surfaces about it.
    [[nodiscard]] Edge classify(int x, int y, Surfaces& surfaces) const {
        constexpr std::size_t kSamples = (2 * kGrid + 1) * (2 * kGrid + 1);
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
        if (ownCount < 4 || otherCount < 4) return Edge::Clean;
        surfaces = {quantile(own, ownCount, 0.08), quantile(others, otherCount, 0.6)};
        const float z = depth_(x, y);
        if (surfaces.behind - surfaces.own < kLeastJump * static_cast<float>(reach_) * footprint_ * z ||
            surfaces.share(z) < kRemovedShare)
            return Edge::Clean;
        if (enlarged_ && fallsLikeNoBall(x, y)) return Edge::Blurred;
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

    /// Whether depth falls away at an outline pixel faster than at the rim of a ball as wide as the picture, and not
    /// like a plane: a face may be seen at any angle.
    [[nodiscard]] bool fallsLikeNoBall(int x, int y) const {
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
            return std::abs(bend) > kLeastBend * (1 / near - 1 / z);
        });
    }

    /// Whether the segment comes nearer than relief does within `distance` pixels.
    [[nodiscard]] bool isSteep(int x, int y, int distance) const {
        const float z = depth_(x, y);
        return std::ranges::any_of(kNeighbors, [&](Pixel step) {
            const int u = x + distance * step.x;
            const int v = y + distance * step.y;
            if (!depth_.contains(u, v) || labels_(u, v) != labels_(x, y) || depth_(u, v) <= 0) return false;
            return z - depth_(u, v) > kGapSlope * static_cast<float>(distance) * footprint_ * z;
        });
    }

    /// Whether depth goes on across the outline and comes back to the segment farther in.
    [[nodiscard]] bool hasStrip(int x, int y) const {
        return std::ranges::any_of(kNeighbors, [&](Pixel inwards) { return stripWidth(x, y, inwards) > 0; });
    }

    /// Number of pixels from the outline inwards whose depth is that of what lies beyond the outline; 0: none. The jump
    /// to the segment's own depth is steeper than relief, over the gap that sensors leave beside it too.
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
            if (jump > (kLeastJump + kGapSlope * gap) * footprint_ * z)
                return std::abs(depth_(ox, oy) - depth_(x, y)) < kFlyingShare * jump ? last + 1 : 0;
            last = k;
        }
        return 0;
    }

  private:
    template <std::size_t N>
    static float quantile(std::array<float, N>& values, std::size_t count, double q) {
        const auto rank = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(count - 1));
        std::nth_element(values.begin(), rank, values.begin() + static_cast<std::ptrdiff_t>(count));
        return *rank;
    }

    const ImageF& depth_;
    const LabelImage& labels_;
    bool enlarged_;    ///< ramps are drawn out
    float footprint_;  ///< width of a pixel at a distance of 1
    int reach_;        ///< [px]
};

}  // namespace

void removeFlyingPixels(ImageF& depth, const LabelImage& labels, const Camera& camera, float pixelsPerSample,
                        const Progress& progress) {
    const std::vector<bool> supports = findSupports(labels);
    const ImageF measured = depth;
    const bool enlarged = pixelsPerSample > 1;
    const Outlines outlines(measured, labels, camera, enlarged);
    const int reach = outlines.reach();
    Image<Edge> edges(depth.width(), depth.height(), Edge::None);
    Image<std::uint8_t> strips(depth.width(), depth.height(), 0);
    Image<Surfaces> surfaces(depth.width(), depth.height());
    parallelFor(progress, depth.height(), [&](int y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (labels(x, y) == 0 || supports[labels(x, y)] || measured(x, y) <= 0 || !outlines.isOutline(x, y))
                continue;
            edges(x, y) = outlines.classify(x, y, surfaces(x, y));
            strips(x, y) = outlines.hasStrip(x, y) ? 1 : 0;
        }
    });

    const auto visit = [&](Pixel center, int radius, const auto& visitor) {
        for (int y = std::max(center.y - radius, 0); y <= std::min(center.y + radius, depth.height() - 1); ++y)
            for (int x = std::max(center.x - radius, 0); x <= std::min(center.x + radius, depth.width() - 1); ++x) {
                const int dx = x - center.x;
                const int dy = y - center.y;
                if (dx * dx + dy * dy <= radius * radius && labels(x, y) == labels(center.x, center.y)) visitor(x, y);
            }
    };
    // Ramps and strips run along the outline; the noise of a sensor makes some pixels of a clean one look alike.
    const auto runsAlong = [&](Pixel pixel, float part, const auto& isAlike) {
        int alike = 0, count = 0;
        visit(pixel, reach, [&](int x, int y) {
            if (edges(x, y) == Edge::None) return;
            ++count;
            if (isAlike(x, y)) ++alike;
        });
        return static_cast<float>(alike) > part * static_cast<float>(count);
    };
    const auto isBlurred = [&](int x, int y) { return edges(x, y) == Edge::Blurred; };
    const auto isStrip = [&](int x, int y) { return strips(x, y) != 0; };
    const int foot = 1 + reach / kFootParts;
    Image<std::uint8_t> ramp(depth.width(), depth.height(), 0);
    for (int y = 0; y < depth.height(); ++y) {
        progress.checkpoint(1);
        for (int x = 0; x < depth.width(); ++x) {
            if (isStrip(x, y) && runsAlong({x, y}, kStripPart, isStrip))
                for (const Pixel& inwards : kNeighbors)
                    for (int k = outlines.stripWidth(x, y, inwards) - 1; k >= 0; --k)
                        depth(x + k * inwards.x, y + k * inwards.y) = 0;
            if (edges(x, y) != Edge::Flying && edges(x, y) != Edge::Blurred) continue;
            depth(x, y) = 0;
            if (edges(x, y) == Edge::Flying || !runsAlong({x, y}, kRampPart, isBlurred)) continue;
            visit({x, y}, reach, [&, &between = surfaces(x, y)](int u, int v) {
                if (between.share(measured(u, v)) > kRemovedShare) ramp(u, v) = 1;
            });
        }
    }
    // A map that was enlarged has its ramps drawn out: they go on as long as depth falls faster than relief does.
    const int drawnOut = enlarged ? reach : 0;
    std::vector<Pixel> front, next;
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            if (ramp(x, y) == 1) front.push_back({x, y});
    for (int k = 0; k < drawnOut && !front.empty(); ++k) {
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
    // What remains of a ramp is less than can be told from relief: the foot goes with the rest.
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            if (ramp(x, y) == 1) visit({x, y}, foot, [&](int u, int v) { depth(u, v) = 0; });
}

}  // namespace core::analysis
