// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/silhouette.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace core {
namespace {

/// Mixed pixels outside the label [px]: optics and resampling spread an edge over more than one pixel.
constexpr int kOuterRings = 2;
/// Radius of the search for a clean colour [px].
constexpr int kSearchRadius = 4;
/// Relative difference of F and B below which the label decides.
constexpr float kMinContrast = 0.1f;
/// Relative difference from a pure colour caused by texture.
constexpr float kPureDifference = 0.03f;
/// Smallest share of either side in a mixed pixel.
constexpr float kMinShare = 1.0f / 64;
/// Radius and standard deviation of the labels' Gaussian mean [px].
constexpr int kLabelRadius = 4;
constexpr float kLabelSigma = 1.25f;

/// z for which a share `p` in (0, 1) of a normal distribution lies below z (Abramowitz and Stegun 26.2.23, error below
/// 4.5e-4).
float normalQuantile(float p) {
    const float t = std::sqrt(-2 * std::log(std::min(p, 1 - p)));
    const float z =
        t - (2.515517f + t * (0.802853f + t * 0.010328f)) / (1 + t * (1.432788f + t * (0.189269f + t * 0.001308f)));
    return p < 0.5f ? -z : z;
}

/// Share of a unit square within the half plane { q : n·q + d >= 0 }, |n| = 1, q from the square's centre.
float halfPlaneCoverage(const Vector2f& n, float d) {
    const float a = std::max(n.cwiseAbs().maxCoeff(), 1e-6f);
    const float b = n.cwiseAbs().minCoeff();
    const auto ramp = [a](float t) { return std::clamp(t / a + 0.5f, 0.0f, 1.0f); };
    if (b < 1e-3f) return ramp(d);
    // Mean of the ramp over [d − b/2, d + b/2].
    const auto integral = [&](float t) { return a * ramp(t) * ramp(t) / 2 + std::max(t - a / 2, 0.0f); };
    return (integral(d + b / 2) - integral(d - b / 2)) / b;
}

class Outline {
  public:
    Outline(const LabelImage& labels, const ImageF& depth, std::uint16_t label)
        : labels_(labels), depth_(depth), label_(label) {}

    [[nodiscard]] bool inside(int x, int y) const { return labels_(x, y) == label_ && depth_(x, y) > 0; }

    /// True when all pixels within `radius` (in the picture) are on side `wanted`.
    [[nodiscard]] bool clean(int x, int y, int radius, bool wanted) const {
        for (int v = std::max(y - radius, 0); v <= std::min(y + radius, labels_.height() - 1); ++v)
            for (int u = std::max(x - radius, 0); u <= std::min(x + radius, labels_.width() - 1); ++u)
                if (inside(u, v) != wanted) return false;
        return true;
    }

    /// Nearest pixel that is clean within `radius`.
    [[nodiscard]] std::optional<Eigen::Vector2i> nearestClean(int x, int y, int radius, bool wanted) const {
        std::optional<Eigen::Vector2i> best;
        int bestDistance = (kSearchRadius + 1) * (kSearchRadius + 1);
        aroundIt(x, y, [&](int u, int v) {
            const int distance = (u - x) * (u - x) + (v - y) * (v - y);
            if (distance >= bestDistance || !clean(u, v, radius, wanted)) return;
            best = Eigen::Vector2i(u, v);
            bestDistance = distance;
        });
        return best;
    }

    /// Squared distance of pixel (x, y)'s colour to the most similar clean one around it.
    [[nodiscard]] float distanceToPure(const ImageRgb& photo, int x, int y, int radius, bool wanted) const {
        float least = std::numeric_limits<float>::infinity();
        aroundIt(x, y, [&](int u, int v) {
            const float distance = (photo(u, v) - photo(x, y)).squaredNorm();
            if (distance < least && clean(u, v, radius, wanted)) least = distance;
        });
        return least;
    }

    /// Share of pixel (x, y) inside a straight edge with the same Gaussian mean of labels around it.
    [[nodiscard]] float coverage(int x, int y) const {
        float weights = 0;
        float sum = 0;
        Vector2f gradient = Vector2f::Zero();
        for (int j = -kLabelRadius; j <= kLabelRadius; ++j)
            for (int i = -kLabelRadius; i <= kLabelRadius; ++i) {
                if (!labels_.contains(x + i, y + j)) continue;
                const Vector2f q(static_cast<float>(i), static_cast<float>(j));
                const float weight = std::exp(-q.squaredNorm() / (2 * kLabelSigma * kLabelSigma));
                weights += weight;
                if (!inside(x + i, y + j)) continue;
                sum += weight;
                gradient += weight * q;
            }
        const float mean = sum / weights;
        if (!(mean > 0 && mean < 1) || gradient.isZero()) return mean;
        return halfPlaneCoverage(gradient.normalized(), kLabelSigma * normalQuantile(mean));
    }

