// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/upsample_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/analysis/depth/plane_fit.h"
#include "core/base/parallel.h"

namespace core {
namespace {

/// Relative difference between neighbours from which there is an edge rather than a slope.
constexpr float kJump = 0.03f;
// Fractions of the range of inverse depths at an edge.
/// Values closer than this to one end belong to the surface there.
constexpr float kSideShare = 0.15f;
/// Distance from an end at which a weight is half, since the pixel may be mixed of both surfaces.
constexpr float kMixedShare = 0.03f;
/// Distance of display-encoded colours at which a weight is a quarter.
constexpr float kColorRange = 0.12f;
/// [pixels of the map]
constexpr float kSpatialSigma = 0.8f;
/// Half-width of the window at edges [pixels of the map].
constexpr int kRadius = 2;

/// Fraction of the time that averaging the colours takes.
constexpr float kAveraging = 0.1f;

/// Display encoding, accurate enough for weights.
Vector3f encoded(const Vector3f& color) { return color.cwiseMax(0.0f).cwiseMin(1.0f).cwiseSqrt(); }

/// Mean encoded colour of the photograph's pixels that every pixel of the map covers.
ImageRgb averageColors(const ImageRgb& guide, int width, int height, const Progress& progress) {
    ImageRgb result(width, height);
    parallelFor(progress, height, [&](int j) {
        const int y0 = static_cast<int>(static_cast<long>(j) * guide.height() / height);
        const int y1 = std::max(y0 + 1, static_cast<int>(static_cast<long>(j + 1) * guide.height() / height));
        for (int i = 0; i < width; ++i) {
            const int x0 = static_cast<int>(static_cast<long>(i) * guide.width() / width);
            const int x1 = std::max(x0 + 1, static_cast<int>(static_cast<long>(i + 1) * guide.width() / width));
            Vector3f sum = Vector3f::Zero();
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) sum += encoded(guide(x, y));
            result(i, j) = sum / static_cast<float>((x1 - x0) * (y1 - y0));
        }
    });
    return result;
}

/// Pixels of the map whose surroundings (one pixel) are one continuous surface.
Image<std::uint8_t> findContinuous(const ImageF& w) {
    Image<std::uint8_t> result(w.width(), w.height(), 0);
    for (int y = 1; y + 1 < w.height(); ++y) {
        for (int x = 1; x + 1 < w.width(); ++x) {
            const float limit = kJump * w(x, y);
            bool same = w(x, y) > 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    same = same && w(x + dx, y + dy) > 0 && std::abs(w(x + dx, y + dy) - w(x, y)) <= limit;
            result(x, y) = same ? 1 : 0;
        }
    }
    return result;
}

std::array<float, 4> splineWeights(float t) {
    const float s = 1 - t;
    return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6};
}

/// Valid pixels of the map in a window.
struct EdgeWindow {
    static constexpr int kTaps = (2 * kRadius + 1) * (2 * kRadius + 1);
    float values[kTaps], weights[kTaps], us[kTaps], vs[kTaps];
    int count = 0;
    float low = 0, high = 0;  ///< range of the values
    float invalid = 0;        ///< weight of the other pixels
    float jump = 0;           ///< largest relative difference of neighbours

    void add(float value, float weight, float u, float v) {
        low = count == 0 ? value : std::min(low, value);
        high = std::max(high, value);
        values[count] = value;
        weights[count] = weight;
        us[count] = u;
        vs[count] = v;
        ++count;
    }
};

/// Range of the inverse depths of one surface.
struct SurfaceRange {
    float from, to;
};

/// The surface in a window with the most weight; nullopt when pixels without depth have more. At an edge there are two,
/// and pixels between them, which are mixed of both, lose their weight.
std::optional<SurfaceRange> chooseSurface(EdgeWindow& window) {
    const float range = window.high - window.low;
    const bool edge = window.jump > kJump;
    float near = 0, far = 0;
    for (int k = 0; k < window.count && edge; ++k) {
        const float toHigh = window.high - window.values[k];
        const float toLow = window.values[k] - window.low;
        const float share = std::min(toHigh, toLow) / range;
        if (share > kSideShare) window.weights[k] = 0;
        window.weights[k] /= 1 + share * share / (kMixedShare * kMixedShare);
        (toHigh < toLow ? near : far) += window.weights[k];
    }
    for (int k = 0; k < window.count && !edge; ++k) near += window.weights[k];
    if (window.count == 0 || window.invalid > near + far) return std::nullopt;
    if (!edge) return SurfaceRange{window.low, window.high};
    if (near >= far) return SurfaceRange{window.high - kSideShare * range, window.high};
    return SurfaceRange{window.low, window.low + kSideShare * range};
}

