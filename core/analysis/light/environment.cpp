// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/light/deconvolve.h"
#include "core/analysis/light/light_from_shading.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

constexpr float kUnreliableConfidence = 0.2f;

/// Distant pixels: light seen directly.
DirectionalMap distantLight(const Photo& photo, const Image<std::uint8_t>& distant, int mapHeight,
                            const Progress& progress) {
    DirectionalAccumulator sum(mapHeight);
    for (int y = 0; y < distant.height(); ++y) {
        progress.checkpoint(static_cast<float>(y) / static_cast<float>(distant.height()));
        for (int x = 0; x < distant.width(); ++x) {
            if (distant(x, y) != 0)
                sum.add(photo.camera.pixelRay(x, y).normalized(), photo.color(x, y), 1, clippedChannels(photo, x, y));
        }
    }
    return sum.map();
}

/// All sources in one map: weighted by how much each knows and how sharply. A clipped channel counts only where no
/// source knows it unclipped; then the largest is taken, the nearest to what was clipped.
DirectionalMap merge(std::span<const LobeObservations> sources, int mapHeight) {
    const float texelAngle = std::numbers::pi_v<float> / static_cast<float>(mapHeight);
    DirectionalMap result{ImageRgb(2 * mapHeight, mapHeight, Vector3f::Zero()), ImageF(2 * mapHeight, mapHeight, 0.0f)};
    Image<std::uint8_t> clipped(2 * mapHeight, mapHeight, 0);
    bool anyClipped = false;
    for (std::size_t i = 0; i < result.radiance.size(); ++i) {
        unsigned open = 0;  // channels that some source knows unclipped
        for (const LobeObservations& source : sources)
            if (source.map.coverage[i] > 0) open |= ~source.clippedChannels(i) & 7u;
        Vector3f sum = Vector3f::Zero();
        Vector3f weights = Vector3f::Zero();
        Vector3f bound = Vector3f::Zero();
        for (const LobeObservations& source : sources) {
            const float coverage = source.map.coverage[i];
            if (!(coverage > 0)) continue;
            const float blur = 2 * source.alpha / texelAngle;
            const float weight = source.confidence * coverage / (coverage + 1) / (1 + blur * blur);
            result.coverage[i] += coverage;
            for (int c = 0; c < 3; ++c) {
                bound[c] = std::max(bound[c], source.map.radiance[i][c]);
                if ((source.clippedChannels(i) >> c & 1u) != 0) continue;
                sum[c] += weight * source.map.radiance[i][c];
                weights[c] += weight;
            }
        }
        if (!(result.coverage[i] > 0)) continue;
        for (int c = 0; c < 3; ++c) result.radiance[i][c] = weights[c] > 0 ? sum[c] / weights[c] : bound[c];
        clipped[i] = static_cast<std::uint8_t>(~open & 7u);
        anyClipped = anyClipped || clipped[i] != 0;
    }
    if (anyClipped) result.clipped = std::move(clipped);
    return result;
}

/// What a segment's rays tell of a texel without seeing the environment (`SegmentReflections::overSupport`).
bool isOverSupport(const SegmentReflections& reflections, std::size_t texel) {
    return !reflections.overSupport.empty() && reflections.overSupport[texel] != 0;
}

ImageRgb toMap(const ShadingLight& light, int width, int height) {
    ImageRgb map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map(x, y) = Vector3f::Constant(light.radiance(DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, width, height)));
    return map;
}

}  // namespace

