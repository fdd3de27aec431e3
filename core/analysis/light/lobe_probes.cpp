// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/lobe_probes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace core::analysis {
namespace {

constexpr std::size_t kMaxProbes = 1500;
/// Rays of one probe: one along the mirrored direction, then ring by ring.
constexpr std::size_t kProbeRays = 1 + std::size_t{kLobeRings} * kRaysPerRing;

int raysInRing(int ring) { return ring == 0 ? 1 : kRaysPerRing; }

/// Pixels to probe: at most `kMaxProbes`, evenly spread over those whose colours on both ends of the ray are true.
std::vector<const Mirror*> probedMirrors(const ReflectanceInput& in, std::span<const Mirror> mirrors) {
    std::vector<const Mirror*> candidates;
    for (const Mirror& mirror : mirrors)
        if (mirror.end.kind == RayEnd::Kind::Known && clippedChannels(*in.scene.photo, mirror.x, mirror.y) == 0)
            candidates.push_back(&mirror);
    const std::size_t count = std::min(kMaxProbes, candidates.size());
    std::vector<const Mirror*> probed;
    for (std::size_t i = 0; i < count; ++i) probed.push_back(candidates[i * candidates.size() / count]);
    return probed;
}

/// The rays of one pixel's lobe; no ray (direction zero) where the lobe reaches below the horizon.
void aimProbe(const Surface& front, const Mirror& mirror, std::span<MarchRay> rays) {
    const Vector3f& n = front.normal(mirror.x, mirror.y);
    const Vector3f view = front.position(mirror.x, mirror.y).normalized();
    const Vector3f tangent = n.unitOrthogonal();
    const Vector3f bitangent = n.cross(tangent);
    std::size_t next = 0;
    for (int ring = 0; ring <= kLobeRings; ++ring) {
        for (int j = 0; j < raysInRing(ring); ++j) {
            const float phi = 2 * std::numbers::pi_v<float> *
                              (static_cast<float>(j) + 0.37f * static_cast<float>(ring)) / kRaysPerRing;
            const Vector3f half =
                (n + ringTangent(ring) * (std::cos(phi) * tangent + std::sin(phi) * bitangent)).normalized();
            const Vector3f direction = view - 2 * view.dot(half) * half;
            if (direction.dot(n) > 0) rays[next] = {mirror.origin, direction};
            ++next;
        }
    }
}

/// Radiance of the texel a direction points into; nullopt without coverage.
std::optional<Vector3f> knownRadiance(const DirectionalMap& map, const Vector3f& direction) {
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    const Vector2f texel = DirectionalMap::texelFromDirection(direction, width, height);
    const int x = static_cast<int>(texel.x()) % width;
    const int y = std::min(static_cast<int>(texel.y()), height - 1);
    if (!(map.coverage(x, y) > 0)) return std::nullopt;
    return map.radiance(x, y);
}

/// Radiance that arrives along one ray of a probe; nullopt if unknown.
std::optional<Vector3f> incidentRadiance(const ReflectanceInput& in, const MarchRay& ray,
                                         const std::optional<MarchHit>& hit, const DirectionalMap& sky) {
    if (ray.direction.isZero(0)) return Vector3f::Zero();  // no light comes from below the horizon
    const RayEnd end = endOf(in, ray, hit);
    if (end.hasTrueColor()) return end.color;
    if (end.kind == RayEnd::Kind::Missed || end.kind == RayEnd::Kind::OverSupport)
        return knownRadiance(sky, ray.direction);
    return std::nullopt;
}

/// What the lobe of one pixel meets, ring by ring. Rays that miss everything find `sky`.
LobeProbe readProbe(const ReflectanceInput& in, const Mirror& mirror, std::span<const MarchRay> rays,
                    std::span<const std::optional<MarchHit>> hits, const DirectionalMap& sky) {
    LobeProbe probe;
    probe.color = in.front.color(mirror.x, mirror.y);
    std::size_t next = 0;
    for (int ring = 0; ring <= kLobeRings; ++ring) {
        const auto k = static_cast<std::size_t>(ring);
        float known = 0;
        for (int j = 0; j < raysInRing(ring); ++j, ++next) {
            const auto radiance = incidentRadiance(in, rays[next], hits[next], sky);
            if (!radiance) continue;
            probe.incident[k] += *radiance;
            known += 1;
        }
        if (known > 0) probe.incident[k] /= known;
        probe.known[k] = known / static_cast<float>(raysInRing(ring));
    }
    return probe;
}

}  // namespace

std::optional<LobeFit> probeLobes(const ReflectanceInput& in, std::span<const Mirror> mirrors,
                                  const DirectionalMap& missed, const Vector3f& rho, const Progress& progress) {
    const std::vector<const Mirror*> probed = probedMirrors(in, mirrors);
    if (probed.empty()) return std::nullopt;
    DirectionalMap sky = missed;
    for (Vector3f& value : sky.radiance.pixels()) value = value.cwiseQuotient(rho.cwiseMax(kMinRho));
    std::vector<MarchRay> rays(probed.size() * kProbeRays);
    for (std::size_t i = 0; i < probed.size(); ++i)
        aimProbe(in.front, *probed[i], std::span(rays).subspan(i * kProbeRays, kProbeRays));
    const auto hits = in.marcher.march(rays, 0, progress);
    std::vector<LobeProbe> probes;
    for (std::size_t i = 0; i < probed.size(); ++i)
        probes.push_back(readProbe(in, *probed[i], std::span(rays).subspan(i * kProbeRays, kProbeRays),
                                   std::span(hits).subspan(i * kProbeRays, kProbeRays), sky));
    return fitLobe(probes);
}

}  // namespace core::analysis