/// Value at the centre of the weighted plane through a surface's pixels; 0 when they have no weight.
float planeThrough(const EdgeWindow& window, const SurfaceRange& surface) {
    const auto [from, to] = surface;
    analysis::PlaneMoments<float> moments;
    float least = to, most = from;
    for (int k = 0; k < window.count; ++k) {
        const float value = window.values[k];
        if (value < from || value > to) continue;
        moments.add(window.us[k], window.vs[k], value - from, window.weights[k]);
        least = std::min(least, value);
        most = std::max(most, value);
    }
    const auto plane = moments.solve(1e-4f);
    if (!plane) return 0;
    const float margin = 0.5f * (most - least);
    return std::clamp(from + plane->value, std::max(least - margin, 0.5f * least), most + margin);
}

struct Upsampler {
    ImageF inverse;  ///< [1/m] inverse depth of the map, 0 = invalid
    Image<std::uint8_t> continuous;
    ImageRgb colors;  ///< mean colours behind the map's pixels; empty without a guide

    /// Cubic B-spline about map coordinates (u, v); valid only where the four pixels around are continuous.
    [[nodiscard]] float spline(int i, int j, float fu, float fv) const {
        const auto wu = splineWeights(fu);
        const auto wv = splineWeights(fv);
        float sum = 0;
        for (int dy = 0; dy < 4; ++dy) {
            const float* row = &inverse(i - 1, j - 1 + dy);
            sum +=
                wv[static_cast<std::size_t>(dy)] * (wu[0] * row[0] + wu[1] * row[1] + wu[2] * row[2] + wu[3] * row[3]);
        }
        return sum;
    }

    /// Joint bilateral choice among the surfaces in the window, and the chosen one's plane at (u, v).
    [[nodiscard]] float atEdge(float u, float v, const Vector3f& color) const {
        EdgeWindow window = windowAbout(u, v, color);
        const auto surface = chooseSurface(window);
        return surface ? planeThrough(window, *surface) : 0.0f;
    }

  private:
    [[nodiscard]] EdgeWindow windowAbout(float u, float v, const Vector3f& color) const {
        const int ci = std::clamp(static_cast<int>(std::lround(u)), 0, inverse.width() - 1);
        const int cj = std::clamp(static_cast<int>(std::lround(v)), 0, inverse.height() - 1);
        EdgeWindow window;
        for (int j = std::max(cj - kRadius, 0); j <= std::min(cj + kRadius, inverse.height() - 1); ++j) {
            for (int i = std::max(ci - kRadius, 0); i <= std::min(ci + kRadius, inverse.width() - 1); ++i) {
                const float du = static_cast<float>(i) - u;
                const float dv = static_cast<float>(j) - v;
                float weight = std::exp(-(du * du + dv * dv) / (2 * kSpatialSigma * kSpatialSigma));
                if (!colors.empty()) {
                    const float t = 1 + (colors(i, j) - color).squaredNorm() / (kColorRange * kColorRange);
                    weight /= t * t;
                }
                const float value = inverse(i, j);
                if (value <= 0) {
                    window.invalid += weight;
                    continue;
                }
                for (const float other : {i > 0 ? inverse(i - 1, j) : 0.0f, j > 0 ? inverse(i, j - 1) : 0.0f})
                    window.jump = std::max(window.jump, other > 0 ? std::abs(value - other) / value : 0.0f);
                window.add(value, weight, du, dv);
            }
        }
        return window;
    }
};

}  // namespace

ImageF upsampleDepth(const ImageF& depth, int width, int height, const ImageRgb* guide, const Progress& progress) {
    if (depth.width() == width && depth.height() == height) return depth;
    Upsampler map;
    map.inverse = ImageF(depth.width(), depth.height());
    for (std::size_t i = 0; i < depth.size(); ++i) map.inverse[i] = depth[i] > 0 ? 1 / depth[i] : 0.0f;
    map.continuous = findContinuous(map.inverse);
    if (guide != nullptr)
        map.colors = averageColors(*guide, depth.width(), depth.height(), progress.part(0, kAveraging));

    ImageF result(width, height);
    const float scaleX = static_cast<float>(depth.width()) / static_cast<float>(width);
    const float scaleY = static_cast<float>(depth.height()) / static_cast<float>(height);
    parallelFor(progress.part(kAveraging, 1), height, [&](int y) {
        const float v = (static_cast<float>(y) + 0.5f) * scaleY - 0.5f;
        const int j = static_cast<int>(std::floor(v));
        for (int x = 0; x < width; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) * scaleX - 0.5f;
            const int i = static_cast<int>(std::floor(u));
            const bool smooth = map.continuous.contains(i, j) && map.continuous.contains(i + 1, j + 1) &&
                                map.continuous(i, j) != 0 && map.continuous(i + 1, j) != 0 &&
                                map.continuous(i, j + 1) != 0 && map.continuous(i + 1, j + 1) != 0;
            const float w = smooth ? map.spline(i, j, u - static_cast<float>(i), v - static_cast<float>(j))
                                   : map.atEdge(u, v, guide == nullptr ? Vector3f(0, 0, 0) : encoded((*guide)(x, y)));
            if (w > 0) result(x, y) = 1 / w;
        }
    });
    return result;
}

}  // namespace core