DirectionalMap recoverEnvironment(const Scene& scene, const Surface& front, const Image<std::uint8_t>& distant,
                                  std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                  std::span<const std::shared_ptr<const SegmentReflections>> reflections,
                                  const StepContext& context) {
    CORE_ASSERT(reflectances.size() == reflections.size(), "one ρ per segment");
    const EnvironmentParams& params = scene.environment;
    const int mapHeight = std::clamp(params.height, 4, 2048);
    std::vector<LobeObservations> sources;
    std::vector<const SegmentReflections*> mirrors;  // all sources but the first
    sources.push_back(
        {distantLight(*scene.photo, distant, mapHeight, context.progress.part(0, 0.2f)), 0, {0, 0, 1}, 1});
    bool mirrored = false;
    for (std::size_t i = 0; i < reflections.size(); ++i) {
        const Reflectance& reflectance = *reflectances[i];
        const Segment* segment = scene.findSegment(reflectance.label);
        const bool chosen = segment != nullptr && segment->reflectance;
        if (!chosen && showsMoreThanItMirrors(reflectance)) continue;
        mirrored =
            mirrored || std::ranges::any_of(reflections[i]->missed.coverage.pixels(), [](float c) { return c > 0; });
        LobeObservations source{reflections[i]->missed, reflectance.alpha, reflections[i]->view,
                                reflectance.reliable ? 1.0f : kUnreliableConfidence};
        const Vector3f scale = reflectance.rho.cwiseMax(1e-3f).cwiseInverse();
        for (Vector3f& value : source.map.radiance.pixels()) value = value.cwiseProduct(scale);
        sources.push_back(std::move(source));
        mirrors.push_back(reflections[i].get());
    }
    // Texels in which some source sees the environment; the others of a support's continuation only fill.
    Image<std::uint8_t> seen(2 * mapHeight, mapHeight, 0);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        seen[i] = sources[0].map.coverage[i] > 0 ? 1 : 0;
        for (std::size_t k = 0; k < mirrors.size(); ++k)
            if (sources[k + 1].map.coverage[i] > 0 && !isOverSupport(*mirrors[k], i)) seen[i] = 1;
        for (std::size_t k = 0; k < mirrors.size(); ++k)
            if (seen[i] != 0 && isOverSupport(*mirrors[k], i)) sources[k + 1].map.coverage[i] = 0;
    }
    DirectionalMap map = merge(sources, mapHeight);
    if (mirrored) {
        fillDirections(map, params.fill, Vector3f::Zero(), context.part(0.2f, 0.4f));
        deconvolve(map, sources, context.part(0.4f, 0.8f));
    }
    if (params.image && !params.image->empty()) {
        const DirectionalMap user =
            userEnvironment(*params.image, params.rotation, params.scale, mapHeight, context.progress.part(0.8f, 0.9f));
        completeDirections(map, user.radiance, context.part(0.9f, 0.9f));
    } else if (mirrored) {
        fillDirections(map, params.fill, Vector3f::Zero(), context.part(0.8f, 1.0f));
    } else {
        const ShadingLight light = lightFromShading(*scene.photo, front, context.progress.part(0.8f, 0.8f));
        completeDirections(map, toMap(light, 2 * mapHeight, mapHeight), context.part(0.9f, 0.9f));
    }
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] == 0) map.coverage[i] = 0;
    return map;
}

DirectionalMap userEnvironment(const ImageRgb& image, float rotation, float scale, int rows, const Progress& progress) {
    const int height = std::max(rows, 1);
    const int width = 2 * height;
    DirectionalMap map{ImageRgb(width, height), ImageF(width, height, 1.0f)};
    const float turns = rotation / (2 * std::numbers::pi_v<float>);
    const float shift = turns - std::floor(turns);
    // Bilinear samples spread over the texel: as many as source texels it spans.
    const auto samples = [](int source, int target) { return std::clamp((source + target - 1) / target, 1, 32); };
    const int countX = samples(image.width(), width);
    const int countY = samples(image.height(), height);
    const DirectionalMap source{image, {}};
    const Vector2f size(static_cast<float>(image.width()), static_cast<float>(image.height()));
    parallelFor(progress, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Vector3f sum = Vector3f::Zero();
            for (int j = 0; j < countY; ++j) {
                for (int i = 0; i < countX; ++i) {
                    const float u =
                        (static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / static_cast<float>(countX)) /
                            static_cast<float>(width) -
                        shift;
                    const float v =
                        (static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(countY)) /
                        static_cast<float>(height);
                    sum += source.lookupTexel(size.cwiseProduct(Vector2f(u, v)));
                }
            }
            map.radiance(x, y) = scale / static_cast<float>(countX * countY) * sum;
        }
    });
    return map;
}

Step environmentStep() {
    Step step;
    step.task = Task::RecoverEnvironment;
    step.reads = {Item::Photo, Item::Depth, Item::Front, Item::Reflectances, Item::UserEnvironment};
    step.writes = Item::Environment;
    step.params = [](const Scene& scene, Hash& hash) {
        // Without a loaded map there is nothing to turn or scale. What reflectance depends on is in Item::Reflectances.
        Scene used = scene;
        if (!used.environment.image) {
            used.environment.rotation = 0;
            used.environment.scale = 1;
        }
        addParams(hash, Stage::Environment, used);
        for (const Segment& segment : scene.segments)
            if (segment.glossy) addParams(hash.add(segment.label), Stage::Environment, segment);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Scene& scene = *board.scene;
        const EnvironmentParams& p = scene.environment;
        const bool replaced = p.image && !p.image->empty() && p.use == EnvironmentUse::Replace;
        board.environment = std::make_shared<DirectionalMap>(
            replaced ? userEnvironment(*p.image, p.rotation, p.scale, std::min(p.image->height(), kMaxUserRows),
                                       context.progress)
                     : recoverEnvironment(scene, *board.front, board.depth->distant, board.reflectances,
                                          board.reflections, context));
    };
    return step;
}

}  // namespace core::analysis
