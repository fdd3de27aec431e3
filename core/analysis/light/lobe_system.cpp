// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/lobe_system.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/analysis/light/directional_accumulator.h"
#include "core/analysis/light/lobe.h"

namespace core::analysis {
namespace {

/// Direction that a half vector at `offset` from the normal (rotated by `turn` [rad]) reflects `view` into; the normal
/// itself reflects it into `mirrored`, which also replaces directions below the horizon.
Vector3f reflectedBy(const Vector2f& offset, float turn, const Vector3f& view, const Vector3f& mirrored) {
    const Vector3f difference = mirrored - view;
    if (!(difference.squaredNorm() > 1e-6f)) return mirrored;
    const Vector3f n = difference.normalized();
    const Vector3f tangent = n.unitOrthogonal();
    const Vector3f bitangent = n.cross(tangent);
    const float along = std::cos(turn) * offset.x() - std::sin(turn) * offset.y();
    const float across = std::sin(turn) * offset.x() + std::cos(turn) * offset.y();
    const Vector3f half = (n + along * tangent + across * bitangent).normalized();
    const Vector3f d = view - 2 * view.dot(half) * half;
    return d.dot(n) <= 0 ? mirrored : d;
}

/// The texels that light at texel `i` of a source's map comes from, one for each offset of a half vector (with
/// repetitions, all of equal weight).
void lobeTexels(const LobeObservations& source, std::span<const Vector2f> offsets, std::size_t i,
                std::vector<std::uint32_t>& texels) {
    const int width = source.map.radiance.width();
    const int height = source.map.radiance.height();
    const auto x = static_cast<float>(i % static_cast<std::size_t>(width));
    const auto y = static_cast<float>(i / static_cast<std::size_t>(width));
    const float turn = 2.399963f * static_cast<float>(i % 4096);  // decorrelates the texels
    texels.clear();
    for (std::size_t k = 0; k < offsets.size(); ++k) {
        // Spread over the texel as well as over the lobe.
        const float jx = std::fmod(0.5f + static_cast<float>(k) * 0.7548777f, 1.0f);
        const float jy = std::fmod(0.5f + static_cast<float>(k) * 0.5698403f, 1.0f);
        const Vector3f mirrored = DirectionalMap::directionFromTexel({x + jx, y + jy}, width, height);
        const Vector3f d = reflectedBy(offsets[k], turn, source.view, mirrored);
        const Vector2f texel = DirectionalMap::texelFromDirection(d, width, height);
        const int tx = std::clamp(static_cast<int>(texel.x()), 0, width - 1);
        const int ty = std::clamp(static_cast<int>(texel.y()), 0, height - 1);
        texels.push_back(static_cast<std::uint32_t>(source.map.radiance.index(tx, ty)));
    }
}

}  // namespace

bool LobeObservations::isBlurred() const { return 2 * alpha >= 0.5f * texelAngle(map.radiance.height()); }

LobeSystem::LobeSystem(const LobeObservations& source, std::span<const std::uint32_t> wanted, int samples) {
    const DirectionalMap& map = source.map;
    const bool blurred = source.isBlurred();
    const std::vector<Vector2f> offsets = lobeOffsets(source.alpha, samples);
    std::vector<std::uint32_t> texels;
    for (const std::uint32_t i : wanted) {
        if (!blurred) {
            entries.push_back({i, 1});
        } else {
            lobeTexels(source, offsets, i, texels);
            std::ranges::sort(texels);
            const std::size_t first = entries.size();
            for (const std::uint32_t texel : texels) {
                if (entries.size() == first || entries.back().texel != texel) entries.push_back({texel, 0});
                entries.back().weight += 1 / static_cast<float>(samples);
            }
        }
        const float coverage = map.coverage[i];
        rows.push_back({entries.size(), source.confidence * coverage / (coverage + 1), map.radiance[i],
                        source.clippedChannels(i)});
    }
}

}  // namespace core::analysis
