// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/selection_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/statistics.h"

namespace core {

namespace {

/// Range of a and b that PackedLab holds.
constexpr float kChromaRange = 0.4f;
/// Every nth pixel of the photograph measures its exposure, and the noise of its depth.
constexpr int kSampleStep = 5;
/// Relative error of 1/z that even exact depth is granted.
constexpr float kExactDepth = 0.0008f;
/// Largest distance over which slopes are measured [working px].
constexpr int kMaxSpan = 6;

/// Radiance that becomes white.
float whiteLevel(const ImageRgb& color) {
    std::vector<float> values;
    for (std::size_t i = 0; i < color.size(); i += kSampleStep) values.push_back(color[i].maxCoeff());
    if (values.empty()) return 1;
    const float level = quantile(values, 0.99);
    return level > 0 && std::isfinite(level) ? level : 1.0f;
}

/// Mean colour, and depth of the middle pixel, of each block of `factor`² pixels.
void fillRow(const SelectionInput& input, float exposure, int y, SelectionPicture& picture, Image<PackedLab>& packed) {
    const int factor = picture.factor;
    const int height = input.color.height();
    const int width = input.color.width();
    for (int py = y * factor; py < std::min((y + 1) * factor, height); ++py)
        for (int px = 0; px < width; ++px)
            packed(px, py) = packLab(okLab((input.color(px, py) * exposure).cwiseMin(1.0f).cwiseMax(0.0f)));
    for (int x = 0; x < picture.lab.width(); ++x) {
        Vector3f sum = Vector3f::Zero();
        int count = 0;
        for (int py = y * factor; py < std::min((y + 1) * factor, height); ++py)
            for (int px = x * factor; px < std::min((x + 1) * factor, width); ++px, ++count)
                sum += unpackLab(packed(px, py));
        picture.lab(x, y) = sum / static_cast<float>(count);
        if (input.depth.empty()) continue;
        const float z =
            input.depth(std::min(x * factor + factor / 2, width - 1), std::min(y * factor + factor / 2, height - 1));
        picture.inverseDepth(x, y) = z > 0 && std::isfinite(z) ? 1 / z : 0.0f;
    }
}

/// Typical relative second difference of 1/z over `span` pixels; 0 without depth.
float secondDifference(const ImageF& w, int span) {
    std::vector<float> values;
    for (int y = 0; y < w.height(); y += kSampleStep)
        for (int x = span; x + span < w.width(); x += kSampleStep) {
            const float middle = w(x, y);
            if (!(middle > 0) || !(w(x - span, y) > 0) || !(w(x + span, y) > 0)) continue;
            values.push_back(std::abs(w(x - span, y) + w(x + span, y) - 2 * middle) / middle);
        }
    return values.empty() ? 0.0f : quantile(values, 0.6);
}

DepthQuality measureQuality(const ImageF& w, float sampleSpacing) {
    DepthQuality quality;
    for (const float value : w.pixels()) quality.present = quality.present || value > 0;
    if (!quality.present) return quality;
    const float spacing = std::max(1.0f, sampleSpacing);
    quality.span = std::clamp(static_cast<int>(std::ceil(0.6f * spacing)), 1, kMaxSpan);
    quality.noise = kExactDepth + secondDifference(w, quality.span);
    // A slope over s pixels has the error noise / s; a few percent per ten pixels are wanted.
    while (quality.span < kMaxSpan && quality.noise > 0.0015f * static_cast<float>(quality.span)) ++quality.span;
    return quality;
}

/// Slope of 1/z per pixel from both sides; the flatter side where a surface ends in between.
float slope(float before, float middle, float after, float span, float jump) {
    const bool hasBefore = before > 0;
    const bool hasAfter = after > 0;
    const float left = (middle - before) / span;
    const float right = (after - middle) / span;
    if (!hasBefore && !hasAfter) return 0;
    if (!hasBefore) return std::abs(right) * span > jump ? 0.0f : right;
    if (!hasAfter) return std::abs(left) * span > jump ? 0.0f : left;
    if (std::abs(left - right) * span < jump) return 0.5f * (left + right);
    return std::abs(left) < std::abs(right) ? left : right;
}

/// Unit normal of the plane w = 1/z seen at (x, y): 1/z is linear in the picture where a surface is flat.
Vector3f normalAt(const SelectionPicture& picture, int x, int y) {
    const ImageF& w = picture.inverseDepth;
    const float middle = w(x, y);
    if (!(middle > 0)) return Vector3f::Zero();
    const int span = picture.quality.span;
    const auto at = [&](int px, int py) { return w.contains(px, py) ? w(px, py) : 0.0f; };
    const auto length = static_cast<float>(span);
    const float jump = middle * (0.01f + 4 * picture.quality.noise) * length;
    const float gx = slope(at(x - span, y), middle, at(x + span, y), length, jump) * picture.camera.fx;
    const float gy = slope(at(x, y - span), middle, at(x, y + span), length, jump) * picture.camera.fy;
    const Vector3f ray = picture.camera.pixelRay(x, y);
    return -Vector3f(gx, gy, middle - gx * ray.x() - gy * ray.y()).normalized();
}

/// Mean of the normals within `radius` along one axis, of those on the same surface.
ImageV3 smoothNormals(const SelectionPicture& picture, int radius, bool vertical, const Progress& progress) {
    const ImageV3& normal = picture.normal;
    const ImageF& w = picture.inverseDepth;
    ImageV3 result(normal.width(), normal.height());
    parallelFor(progress, normal.height(), [&](int y) {
        for (int x = 0; x < normal.width(); ++x) {
            if (!(w(x, y) > 0)) continue;
            Vector3f sum = Vector3f::Zero();
            for (int k = -radius; k <= radius; ++k) {
                const int px = vertical ? x : x + k;
                const int py = vertical ? y + k : y;
                if (!w.contains(px, py) || !(w(px, py) > 0)) continue;
                const float jump = std::abs(w(px, py) - w(x, y)) / w(x, y);
                if (jump < 0.02f * static_cast<float>(radius) + 4 * picture.quality.noise) sum += normal(px, py);
            }
            const float length = sum.norm();
            result(x, y) = length > 0 ? Vector3f(sum / length) : normal(x, y);
        }
    });
    return result;
}

}  // namespace

Vector3f okLab(const Vector3f& c) {
    const float l = std::cbrt(0.4122214708f * c.x() + 0.5363325363f * c.y() + 0.0514459929f * c.z());
    const float m = std::cbrt(0.2119034982f * c.x() + 0.6806995451f * c.y() + 0.1073969566f * c.z());
    const float s = std::cbrt(0.0883024619f * c.x() + 0.2817188376f * c.y() + 0.6299787005f * c.z());
    return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
            1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
            0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

PackedLab packLab(const Vector3f& lab) {
    const auto pack = [](float value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f); };
    return {pack(lab.x()), pack(0.5f + 0.5f * lab.y() / kChromaRange), pack(0.5f + 0.5f * lab.z() / kChromaRange)};
}

Vector3f unpackLab(const PackedLab& packed) {
    const auto chroma = [](std::uint8_t value) { return (static_cast<float>(value) / 127.5f - 1) * kChromaRange; };
    return {static_cast<float>(packed[0]) / 255, chroma(packed[1]), chroma(packed[2])};
}

SelectionPicture makeSelectionPicture(const SelectionInput& input, Image<PackedLab>& packed, const Progress& progress) {
    SelectionPicture picture;
    const int width = input.color.width();
    const int height = input.color.height();
    while (static_cast<long>(width / picture.factor) * (height / picture.factor) > kMaxWorkingPixels) ++picture.factor;
    const int factor = picture.factor;
    const int w = (width + factor - 1) / factor;
    const int h = (height + factor - 1) / factor;
    const float scale = 1 / static_cast<float>(factor);
    picture.camera = input.camera;
    picture.camera.width = w, picture.camera.height = h;
    picture.camera.fx *= scale, picture.camera.fy *= scale, picture.camera.cx *= scale, picture.camera.cy *= scale;
    picture.lab = ImageV3(w, h);
    picture.inverseDepth = ImageF(w, h);
    packed = Image<PackedLab>(width, height);
    const float exposure = 1 / whiteLevel(input.color);
    parallelFor(progress.part(0, 0.5f), h, [&](int y) { fillRow(input, exposure, y, picture, packed); });
    picture.quality = measureQuality(picture.inverseDepth, input.depthSampleSpacing * scale);
    picture.normal = ImageV3(w, h);
    if (!picture.quality.present) return picture;
    parallelFor(progress.part(0.5f, 0.7f), h, [&](int y) {
        for (int x = 0; x < w; ++x) picture.normal(x, y) = normalAt(picture, x, y);
    });
    const int radius = picture.quality.span;
    picture.normal = smoothNormals(picture, radius, false, progress.part(0.7f, 0.85f));
    picture.normal = smoothNormals(picture, radius, true, progress.part(0.85f, 1.0f));
    return picture;
}

}  // namespace core
