// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/mirror_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/depth/distant_pixels.h"
#include "core/analysis/light/directional_accumulator.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

constexpr int kIncidentRays = 1 << 16;
/// More traced pixels of a segment would not be visible in the maps.
constexpr std::size_t kMaxTracedPixels = 400000;
/// Codes just below the largest one count as clipped too: sharpening and compression leave clipped pixels there.
constexpr float kClipMargin = 0.98f;
/// Minimum cosine between view and normal. Below it a mirrored direction depends more on the error of the normal than
/// on the normal.
constexpr float kMinCosine = 0.08f;
/// Rays handled between two checkpoints.
constexpr std::size_t kRaysPerChunk = 512;

template <class Visit>
void forEachRay(std::size_t count, const Progress& progress, const Visit& visit) {
    parallelFor(progress, static_cast<int>((count + kRaysPerChunk - 1) / kRaysPerChunk), [&](int chunk) {
        const std::size_t first = static_cast<std::size_t>(chunk) * kRaysPerChunk;
        for (std::size_t i = first; i < std::min(count, first + kRaysPerChunk); ++i) visit(i);
    });
}

std::optional<Vector3f> mirroredDirection(const Surface& front, int x, int y) {
    const Vector3f& n = front.normal(x, y);
    const Vector3f view = front.position(x, y).normalized();
    const float cosine = -view.dot(n);
    if (cosine < kMinCosine) return std::nullopt;
    return (view + 2 * cosine * n).normalized();
}

/// Confidence in the texel a mirrored ray points into: low where the rays of neighbouring pixels diverge.
float sharpnessOf(const ReflectanceInput& in, const Mirror& mirror) {
    const LabelImage& labels = in.scene.photo->labels;
    float spread = 0;
    for (const Pixel& step : kNeighbors) {
        const int x = mirror.x + step.x;
        const int y = mirror.y + step.y;
        if (!labels.contains(x, y) || labels(x, y) != in.label || in.front.depth(x, y) <= 0) continue;
        const auto direction = mirroredDirection(in.front, x, y);
        spread = std::max(spread, direction ? (*direction - mirror.direction).norm() : 1.0f);
    }
    const float texels = 0.5f * spread / texelAngle(in.rows);
    return 1 / (1 + texels * texels);
}

/// Direction i of `count`, uniform on the sphere (spherical Fibonacci points).
Vector3f fibonacciDirection(int i, int count) {
    const double y = 1 - (2.0 * i + 1) / count;
    const double phi = 2 * std::numbers::pi * std::fmod(i * (std::numbers::phi - 1), 1.0);
    const double radius = std::sqrt(1 - y * y);
    return {static_cast<float>(radius * std::cos(phi)), static_cast<float>(y),
            static_cast<float>(radius * std::sin(phi))};
}

}  // namespace

unsigned clippedChannels(const Photo& photo, int x, int y) {
    const float level = kClipMargin * photo.clipLevel;
    unsigned bits = 0;
    for (int c = 0; c < 3; ++c)
        if (photo.color(x, y)[c] >= level) bits |= 1u << c;
    return bits;
}

bool isInterior(const LabelImage& labels, const ImageF& depth, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (labels.contains(x + dx, y + dy) &&
                (labels(x + dx, y + dy) != labels(x, y) || depth(x + dx, y + dy) <= 0))
                return false;
    return true;
}

RayEnd endOf(const ReflectanceInput& in, const MarchRay& ray, const std::optional<MarchHit>& hit) {
    using Kind = RayEnd::Kind;
    const Photo& photo = *in.scene.photo;
    if (!hit) {
        if (const auto color = distantColor(photo, in.distant, ray.direction))
            return {Kind::Distant, ray.direction, *color};
        const bool met = in.continued.meets(ray.origin, ray.direction);
        return {met ? Kind::OverSupport : Kind::Missed, ray.direction, Vector3f::Zero()};
    }
    const std::uint16_t label = photo.labels(hit->x, hit->y);
    if (label == in.label) return {Kind::Itself, ray.direction, Vector3f::Zero()};
    if (hit->back) return {Kind::Guessed, ray.direction, in.back.color(hit->x, hit->y)};
    const bool known = !in.glossy[label] && isInterior(photo.labels, in.front.depth, hit->x, hit->y);
    return {known ? Kind::Known : Kind::Guessed, ray.direction, in.front.color(hit->x, hit->y)};
}

TracedPixels tracedPixels(const ReflectanceInput& in) {
    const LabelImage& labels = in.scene.photo->labels;
    TracedPixels result;
    std::vector<Pixel> all;
    std::vector<Pixel> interior;
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            if (labels(x, y) != in.label || in.front.depth(x, y) <= 0) continue;
            all.push_back({x, y});
            result.center += 0.5 * (in.front.position(x, y) + in.back.position(x, y)).cast<double>();
            if (isInterior(labels, in.front.depth, x, y)) interior.push_back({x, y});
        }
    }
    if (all.empty()) return result;
    result.segmentSize = all.size();
    result.center /= static_cast<double>(all.size());
    // Outlines mix two objects; a segment that is nothing but outline is used whole.
    const auto& used = interior.empty() ? all : interior;
    const std::size_t stride = used.size() / kMaxTracedPixels + 1;
    result.complete = stride == 1;
    for (std::size_t i = 0; i < used.size() / stride; ++i) result.pixels.push_back(used[i * stride]);
    return result;
}

std::vector<Mirror> traceMirrors(const ReflectanceInput& in, const TracedPixels& pixels, const Progress& progress) {
    std::vector<Mirror> mirrors(pixels.pixels.size());
    std::vector<MarchRay> rays(mirrors.size());
    forEachRay(mirrors.size(), progress.part(0, 0.1f), [&](std::size_t i) {
        Mirror& mirror = mirrors[i];
        mirror.x = pixels.pixels[i].x;
        mirror.y = pixels.pixels[i].y;
        const auto direction = mirroredDirection(in.front, mirror.x, mirror.y);
        if (!direction) return;
        mirror.direction = *direction;
        const Vector3f& p = in.front.position(mirror.x, mirror.y);
        mirror.origin = p + marchBias(in.scene.photo->camera, p.z()) * in.front.normal(mirror.x, mirror.y);
        rays[i] = {mirror.origin, mirror.direction};
    });
    const auto hits = in.marcher.march(rays, 0, progress.part(0.1f, 0.9f));
    forEachRay(mirrors.size(), progress.part(0.9f, 1), [&](std::size_t i) {
        Mirror& mirror = mirrors[i];
        if (mirror.direction.isZero(0)) return;
        mirror.end = endOf(in, rays[i], hits[i]);
        mirror.sharpness = sharpnessOf(in, mirror);
    });
    return mirrors;
}

std::vector<RayEnd> traceFromCenter(const ReflectanceInput& in, const TracedPixels& pixels, const Progress& progress) {
    if (pixels.segmentSize == 0) return {};
    std::vector<MarchRay> rays;
    for (int i = 0; i < kIncidentRays; ++i)
        rays.push_back({pixels.center.cast<float>(), fibonacciDirection(i, kIncidentRays)});
    const auto hits = in.marcher.march(rays, in.label, progress.part(0, 0.9f));
    std::vector<RayEnd> ends(rays.size());
    forEachRay(rays.size(), progress.part(0.9f, 1), [&](std::size_t i) { ends[i] = endOf(in, rays[i], hits[i]); });
    return ends;
}

}  // namespace core::analysis
