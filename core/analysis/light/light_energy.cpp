// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/light_energy.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/analysis/light/irradiance.h"
#include "core/analysis/light/mirror_rays.h"
#include "core/base/color.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

constexpr std::size_t kMaxMattPixels = 40000;
constexpr std::size_t kMinMattPixels = 100;
/// Share of the pixels whose albedo stays within the bounds; the others are highlights and wrong normals.
constexpr double kWithinBounds = 0.99;
/// Irradiance below this share of the mean is a wrong normal's or an error of the harmonics.
constexpr float kLeastIrradiance = 0.1f;
constexpr float kMaxRaise = 4;

/// Interior pixels of the segments that are not flagged as glossy, evenly chosen.
std::vector<std::size_t> mattPixels(const Scene& scene, const Surface& front) {
    const LabelImage& labels = scene.photo->labels;
    LabelTable<bool> matt(false);
    for (const Segment& segment : scene.segments) matt[segment.label] = segment.label != 0 && !segment.glossy;
    std::vector<std::size_t> pixels;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (matt[labels(x, y)] && front.depth(x, y) > 0 && isInterior(labels, front.depth, x, y))
                pixels.push_back(labels.index(x, y));
    const std::size_t stride = pixels.size() / kMaxMattPixels + 1;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < pixels.size(); k += stride) some.push_back(pixels[k]);
    return some;
}

/// What is not measured of the light, zero elsewhere.
ImageRgb unmeasuredPart(const DirectionalMap& light, bool exactShape) {
    ImageRgb part = light.radiance;
    if (!exactShape) return part;
    for (std::size_t i = 0; i < part.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const bool clipped = !light.clipped.empty() && (light.clipped[i] >> c & 1u) != 0;
            if (light.coverage[i] > 0 && !clipped) part[i][c] = 0;
        }
    return part;
}

/// Factor of `raised` with which fixed + factor·raised = needed.
float factorFor(float needed, float fixed, float raised, float least) {
    return (needed - fixed) / std::max(raised, least);
}

}  // namespace

void raiseToMattSurfaces(const Scene& scene, const Surface& front, bool exactShape, DirectionalMap& light) {
    const Photo& photo = *scene.photo;
    if (exactShape && std::isinf(photo.clipLevel)) return;
    const std::vector<std::size_t> pixels = mattPixels(scene, front);
    if (pixels.size() < kMinMattPixels) return;

    const ImageRgb part = unmeasuredPart(light, exactShape);
    const Irradiance all(light.radiance);
    const Irradiance raised(part);
    const Vector3f floor = (kLeastIrradiance * raised.mean()).cwiseMax(1e-6f);
    std::vector<float> factors;
    for (const std::size_t i : pixels) {
        const Vector3f free = raised.at(front.normal[i]);
        const Vector3f fixed = (all.at(front.normal[i]) - free).cwiseMax(0.0f);
        const Vector3f& color = photo.color[i];
        if (!color.allFinite()) continue;
        float most = factorFor(luminance(color) / kMostLuminance, luminance(fixed), luminance(free), luminance(floor));
        for (int c = 0; c < 3; ++c)
            most = std::max(most, factorFor(color[c] / kMostAlbedo, fixed[c], free[c], floor[c]));
        factors.push_back(most);
    }
    if (factors.empty()) return;
    const float factor = std::clamp(quantile(std::move(factors), kWithinBounds), 1.0f, kMaxRaise);
    for (std::size_t i = 0; i < part.size(); ++i) light.radiance[i] += (factor - 1) * part[i];
}

}  // namespace core::analysis
