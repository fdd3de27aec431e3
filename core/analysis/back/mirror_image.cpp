// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/mirror_image.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace core::analysis {
namespace {

/// Maximum depth difference [pixel widths] of neighbouring pixels of one surface.
constexpr float kMaxConnectedStep = 12;

/// A corner of a triangle of the mirror image, in pixels.
struct Vertex {
    float u = 0, v = 0;
    BackSample sample;
};

float edgeFunction(const Vertex& a, const Vertex& b, float u, float v) {
    return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

void drawTriangle(BackSamples& samples, const SegmentPixels& segment, const Vertex& a, const Vertex& b,
                  const Vertex& c) {
    const float area = edgeFunction(a, b, c.u, c.v);
    if (area == 0 || !std::isfinite(area)) return;
    const auto [lowU, highU] = std::minmax({a.u, b.u, c.u});
    const auto [lowV, highV] = std::minmax({a.v, b.v, c.v});
    const auto first = [](float low, int bound) {
        return static_cast<int>(std::max(std::ceil(low - 0.5f), static_cast<float>(bound)));
    };
    const auto last = [](float high, int bound) {
        return static_cast<int>(std::min(std::floor(high - 0.5f), static_cast<float>(bound)));
    };
    for (int y = first(lowV, segment.box.y0); y <= last(highV, segment.box.y1); ++y) {
        for (int x = first(lowU, segment.box.x0); x <= last(highU, segment.box.x1); ++x) {
            if (segment.labels(x, y) != segment.label) continue;
            const float u = static_cast<float>(x) + 0.5f;
            const float v = static_cast<float>(y) + 0.5f;
            const float ka = edgeFunction(b, c, u, v) / area;
            const float kb = edgeFunction(c, a, u, v) / area;
            const float kc = 1 - ka - kb;
            if (ka < 0 || kb < 0 || kc < 0) continue;
            const float w = ka * a.sample.w + kb * b.sample.w + kc * c.sample.w;
            BackSample& target = samples(x - segment.box.x0, y - segment.box.y0);
            if (target.w > 0 && target.w <= w) continue;
            target.w = w;
            target.normal = ka * a.sample.normal + kb * b.sample.normal + kc * c.sample.normal;
            target.color = ka * a.sample.color + kb * b.sample.color + kc * c.sample.color;
        }
    }
}

/// Means over the covered ones of 2×2 samples, without normals.
BackSamples halfSize(const BackSamples& fine) {
    BackSamples coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
    for (int y = 0; y < coarse.height(); ++y) {
        for (int x = 0; x < coarse.width(); ++x) {
            BackSample& sum = coarse(x, y);
            float count = 0;
            for (int k = 0; k < 4; ++k) {
                const int fx = 2 * x + (k & 1);
                const int fy = 2 * y + (k >> 1);
                if (!fine.contains(fx, fy) || fine(fx, fy).w <= 0) continue;
                sum.w += fine(fx, fy).w;
                sum.color += fine(fx, fy).color;
                ++count;
            }
            if (count == 0) continue;
            sum.w /= count;
            sum.color /= count;
        }
    }
    return coarse;
}

/// Bilinear interpolation between the covered ones of the coarse samples, at a sample of the next finer level.
BackSample interpolate(const BackSamples& coarse, int x, int y) {
    const float cx = 0.5f * (static_cast<float>(x) + 0.5f) - 0.5f;
    const float cy = 0.5f * (static_cast<float>(y) + 0.5f) - 0.5f;
    const int x0 = static_cast<int>(std::floor(cx));
    const int y0 = static_cast<int>(std::floor(cy));
    BackSample result;
    float weight = 0;
    for (int k = 0; k < 4; ++k) {
        const int sx = std::clamp(x0 + (k & 1), 0, coarse.width() - 1);
        const int sy = std::clamp(y0 + (k >> 1), 0, coarse.height() - 1);
        const BackSample& sample = coarse(sx, sy);
        if (sample.w <= 0) continue;
        const float kx = (k & 1) != 0 ? cx - static_cast<float>(x0) : 1 - cx + static_cast<float>(x0);
        const float ky = (k >> 1) != 0 ? cy - static_cast<float>(y0) : 1 - cy + static_cast<float>(y0);
        result.w += kx * ky * sample.w;
        result.color += kx * ky * sample.color;
        weight += kx * ky;
    }
    if (weight <= 0) return result;
    result.w /= weight;
    result.color /= weight;
    return result;
}

/// The mirror image of a pixel's point; nullopt behind the plane, or where it would come behind the camera.
std::optional<Vertex> mirroredVertex(const SegmentPixels& segment, const MirrorPlane& plane, Pixel pixel) {
    const auto& [x, y] = pixel;
    if (!segment.contains(x, y)) return std::nullopt;
    const Vector3f& p = segment.front.position(x, y);
    if (plane.normal.dot(p) > plane.offset) return std::nullopt;
    const Vector3f mirrored = plane.mirrored(p);
    if (mirrored.z() <= 1e-4f * p.z()) return std::nullopt;
    const Vector2f uv = segment.camera.project(mirrored);
    return Vertex{uv.x(),
                  uv.y(),
                  {1 / mirrored.z(), plane.mirroredDirection(segment.front.normal(x, y)), segment.front.color(x, y)}};
}

/// False if two neighbouring pixels are on either side of a discontinuity, and so not part of one surface.
bool areConnected(const SegmentPixels& segment, Pixel a, Pixel b) {
    const float za = segment.front.depth(a.x, a.y);
    const float zb = segment.front.depth(b.x, b.y);
    return std::abs(za - zb) < kMaxConnectedStep * std::min(za, zb) / std::min(segment.camera.fx, segment.camera.fy);
}

/// Draws the triangles whose topmost left pixel this is. A quad of four pixels is two of them; with three pixels it is
/// one, so that outlines are closed.
void drawQuad(BackSamples& image, const SegmentPixels& segment, const MirrorPlane& plane, Pixel pixel) {
    const Pixel right{pixel.x + 1, pixel.y};
    const Pixel below{pixel.x, pixel.y + 1};
    const Pixel across{pixel.x + 1, pixel.y + 1};
    const auto a = mirroredVertex(segment, plane, pixel);
    const auto b = mirroredVertex(segment, plane, right);
    const auto c = mirroredVertex(segment, plane, below);
    const auto d = mirroredVertex(segment, plane, across);
    const auto connected = [&](Pixel p, Pixel q) { return areConnected(segment, p, q); };
    if (b && c && connected(right, below)) {
        if (a && connected(pixel, right) && connected(pixel, below)) drawTriangle(image, segment, *a, *b, *c);
        if (d && connected(across, right) && connected(across, below)) drawTriangle(image, segment, *d, *b, *c);
    }
    if (a && d && connected(pixel, across)) {
        if (!c && b && connected(pixel, right) && connected(across, right)) drawTriangle(image, segment, *a, *b, *d);
        if (!b && c && connected(pixel, below) && connected(across, below)) drawTriangle(image, segment, *a, *c, *d);
    }
}

}  // namespace

BackSamples drawMirrorImage(const SegmentPixels& segment, const MirrorPlane& plane) {
    BackSamples image(segment.box.width(), segment.box.height());
    for (const Pixel& pixel : segment.pixels) drawQuad(image, segment, plane, pixel);
    return image;
}

std::size_t coveredCount(const BackSamples& samples) {
    return static_cast<std::size_t>(
        std::ranges::count_if(samples.pixels(), [](const BackSample& s) { return s.w > 0; }));
}

void closeGaps(BackSamples& samples) {
    if (std::ranges::all_of(samples.pixels(), [](const BackSample& s) { return s.w > 0; })) return;
    if (samples.width() == 1 && samples.height() == 1) return;
    BackSamples coarse = halfSize(samples);
    closeGaps(coarse);
    for (int y = 0; y < samples.height(); ++y)
        for (int x = 0; x < samples.width(); ++x)
            if (!(samples(x, y).w > 0)) samples(x, y) = interpolate(coarse, x, y);
}

}  // namespace core::analysis
