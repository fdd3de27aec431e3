// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/deconvolve.h"

#include <algorithm>
#include <vector>

#include "core/analysis/light/highlights.h"

namespace core::analysis {
namespace {

constexpr int kMaxRows = 512;
constexpr int kFactorIterations = 3;
/// Half vectors per lobe.
constexpr int kLobeSamples = 24;
/// Maximum factor of one iteration.
constexpr float kMaxStep = 4.0f;

std::vector<std::uint32_t> observedTexels(const LobeObservations& source) {
    std::vector<std::uint32_t> texels;
    for (std::size_t i = 0; i < source.map.coverage.size(); ++i)
        if (source.map.coverage[i] > 0) texels.push_back(static_cast<std::uint32_t>(i));
    return texels;
}

/// Adds the factor that every row asks for to the sums of its texels, and its weight.
void vote(const LobeSystem& system, const ImageRgb& light, ImageRgb& factor, ImageRgb& weight) {
    for (std::size_t r = 0; r < system.rows.size(); ++r) {
        const LobeSystem::Row& row = system.rows[r];
        Vector3f predicted = Vector3f::Zero();
        for (const auto& entry : system.entriesOf(r)) predicted += entry.weight * light[entry.texel];
        Vector3f ratio = row.observed.cwiseQuotient(predicted).cwiseMax(1 / kMaxStep).cwiseMin(kMaxStep);
        Vector3f certain = Vector3f::Constant(row.weight);
        for (int c = 0; c < 3; ++c)
            if ((row.clipped >> c & 1u) != 0 && ratio[c] <= 1) certain[c] = 0;  // the lower bound is fulfilled
        ratio = ratio.cwiseProduct(certain);
        for (const auto& entry : system.entriesOf(r)) {
            factor[entry.texel] += entry.weight * ratio;
            weight[entry.texel] += entry.weight * certain;
        }
    }
}

void iterate(std::span<const LobeSystem> systems, DirectionalMap& light) {
    ImageRgb factor(light.radiance.width(), light.radiance.height(), Vector3f::Zero());
    ImageRgb weight = factor;
    for (const LobeSystem& system : systems) vote(system, light.radiance, factor, weight);
    for (std::size_t i = 0; i < light.radiance.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (light.coverage[i] > 0 && weight[i][c] > 0) light.radiance[i][c] *= factor[i][c] / weight[i][c];
}

void sharpen(DirectionalMap& light, std::span<const LobeObservations> sources, const Progress& progress) {
    const auto steps = static_cast<float>(sources.size() + kFactorIterations);
    float step = 0;
    std::vector<LobeSystem> systems;
    for (const LobeObservations& source : sources) {
        progress.checkpoint(step++ / steps);
        systems.emplace_back(source, observedTexels(source), kLobeSamples);
    }
    for (int iteration = 0; iteration < kFactorIterations; ++iteration) {
        progress.checkpoint(step++ / steps);
        iterate(systems, light);
    }
}

}  // namespace

void deconvolve(DirectionalMap& light, std::span<const LobeObservations> sources, const StepContext& context) {
    if (std::ranges::none_of(sources, &LobeObservations::isBlurred) || light.radiance.height() > kMaxRows) return;
    const float lowest = std::max(1e-9f, 1e-4f * light.mean().mean());
    for (Vector3f& value : light.radiance.pixels()) value = value.cwiseMax(lowest);
    const float middle = light.clipped.empty() ? 1.0f : 0.5f;
    sharpen(light, sources, context.progress.part(0, middle));
    if (!light.clipped.empty()) recoverHighlights(light, sources, context.part(middle, 1));
}

}  // namespace core::analysis
