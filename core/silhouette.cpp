// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

namespace core {
namespace {

constexpr int kOuterRings = 2;            // optics and resampling spread an edge further than one pixel
constexpr int kSearchRadius = 4;          // for a clean colour [px]
constexpr float kLeastContrast = 0.1f;    // relative difference of F and B below which the label is believed instead
constexpr float kPureDifference = 0.03f;  // relative difference from a pure colour that texture makes
constexpr float kLeastShare = 1.0f / 64;

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

/// a of C = a F + (1 − a) B, drawn towards `expected` where the colours do not tell, or where a pure colour at
/// `pureDistance` (squared) explains C as well.
float mixture(const Vector3f& c, const Vector3f& f, const Vector3f& b, float expected, float pureDistance) {
    const Vector3f difference = f - b;
    const float contrast = difference.squaredNorm();
    const float doubt = kLeastContrast * kLeastContrast * (f.squaredNorm() + b.squaredNorm());
    if (!(contrast > 0)) return expected;
    const float fitted = std::clamp((c - b).dot(difference) / contrast, 0.0f, 1.0f);
    const float residual = (c - b - fitted * difference).squaredNorm();
    const float ratio = (doubt + 4 * residual) / contrast;
    const float pure = kPureDifference * kPureDifference * (f.squaredNorm() + b.squaredNorm());
    return expected + (fitted - expected) * pureDistance / (pureDistance + pure) / (1 + ratio * ratio);
}

}  // namespace

std::vector<SilhouettePixel> findSilhouette(const ImageRgb& photo, const LabelImage& labels, const ImageF& depth,
                                            std::uint16_t label, const std::vector<std::uint8_t>& edited) {
    CORE_ASSERT(photo.sameSize(labels) && depth.sameSize(labels), "images of one size");
    const Outline outline(labels, depth, label);
    std::vector<SilhouettePixel> result;
    const Eigen::AlignedBox2i box = outline.bounds();
    if (box.isEmpty()) return result;
    for (int y = std::max(box.min().y() - kOuterRings, 0);
         y <= std::min(box.max().y() + kOuterRings, labels.height() - 1); ++y) {
        for (int x = std::max(box.min().x() - kOuterRings, 0);
             x <= std::min(box.max().x() + kOuterRings, labels.width() - 1); ++x) {
            const bool inside = outline.inside(x, y);
            const std::uint16_t other = labels(x, y);
            if (!inside && (other == label || (other < edited.size() && edited[other] != 0))) continue;
            if (outline.clean(x, y, inside ? 1 : kOuterRings, inside)) continue;
            auto inner = outline.nearestClean(x, y, 2, true);
            if (!inner) inner = outline.nearestClean(x, y, 1, true);
            const auto outer = outline.nearestClean(x, y, kOuterRings, false);
            if (!inner || !outer) continue;
            const Vector3f& c = photo(x, y);
            const Vector3f& f = photo(inner->x(), inner->y());
            const Vector3f& b = photo(outer->x(), outer->y());
            const float a = mixture(c, f, b, inside ? 1.0f : 0.0f,
                                    outline.distanceToPure(photo, x, y, inside ? 1 : kOuterRings, inside));
            if (inside ? a > 1 - kLeastShare : a < kLeastShare) continue;
            if (inside)
                result.push_back({x, y, x, y, a, (1 - a) * b, (1 - a) * (c - b)});
            else
                result.push_back({x, y, inner->x(), inner->y(), a, (c - a * f).cwiseMax(0.0f), Vector3f::Zero()});
        }
    }
    return result;
}

}  // namespace core
