// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/reflected_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/analysis/light/directional_accumulator.h"
#include "core/analysis/light/smooth_directions.h"

namespace core::analysis {
namespace {

/// Maximum number of interpolated observations along the side of a pixel.
constexpr int kMaxSteps = 12;
/// Maximum number of interpolated observations of one segment.
constexpr std::size_t kMaxInterpolated = 1000000;
/// Minimum side [px] of the blocks that alternate between the two halves: large enough for a texture, or an error of
/// the normals, to lie in one of them.
constexpr int kMinBlock = 8;

/// Sums of what the segment shows, by mirrored direction.
struct ReflectedSums {
    explicit ReflectedSums(int rows)
        : all(rows),
          missed(rows),
          overSupport(rows),
          missedHalves{missed, missed},
          pairReflected(rows),
          pairIncident(rows) {}

    DirectionalAccumulator all;
    DirectionalAccumulator missed;
    DirectionalAccumulator overSupport;
    std::array<DirectionalAccumulator, 2> missedHalves;  ///< `missed` of alternate blocks of pixels
    DirectionalAccumulator pairReflected;
    DirectionalAccumulator pairIncident;

    /// `half`: the block's, 0 or 1.
    void add(const Mirror& mirror, const Vector3f& color, unsigned clipped, std::size_t half) {
        const RayEnd& end = mirror.end;
        if (end.kind == RayEnd::Kind::None || end.kind == RayEnd::Kind::Itself) return;
        all.add(mirror.direction, color, mirror.sharpness, clipped);
        if (end.showsLight()) {
            missed.add(mirror.direction, color, mirror.sharpness, clipped);
            missedHalves[half].add(mirror.direction, color, mirror.sharpness);
        }
        if (end.kind == RayEnd::Kind::OverSupport) overSupport.add(mirror.direction, color, mirror.sharpness, clipped);
        if (clipped == 0 && end.hasTrueColor()) {
            pairReflected.add(mirror.direction, color);
            pairIncident.add(mirror.direction, end.color);
        }
    }
};

/// A pixel and its neighbours to the right and below.
struct MirrorQuad {
    std::array<std::size_t, 4> corners{};
    bool overSupport = false;  ///< all corners look over a support's continuation; otherwise all show the light
    int steps = 0;  ///< along a side, so that no texel between the corners is skipped; 0 = not to be interpolated
};

MirrorQuad quadAt(std::span<const Mirror> mirrors, const Image<std::int32_t>& mirrorAt, std::size_t first,
                  float texelAngle) {
    MirrorQuad quad;
    float spread = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const int x = mirrors[first].x + static_cast<int>(k % 2);
        const int y = mirrors[first].y + static_cast<int>(k / 2);
        if (!mirrorAt.contains(x, y) || mirrorAt(x, y) < 0) return {};
        quad.corners[k] = static_cast<std::size_t>(mirrorAt(x, y));
        const Mirror& corner = mirrors[quad.corners[k]];
        const bool overSupport = corner.end.kind == RayEnd::Kind::OverSupport;
        if (!overSupport && !corner.end.showsLight()) return {};
        if (k == 0) quad.overSupport = overSupport;
        if (overSupport != quad.overSupport) return {};
        spread = std::max(spread, (corner.direction - mirrors[first].direction).norm());
    }
    quad.steps = std::min(static_cast<int>(1.5f * spread / texelAngle) + 1, kMaxSteps);
    return quad;
}

/// The quads with directions between their corners that no pixel shows, except the coarsest ones where they would need
/// more than `kMaxInterpolated` observations in all.
std::vector<MirrorQuad> quadsToInterpolate(const ReflectanceInput& in, std::span<const Mirror> mirrors) {
    Image<std::int32_t> mirrorAt(in.front.depth.width(), in.front.depth.height(), -1);
    for (std::size_t i = 0; i < mirrors.size(); ++i)
        mirrorAt(mirrors[i].x, mirrors[i].y) = static_cast<std::int32_t>(i);
    std::vector<MirrorQuad> quads;
    std::array<std::size_t, kMaxSteps + 1> counts{};  // by steps
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        const MirrorQuad quad = quadAt(mirrors, mirrorAt, i, texelAngle(in.rows));
        if (quad.steps < 2) continue;
        quads.push_back(quad);
        ++counts[static_cast<std::size_t>(quad.steps)];
    }
    int maxSteps = 0;
    for (std::size_t steps = 1, total = 0; steps < counts.size(); ++steps) {
        total += counts[steps] * (steps * steps - 1);
        if (total <= kMaxInterpolated) maxSteps = static_cast<int>(steps);
    }
    std::erase_if(quads, [&](const MirrorQuad& quad) { return quad.steps > maxSteps; });
    return quads;
}

