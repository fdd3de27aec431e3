// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/light/deconvolve.h"
#include "core/analysis/light/directional_accumulator.h"
#include "core/analysis/light/fill_directions.h"
#include "core/analysis/light/light_energy.h"
#include "core/analysis/light/light_from_shading.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

/// Confidence of a segment whose ρ is a guess, relative to one whose ρ is reliable.
constexpr float kUnreliableConfidence = 0.2f;
/// Lower bound of ρ where reflected light is divided by it; the user's ρ may be lower.
constexpr float kMinDivisor = 1e-3f;

bool hasObservations(const LobeObservations& source) {
    return std::ranges::any_of(source.map.coverage.pixels(), [](float c) { return c > 0; });
}

std::size_t countDistant(const Image<std::uint8_t>& distant) {
    return static_cast<std::size_t>(std::ranges::count_if(distant.pixels(), [](std::uint8_t d) { return d != 0; }));
}

/// Share of the time to recover the environment that `distantLight` takes.
float distantLightShare(std::size_t distantPixels, int rows) {
    // [ns on two cores]
    constexpr float kTimePerPixel = 160;
    constexpr float kTimePerTexel = 11000;
    const float time = kTimePerPixel * static_cast<float>(distantPixels);
    return time / (time + kTimePerTexel * static_cast<float>(2 * rows * rows));
}

/// Distant pixels: light seen directly.
LobeObservations distantLight(const Photo& photo, const Image<std::uint8_t>& distant, int rows,
                              const Progress& progress) {
    DirectionalAccumulator sum(rows);
    const float scale = 1 / static_cast<float>(std::max<std::size_t>(countDistant(distant), 1));
    std::size_t added = 0;
    for (int y = 0; y < distant.height(); ++y) {
        progress.checkpoint(scale * static_cast<float>(added));
        for (int x = 0; x < distant.width(); ++x) {
            if (distant(x, y) == 0) continue;
            sum.add(photo.camera.pixelRay(x, y).normalized(), photo.color(x, y), 1, clippedChannels(photo, x, y));
            ++added;
        }
    }
    return {sum.map(), 0, {0, 0, 1}, 1};
}

/// What one glossy segment mirrors, divided by its ρ.
LobeObservations mirroredLight(const Reflectance& reflectance, const SegmentReflections& reflections) {
    LobeObservations source{reflections.missed, reflectance.alpha, reflections.view,
                            reflectance.reliable ? 1.0f : kUnreliableConfidence, reflections.overSupport};
    const Vector3f scale = reflectance.rho.cwiseMax(kMinDivisor).cwiseInverse();
    for (Vector3f& value : source.map.radiance.pixels()) value = value.cwiseProduct(scale);
    return source;
}

/// All segments but those that show more than they mirror, unless the user set their ρ.
std::vector<LobeObservations> mirroredLights(const Scene& scene,
                                             std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                             std::span<const std::shared_ptr<const SegmentReflections>> reflections) {
    CORE_ASSERT(reflectances.size() == reflections.size(), "one ρ per segment");
    std::vector<LobeObservations> sources;
    for (std::size_t i = 0; i < reflections.size(); ++i) {
        const Segment* segment = scene.findSegment(reflectances[i]->label);
        const bool chosen = segment != nullptr && segment->reflectance;
        if (chosen || !showsMoreThanItMirrors(*reflectances[i]))
            sources.push_back(mirroredLight(*reflectances[i], *reflections[i]));
    }
    return sources;
}

/// 1 = some source sees the environment there, not only a support's continuation.
Image<std::uint8_t> seenDirections(std::span<const LobeObservations> sources, int rows) {
    Image<std::uint8_t> seen(2 * rows, rows, 0);
    for (const LobeObservations& source : sources)
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (source.map.coverage[i] > 0 && !source.isOverSupport(i)) seen[i] = 1;
    return seen;
}

/// Supports only fill directions in which no source sees the environment.
void dropSupports(const Image<std::uint8_t>& seen, std::span<LobeObservations> sources) {
    for (LobeObservations& source : sources)
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] != 0 && source.isOverSupport(i)) source.map.coverage[i] = 0;
}

/// One texel of all sources, per channel.
struct MergedTexel {
    Vector3f radiance{0, 0, 0};
    float coverage = 0;
    unsigned clipped = 0;
};

/// Mean weighted by how much each source knows and how sharply. A clipped channel counts only where no source knows it
/// unclipped; then the largest value is taken, the nearest to what was clipped.
MergedTexel mergeTexel(std::span<const LobeObservations> sources, std::size_t i, float texelAngle) {
    MergedTexel result;
    unsigned open = 0;  // channels that some source knows unclipped
    Vector3f sum = Vector3f::Zero();
    Vector3f weights = Vector3f::Zero();
    Vector3f bound = Vector3f::Zero();
    for (const LobeObservations& source : sources) {
        const float coverage = source.map.coverage[i];
        if (!(coverage > 0)) continue;
        const unsigned clipped = source.clippedChannels(i);
        open |= ~clipped & 7u;
        const float blur = 2 * source.alpha / texelAngle;
        const float weight = source.confidence * coverage / (coverage + 1) / (1 + blur * blur);
        result.coverage += coverage;
        for (int c = 0; c < 3; ++c) {
            bound[c] = std::max(bound[c], source.map.radiance[i][c]);
            if ((clipped >> c & 1u) != 0) continue;
            sum[c] += weight * source.map.radiance[i][c];
            weights[c] += weight;
        }
    }
    if (!(result.coverage > 0)) return {};
    for (int c = 0; c < 3; ++c) result.radiance[c] = weights[c] > 0 ? sum[c] / weights[c] : bound[c];
    result.clipped = ~open & 7u;
    return result;
}

