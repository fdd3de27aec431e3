// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/reflectance.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/light/fill_directions.h"
#include "core/analysis/light/lobe_probes.h"
#include "core/base/color.h"

namespace core::analysis {
namespace {

/// A mirror cannot reflect more than it receives. An estimate of ρ that exceeds 1 by more than its own error says that
/// the segment is no (pure) mirror.
constexpr float kMaxRho = 1.15f;

/// Texels that both maps cover.
struct CommonTexels {
    struct Texel {
        float ratio;  ///< reflected over incident luminance
        float solidAngle;
        std::size_t index;
    };
    std::vector<Texel> texels;  ///< by ascending ratio
    float solidAngle = 0;       ///< [sr] of all
};

CommonTexels commonTexels(const DirectionalMap& reflected, const DirectionalMap& incident) {
    CommonTexels result;
    const int width = reflected.radiance.width();
    const int height = reflected.radiance.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = reflected.radiance.index(x, y);
            if (reflected.coverage[i] <= 0 || incident.coverage[i] <= 0) continue;
            const float below = luminance(incident.radiance[i]);
            if (!(below > 0)) continue;
            const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
            result.texels.push_back({luminance(reflected.radiance[i]) / below, solidAngle, i});
            result.solidAngle += solidAngle;
        }
    }
    std::ranges::sort(result.texels, [](const auto& a, const auto& b) {
        return a.ratio != b.ratio ? a.ratio < b.ratio : a.index < b.index;
    });
    return result;
}

/// Ratio of means over the common texels, without the extreme tenths; 1 in channels without light.
Vector3f trimmedRatio(const CommonTexels& common, const DirectionalMap& reflected, const DirectionalMap& incident) {
    Eigen::Vector3d above = Eigen::Vector3d::Zero();
    Eigen::Vector3d below = Eigen::Vector3d::Zero();
    const std::size_t trim = common.texels.size() / 10;
    for (std::size_t k = trim; k + trim < common.texels.size(); ++k) {
        const auto& texel = common.texels[k];
        above += (texel.solidAngle * reflected.radiance[texel.index]).cast<double>();
        below += (texel.solidAngle * incident.radiance[texel.index]).cast<double>();
    }
    Vector3f rho(1, 1, 1);
    for (int c = 0; c < 3; ++c)
        if (below[c] > 0) rho[c] = static_cast<float>(above[c] / below[c]);
    return rho;
}

/// L_S, L_G (known parts only) and ρ from the pairs, or where these cover too little, from L_S and L_G.
Reflectance ratioOfMeans(std::uint16_t label, const ReflectedMaps& reflected, const IncidentMaps& incident) {
    Reflectance estimate;
    estimate.label = label;
    estimate.reflected = reflected.all;
    estimate.incident = incident.known;
    const CommonTexels pairs = commonTexels(reflected.pairReflected, reflected.pairIncident);
    if (pairs.solidAngle >= kMinCommonSolidAngle) {
        estimate.commonSolidAngle = pairs.solidAngle;
        estimate.rho = trimmedRatio(pairs, reflected.pairReflected, reflected.pairIncident);
    } else {
        const CommonTexels maps = commonTexels(estimate.reflected, estimate.incident);
        estimate.commonSolidAngle = maps.solidAngle;
        estimate.rho = trimmedRatio(maps, estimate.reflected, estimate.incident);
    }
    estimate.reliable = estimate.commonSolidAngle >= kMinCommonSolidAngle;
    return estimate;
}

/// Replaces ρ and the lobe's width by what whole lobes show, where they show enough.
void refineByLobe(const ReflectanceInput& in, std::span<const Mirror> mirrors, const DirectionalMap& missed,
                  Reflectance& estimate, const Progress& progress) {
    const auto fit = probeLobes(in, mirrors, missed, estimate.rho, progress);
    if (!fit || !fit->reliable) return;
    estimate.alpha = fit->alpha;
    estimate.alphaReliable = true;
    estimate.rho = fit->rho;
}

Vector3f meanColor(const ImageRgb& color) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Vector3f& c : color.pixels()) sum += c.cast<double>();
    return (sum / static_cast<double>(std::max<std::size_t>(1, color.size()))).cast<float>();
}

/// Fills the unknown texels of L_S and L_G. Guesses fill L_G before interpolation does, but do not count as known.
void fillGaps(const ReflectanceInput& in, const DirectionalMap& guessed, Reflectance& estimate,
              const StepContext& context) {
    const Vector3f fallback = meanColor(in.scene.photo->color);
    const EnvironmentFill fill = in.scene.environment.fill;
    DirectionalMap filled{estimate.incident.radiance, estimate.incident.coverage};
    addUnseen(guessed, filled);
    fillDirections(filled, fill, fallback, context.part(0, 0.5f));
    estimate.incident.radiance = std::move(filled.radiance);
    fillDirections(estimate.reflected, fill, fallback, context.part(0.5f, 1));
}

/// ρ of a segment that shows too little of what is known otherwise: the ratio of the filled maps' means. Where that is
/// no mirror's, most of what the segment shows lies beside the picture, and a chrome ball is the best guess.
void guessFromFilledMaps(Reflectance& estimate) {
    const Vector3f below = estimate.incident.mean();
    const Vector3f above = estimate.reflected.mean();
    for (int c = 0; c < 3; ++c) estimate.rho[c] = below[c] > 0 ? above[c] / below[c] : 1.0f;
    if (!(estimate.rho.maxCoeff() < 1)) estimate.rho = Vector3f(1, 1, 1);
}

/// No mirror reflects more than it receives: an estimate well above that is unreliable.
void clampToMirror(Reflectance& estimate) {
    estimate.reliable = estimate.reliable && estimate.rho.maxCoeff() <= kMaxRho;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(estimate.rho[c])) estimate.rho[c] = 1;
        estimate.rho[c] = std::clamp(estimate.rho[c], kMinRho, 1.0f);
    }
}

}  // namespace

SegmentReflections estimateReflectance(const ReflectanceInput& in, const StepContext& context) {
    const Progress& progress = context.progress;
    // Observe: what every pixel mirrors, and what arrives at the segment.
    const TracedPixels pixels = tracedPixels(in);
    const std::vector<Mirror> mirrors = traceMirrors(in, pixels, progress.part(0, 0.4f));
    const std::vector<RayEnd> arriving = traceFromCenter(in, pixels, progress.part(0.4f, 0.6f));
    // Average by direction.
    ReflectedMaps reflected = averageReflected(in, pixels, mirrors);
    const IncidentMaps incident = averageIncident(in, arriving);
    // Estimate.
    Reflectance estimate = ratioOfMeans(in.label, reflected, incident);
    if (estimate.reliable) refineByLobe(in, mirrors, reflected.missed, estimate, progress.part(0.6f, 0.8f));
    fillGaps(in, incident.guessed, estimate, context.part(0.8f, 1));
    if (!estimate.reliable) guessFromFilledMaps(estimate);
    clampToMirror(estimate);
    const Vector3f view = pixels.segmentSize > 0 ? pixels.center.normalized().cast<float>() : Vector3f(0, 0, 1);
    return {std::move(estimate), std::move(reflected.missed), std::move(reflected.overSupport), view};
}

}  // namespace core::analysis