/// Adds observations between the corners of a quad, interpolated bilinearly.
void addBetween(const ReflectanceInput& in, std::span<const Mirror> mirrors, const MirrorQuad& quad,
                DirectionalAccumulator& sum) {
    unsigned clipped = 0;
    for (const std::size_t k : quad.corners) clipped |= clippedChannels(*in.scene.photo, mirrors[k].x, mirrors[k].y);
    for (int i = 1; i < quad.steps * quad.steps; ++i) {
        const float u = static_cast<float>(i % quad.steps) / static_cast<float>(quad.steps);
        const float v = static_cast<float>(i / quad.steps) / static_cast<float>(quad.steps);
        const std::array<float, 4> share{(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
        Vector3f direction = Vector3f::Zero();
        Vector3f color = Vector3f::Zero();
        float weight = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Mirror& mirror = mirrors[quad.corners[k]];
            direction += share[k] * mirror.direction;
            color += share[k] * in.front.color(mirror.x, mirror.y);
            weight += share[k] * mirror.sharpness;
        }
        sum.add(direction.normalized(), color, weight, clipped);
    }
}

}  // namespace

ReflectedMaps averageReflected(const ReflectanceInput& in, const TracedPixels& pixels,
                               std::span<const Mirror> mirrors) {
    ReflectedSums sums(in.rows);
    const int block = std::max(kMinBlock, static_cast<int>(std::sqrt(static_cast<double>(pixels.segmentSize)) / 8));
    for (const Mirror& mirror : mirrors) {
        const auto half = static_cast<std::size_t>((mirror.x / block + mirror.y / block) % 2);
        sums.add(mirror, in.front.color(mirror.x, mirror.y), clippedChannels(*in.scene.photo, mirror.x, mirror.y),
                 half);
    }
    if (pixels.complete)
        for (const MirrorQuad& quad : quadsToInterpolate(in, mirrors))
            addBetween(in, mirrors, quad, quad.overSupport ? sums.overSupport : sums.missed);

    ReflectedMaps maps{sums.all.map(), sums.missed.map(), {}, sums.pairReflected.map(), sums.pairIncident.map()};
    maps.overSupport = addUnseen(sums.overSupport.map(), maps.missed);
    if (const float sigma = agreementWidth(sums.missedHalves[0].map(), sums.missedHalves[1].map()); sigma > 0)
        smoothDirections(maps.missed, sigma);
    return maps;
}

IncidentMaps averageIncident(const ReflectanceInput& in, std::span<const RayEnd> ends) {
    DirectionalAccumulator known(in.rows);
    DirectionalAccumulator guessed(in.rows);
    for (const RayEnd& end : ends) {
        if (end.hasTrueColor()) known.add(end.direction, end.color);
        if (end.kind == RayEnd::Kind::Guessed) guessed.add(end.direction, end.color);
    }
    return {known.map(), guessed.map()};
}

Image<std::uint8_t> addUnseen(const DirectionalMap& more, DirectionalMap& map) {
    Image<std::uint8_t> added(map.radiance.width(), map.radiance.height(), 0);
    if (!more.clipped.empty() && map.clipped.empty())
        map.clipped = Image<std::uint8_t>(map.radiance.width(), map.radiance.height(), 0);
    for (std::size_t i = 0; i < map.radiance.size(); ++i) {
        if (map.coverage[i] > 0 || !(more.coverage[i] > 0)) continue;
        map.radiance[i] = more.radiance[i];
        map.coverage[i] = more.coverage[i];
        if (!more.clipped.empty()) map.clipped[i] = more.clipped[i];
        added[i] = 1;
    }
    return added;
}

}  // namespace core::analysis