/// All sources in one map.
DirectionalMap merge(std::span<const LobeObservations> sources, int rows) {
    DirectionalMap result{ImageRgb(2 * rows, rows), ImageF(2 * rows, rows)};
    Image<std::uint8_t> clipped(2 * rows, rows, 0);
    for (std::size_t i = 0; i < result.radiance.size(); ++i) {
        const MergedTexel texel = mergeTexel(sources, i, texelAngle(rows));
        result.radiance[i] = texel.radiance;
        result.coverage[i] = texel.coverage;
        clipped[i] = static_cast<std::uint8_t>(texel.clipped);
    }
    if (std::ranges::any_of(clipped.pixels(), [](std::uint8_t c) { return c != 0; }))
        result.clipped = std::move(clipped);
    return result;
}

ImageRgb toMap(const ShadingLight& light, int rows) {
    ImageRgb map(2 * rows, rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x)
            map(x, y) = Vector3f::Constant(light.radiance(DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 2 * rows, rows)));
    return map;
}

/// Gives every direction without coverage a radiance: from the user's map if there is one, otherwise from what the
/// segments mirror, or without that from the shading.
void fillUnseen(const Scene& scene, const Surface& front, bool mirrored, DirectionalMap& map,
                const StepContext& context) {
    const EnvironmentParams& params = scene.environment;
    const int rows = map.radiance.height();
    const Progress first = context.progress.part(0, 0.5f);
    const StepContext second = context.part(0.5f, 1);
    if (params.image && !params.image->empty())
        completeDirections(map, userEnvironment(*params.image, params.rotation, params.scale, rows, first).radiance,
                           second);
    else if (mirrored)
        fillDirections(map, params.fill, Vector3f::Zero(), context);
    else
        completeDirections(map, toMap(lightFromShading(*scene.photo, front, first), rows), second);
}

}  // namespace

DirectionalMap recoverEnvironment(const Scene& scene, const Surface& front, const Image<std::uint8_t>& distant,
                                  bool exactShape, std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                  std::span<const std::shared_ptr<const SegmentReflections>> reflections,
                                  const StepContext& context) {
    const int rows = scene.environment.height;
    std::vector<LobeObservations> sources = mirroredLights(scene, reflectances, reflections);
    const bool mirrored = std::ranges::any_of(sources, hasObservations);
    const float distantEnd = distantLightShare(countDistant(distant), rows);
    sources.insert(sources.begin(), distantLight(*scene.photo, distant, rows, context.progress.part(0, distantEnd)));
    const Image<std::uint8_t> seen = seenDirections(sources, rows);
    dropSupports(seen, sources);
    DirectionalMap map = merge(sources, rows);
    const StepContext rest = context.part(distantEnd, 1);
    if (mirrored) {
        fillDirections(map, scene.environment.fill, Vector3f::Zero(), rest.part(0, 0.25f));
        deconvolve(map, sources, rest.part(0.25f, 0.75f));
    }
    fillUnseen(scene, front, mirrored, map, rest.part(mirrored ? 0.75f : 0.0f, 1));
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] == 0) map.coverage[i] = 0;
    if (mirrored && !scene.environment.image) raiseToMattSurfaces(scene, front, exactShape, map);
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
    // Coordinate of sample j of texel i in [0, 1].
    const auto coordinate = [](int i, int j, int count, int size) {
        return (static_cast<float>(i) + (static_cast<float>(j) + 0.5f) / static_cast<float>(count)) /
               static_cast<float>(size);
    };
    const DirectionalMap source{image, {}};
    const Vector2f size(static_cast<float>(image.width()), static_cast<float>(image.height()));
    parallelFor(progress, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Vector3f sum = Vector3f::Zero();
            for (int j = 0; j < countY; ++j)
                for (int i = 0; i < countX; ++i)
                    sum += source.lookupTexel(size.cwiseProduct(
                        Vector2f(coordinate(x, i, countX, width) - shift, coordinate(y, j, countY, height))));
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
        const bool exactShape = board.depth->relativeNoise == 0 && scene.photo->depthSampleSpacing <= 1;
        const bool replaced = p.image && !p.image->empty() && p.use == EnvironmentUse::Replace;
        board.environment = std::make_shared<DirectionalMap>(
            replaced ? userEnvironment(*p.image, p.rotation, p.scale, std::min(p.image->height(), kMaxUserRows),
                                       context.progress)
                     : recoverEnvironment(scene, *board.front, board.depth->distant, exactShape, board.reflectances,
                                          board.reflections, context));
    };
    return step;
}

}  // namespace core::analysis