    /// The smallest rectangle with all of the segment; empty when there is none.
    [[nodiscard]] Eigen::AlignedBox2i bounds() const {
        Eigen::AlignedBox2i box;
        for (int y = 0; y < labels_.height(); ++y)
            for (int x = 0; x < labels_.width(); ++x)
                if (labels_(x, y) == label_) box.extend(Eigen::Vector2i(x, y));
        return box;
    }

  private:
    template <class Visit>
    void aroundIt(int x, int y, const Visit& visit) const {
        for (int v = std::max(y - kSearchRadius, 0); v <= std::min(y + kSearchRadius, labels_.height() - 1); ++v)
            for (int u = std::max(x - kSearchRadius, 0); u <= std::min(x + kSearchRadius, labels_.width() - 1); ++u)
                visit(u, v);
    }

    const LabelImage& labels_;
    const ImageF& depth_;
    std::uint16_t label_;
};

/// a of C = a F + (1 − a) B, drawn towards `expected` where the colours are inconclusive, or where a pure colour at
/// `pureDistance` (squared) explains C as well.
float mixture(const Vector3f& c, const Vector3f& f, const Vector3f& b, float expected, float pureDistance) {
    const Vector3f difference = f - b;
    const float contrast = difference.squaredNorm();
    const float doubt = kMinContrast * kMinContrast * (f.squaredNorm() + b.squaredNorm());
    if (!(contrast > 0)) return expected;
    const float fitted = std::clamp((c - b).dot(difference) / contrast, 0.0f, 1.0f);
    const float residual = (c - b - fitted * difference).squaredNorm();
    const float ratio = (doubt + 4 * residual) / contrast;
    const float pure = kPureDifference * kPureDifference * (f.squaredNorm() + b.squaredNorm());
    return expected + (fitted - expected) * pureDistance / (pureDistance + pure) / (1 + ratio * ratio);
}

/// Pixel (x, y) as a mixed pixel; nullopt when it is pure, or when one side has no clean colour nearby.
std::optional<SilhouettePixel> mixedPixel(const ImageRgb& photo, const Outline& outline, int x, int y,
                                          CoverageFrom from) {
    const bool inside = outline.inside(x, y);
    const int rings = inside ? 1 : kOuterRings;
    if (outline.clean(x, y, rings, inside)) return std::nullopt;
    auto inner = outline.nearestClean(x, y, 2, true);
    if (!inner) inner = outline.nearestClean(x, y, 1, true);
    const auto outer = outline.nearestClean(x, y, kOuterRings, false);
    if (!inner || !outer) return std::nullopt;
    const Vector3f& c = photo(x, y);
    const Vector3f& f = photo(inner->x(), inner->y());
    const Vector3f& b = photo(outer->x(), outer->y());
    const float a = from == CoverageFrom::Labels
                        ? outline.coverage(x, y)
                        : mixture(c, f, b, inside ? 1.0f : 0.0f, outline.distanceToPure(photo, x, y, rings, inside));
    if (inside ? a > 1 - kMinShare : a < kMinShare) return std::nullopt;
    const Vector3f background = (1 - a) * b;
    if (inside) return SilhouettePixel{x, y, x, y, a, background, (1 - a) * (c - b)};
    if (from == CoverageFrom::Labels)
        return SilhouettePixel{x, y, inner->x(), inner->y(), a, background, c - a * f - background};
    return SilhouettePixel{x, y, inner->x(), inner->y(), a, (c - a * f).cwiseMax(0.0f), Vector3f::Zero()};
}

}  // namespace

std::vector<SilhouettePixel> findSilhouette(const ImageRgb& photo, const LabelImage& labels, const ImageF& depth,
                                            std::uint16_t label, const std::vector<std::uint8_t>& edited,
                                            CoverageFrom from) {
    CORE_ASSERT(photo.sameSize(labels) && depth.sameSize(labels), "images of one size");
    const Outline outline(labels, depth, label);
    std::vector<SilhouettePixel> result;
    const Eigen::AlignedBox2i box = outline.bounds();
    if (box.isEmpty()) return result;
    for (int y = std::max(box.min().y() - kOuterRings, 0);
         y <= std::min(box.max().y() + kOuterRings, labels.height() - 1); ++y) {
        for (int x = std::max(box.min().x() - kOuterRings, 0);
             x <= std::min(box.max().x() + kOuterRings, labels.width() - 1); ++x) {
            const std::uint16_t other = labels(x, y);
            if (!outline.inside(x, y) && (other == label || (other < edited.size() && edited[other] != 0))) continue;
            if (const auto mixed = mixedPixel(photo, outline, x, y, from)) result.push_back(*mixed);
        }
    }
    return result;
}

}  // namespace core
