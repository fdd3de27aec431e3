// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/reflectance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/analysis/depth/distant_pixels.h"
#include "core/analysis/kernels.h"
#include "core/analysis/light/lobe.h"
#include "core/analysis/light/smooth_directions.h"
#include "core/base/color.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

constexpr int kIncidentRays = 1 << 16;
constexpr std::size_t kMaxTracedPixels = 400000;  // of a segment that are traced; more would not be seen in the maps
constexpr std::size_t kMaxProbes = 1500;
/// Codes just below the largest count as clipped too: sharpening and compression leave them there.
constexpr float kClipMargin = 0.98f;
constexpr int kMaxBetween = 12;                    // observations along the side of a pixel that are interpolated
constexpr std::size_t kMaxInterpolated = 1000000;  // of these
constexpr int kMinBlock = 8;  // pixels; a texture or an error of the normals is to lie in one block
constexpr float kMinRho = 0.02f;
/// A mirror cannot reflect more than it receives; what exceeds that by more than the error of an estimate is none.
constexpr float kMaxRho = 1.15f;
/// Beyond this angle (cosine) a mirrored direction depends more on the error of the normal than on the normal.
constexpr float kMinCosine = 0.08f;

/// Where a ray from a pixel of the segment, or from its centre, ended.
struct Ending {
    enum Kind : std::uint8_t {
        None,         ///< not traced
        Itself,       ///< hit the segment it started from
        Missed,       ///< left the picture: sees the environment
        OverSupport,  ///< left the picture but meets a support's continuation: does not see the environment
        Distant,      ///< left towards a distant pixel
        Known,        ///< hit a surface whose colour in the photo is true for every viewer
        Guessed,      ///< hit a back side, a glossy segment or an outline
    };
    Kind kind = None;
    Vector3f direction{0, 0, 0};
    Vector3f color{0, 0, 0};  ///< of what was hit
};

struct Tracer {
    const Scene& scene;
    const Surface& front;
    const Surface& back;
    const std::vector<bool>& glossy;  ///< by label
    const Image<std::uint8_t>& distant;
    const ContinuedSupports& continued;

    /// Bit c: the camera clipped channel c of a pixel.
    [[nodiscard]] unsigned clipped(int x, int y) const { return clippedChannels(*scene.photo, x, y); }

    /// What a ray sees that was found to end at `hit`.
    [[nodiscard]] Ending endingOf(const std::optional<MarchHit>& hit, const MarchRay& ray, std::uint16_t label) const {
        const Vector3f& direction = ray.direction;
        if (!hit) {
            if (const auto color = distantColor(*scene.photo, distant, direction))
                return {Ending::Distant, direction, *color};
            const bool met = continued.meets(ray.origin, direction);
            return {met ? Ending::OverSupport : Ending::Missed, direction, Vector3f::Zero()};
        }
        const LabelImage& labels = scene.photo->labels;
        const std::uint16_t hitLabel = labels(hit->x, hit->y);
        if (hitLabel == label) return {Ending::Itself, direction, Vector3f::Zero()};
        if (hit->back) return {Ending::Guessed, direction, back.color(hit->x, hit->y)};
        const bool known = !glossy[hitLabel] && isInterior(labels, front.depth, hit->x, hit->y);
        return {known ? Ending::Known : Ending::Guessed, direction, front.color(hit->x, hit->y)};
    }
};

/// Direction i of `count`, uniform on the sphere (spherical Fibonacci points).
Vector3f fibonacciDirection(int i, int count) {
    const double y = 1 - (2.0 * i + 1) / count;
    const double phi = 2 * std::numbers::pi * std::fmod(i * (std::numbers::phi - 1), 1.0);
    const double radius = std::sqrt(1 - y * y);
    return {static_cast<float>(radius * std::cos(phi)), static_cast<float>(y),
            static_cast<float>(radius * std::sin(phi))};
}

/// Ratio of means over the texels that both maps cover, without the extreme tenths.
struct CommonRatio {
    Vector3f rho{1, 1, 1};
    float solidAngle = 0;  ///< of all common texels
};

CommonRatio commonRatio(const DirectionalMap& reflected, const DirectionalMap& incident) {
    struct Texel {
        float ratio, solidAngle;
        std::size_t index;
    };
    std::vector<Texel> texels;
    CommonRatio result;
    const int width = reflected.radiance.width();
    const int height = reflected.radiance.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = reflected.radiance.index(x, y);
            if (reflected.coverage[i] <= 0 || incident.coverage[i] <= 0) continue;
            const float below = luminance(incident.radiance[i]);
            if (!(below > 0)) continue;
            const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
            texels.push_back({luminance(reflected.radiance[i]) / below, solidAngle, i});
            result.solidAngle += solidAngle;
        }
    }
    std::ranges::sort(texels, [](const Texel& a, const Texel& b) {
        return a.ratio != b.ratio ? a.ratio < b.ratio : a.index < b.index;
    });
    Eigen::Vector3d above = Eigen::Vector3d::Zero();
    Eigen::Vector3d below = Eigen::Vector3d::Zero();
    const std::size_t trim = texels.size() / 10;
    for (std::size_t k = trim; k + trim < texels.size(); ++k) {
        above += (texels[k].solidAngle * reflected.radiance[texels[k].index]).cast<double>();
        below += (texels[k].solidAngle * incident.radiance[texels[k].index]).cast<double>();
    }
    for (int c = 0; c < 3; ++c)
        if (below[c] > 0) result.rho[c] = static_cast<float>(above[c] / below[c]);
    return result;
}

Vector3f meanColor(const ImageRgb& color) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Vector3f& c : color.pixels()) sum += c.cast<double>();
    return (sum / static_cast<double>(std::max<std::size_t>(1, color.size()))).cast<float>();
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

namespace {

/// A pixel of the segment and the direction it mirrors.
struct Mirror {
    int x = 0, y = 0;
    Vector3f origin{0, 0, 0};     ///< lifted off the surface
    Vector3f direction{0, 0, 0};  ///< mirrored view direction; zero at grazing angles, where it is not known
    Ending ending;
};

std::optional<Vector3f> mirroredDirection(const Surface& front, int x, int y) {
    const Vector3f& n = front.normal(x, y);
    const Vector3f view = front.position(x, y).normalized();
    const float cosine = -view.dot(n);
    if (cosine < kMinCosine) return std::nullopt;
    return (view + 2 * cosine * n).normalized();
}

/// The pixel shows the environment.
bool showsLight(const Ending& ending) { return ending.kind == Ending::Missed || ending.kind == Ending::Distant; }

/// How much a pixel knows of the texel its mirrored ray points into: little where the neighbours' rays diverge.
float sharpness(const LabelImage& labels, const Surface& front, const Mirror& mirror, float texelAngle) {
    float spread = 0;
    for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, 0}, std::array{0, -1}}) {
        const int x = mirror.x + dx;
        const int y = mirror.y + dy;
        if (!labels.contains(x, y) || labels(x, y) != labels(mirror.x, mirror.y) || front.depth(x, y) <= 0) continue;
        const auto direction = mirroredDirection(front, x, y);
        spread = std::max(spread, direction ? (*direction - mirror.direction).norm() : 1.0f);
    }
    const float texels = 0.5f * spread / texelAngle;
    return 1 / (1 + texels * texels);
}

/// A pixel and its neighbours to the right and below.
struct MirrorQuad {
    std::array<std::size_t, 4> corners{};
    bool overSupport = false;  ///< they all look over a support's continuation, else they all show the light
    int steps = 0;             ///< along a side, so that every texel between them is met; 0 = neither
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
        const Ending& ending = mirrors[quad.corners[k]].ending;
        const bool overSupport = ending.kind == Ending::OverSupport;
        if (!overSupport && !showsLight(ending)) return {};
        if (k == 0) quad.overSupport = overSupport;
        if (overSupport != quad.overSupport) return {};
        spread = std::max(spread, (mirrors[quad.corners[k]].direction - mirrors[first].direction).norm());
    }
    quad.steps = std::min(static_cast<int>(1.5f * spread / texelAngle) + 1, kMaxBetween);
    return quad;
}

/// Where neighbouring pixels mirror directions more than a texel apart, adds what they show between them, interpolated:
/// observations without gaps. The coarsest are left out where there would be more than `kMaxInterpolated`.
void addBetween(const Tracer& tracer, std::span<const Mirror> mirrors, std::span<const float> weights, float texelAngle,
                DirectionalAccumulator& light, DirectionalAccumulator& overSupport) {
    Image<std::int32_t> mirrorAt(tracer.front.depth.width(), tracer.front.depth.height(), -1);
    for (std::size_t i = 0; i < mirrors.size(); ++i)
        mirrorAt(mirrors[i].x, mirrors[i].y) = static_cast<std::int32_t>(i);
    std::vector<MirrorQuad> quads;
    std::array<std::size_t, kMaxBetween + 1> counts{};  // by steps
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        const MirrorQuad quad = quadAt(mirrors, mirrorAt, i, texelAngle);
        if (quad.steps < 2) continue;
        quads.push_back(quad);
        ++counts[static_cast<std::size_t>(quad.steps)];
    }
    int mostSteps = 0;
    for (std::size_t steps = 1, total = 0; steps < counts.size(); ++steps) {
        total += counts[steps] * (steps * steps - 1);
        if (total <= kMaxInterpolated) mostSteps = static_cast<int>(steps);
    }
    for (const MirrorQuad& quad : quads) {
        if (quad.steps > mostSteps) continue;
        unsigned clipped = 0;
        for (const std::size_t k : quad.corners) clipped |= tracer.clipped(mirrors[k].x, mirrors[k].y);
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
                color += share[k] * tracer.front.color(mirror.x, mirror.y);
                weight += share[k] * weights[quad.corners[k]];
            }
            (quad.overSupport ? overSupport : light).add(direction.normalized(), color, weight, clipped);
        }
    }
}

/// Adds what `more` knows where `map` knows nothing; returns where (1).
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

/// Rays of one probe: one along the mirrored direction, then ring by ring.
constexpr std::size_t kProbeRays = 1 + std::size_t{kLobeRings} * kRaysPerRing;

/// The rays of one pixel's lobe; no ray (direction zero) where its lobe reaches below the horizon.
void aimProbe(const Surface& front, const Mirror& mirror, std::span<MarchRay> rays) {
    const Vector3f& n = front.normal(mirror.x, mirror.y);
    const Vector3f view = front.position(mirror.x, mirror.y).normalized();
    const Vector3f tangent = n.unitOrthogonal();
    const Vector3f bitangent = n.cross(tangent);
    std::size_t next = 0;
    for (int ring = 0; ring <= kLobeRings; ++ring) {
        for (int j = 0; j < (ring == 0 ? 1 : kRaysPerRing); ++j) {
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

/// What the lobe of one pixel meets, ring by ring. What misses everything is taken from `sky`, L_S/ρ of the segment.
LobeProbe readProbe(const Tracer& tracer, const Mirror& mirror, std::span<const MarchRay> rays,
                    std::span<const std::optional<MarchHit>> hits, std::uint16_t label, const DirectionalMap& sky) {
    LobeProbe probe;
    probe.color = tracer.front.color(mirror.x, mirror.y);
    std::size_t next = 0;
    for (int ring = 0; ring <= kLobeRings; ++ring) {
        const auto k = static_cast<std::size_t>(ring);
        const int count = ring == 0 ? 1 : kRaysPerRing;
        float known = 0;
        for (int j = 0; j < count; ++j) {
            const std::size_t i = next++;
            const Vector3f& direction = rays[i].direction;
            if (direction.isZero(0)) {
                known += 1;  // below the horizon: no light comes from there
                continue;
            }
            const Ending ending = tracer.endingOf(hits[i], rays[i], label);
            if (ending.kind == Ending::Known || ending.kind == Ending::Distant) {
                probe.incident[k] += ending.color;
                known += 1;
            } else if (ending.kind == Ending::Missed || ending.kind == Ending::OverSupport) {
                const Vector2f texel =
                    DirectionalMap::texelFromDirection(direction, sky.radiance.width(), sky.radiance.height());
                const int x = static_cast<int>(texel.x()) % sky.radiance.width();
                const int y = std::min(static_cast<int>(texel.y()), sky.radiance.height() - 1);
                if (!(sky.coverage(x, y) > 0)) continue;
                probe.incident[k] += sky.radiance(x, y);
                known += 1;
            }
        }
        if (known > 0) probe.incident[k] /= known;
        probe.known[k] = known / static_cast<float>(count);
    }
    return probe;
}

std::optional<LobeFit> probeAndFit(const Tracer& tracer, AnalysisKernels::RayMarcher& marcher,
                                   std::span<const Mirror> mirrors, std::uint16_t label, const DirectionalMap& missed,
                                   const Vector3f& rho, const Progress& progress) {
    std::vector<const Mirror*> candidates;
    for (const Mirror& mirror : mirrors)
        if (mirror.ending.kind == Ending::Known && tracer.clipped(mirror.x, mirror.y) == 0)
            candidates.push_back(&mirror);
    const std::size_t count = std::min(kMaxProbes, candidates.size());
    if (count == 0) return std::nullopt;
    DirectionalMap sky = missed;
    for (Vector3f& value : sky.radiance.pixels()) value = value.cwiseQuotient(rho.cwiseMax(kMinRho));
    const auto mirrorOf = [&](std::size_t i) -> const Mirror& { return *candidates[i * candidates.size() / count]; };
    std::vector<MarchRay> rays(count * kProbeRays);
    for (std::size_t i = 0; i < count; ++i)
        aimProbe(tracer.front, mirrorOf(i), std::span(rays).subspan(i * kProbeRays, kProbeRays));
    const auto hits = marcher.march(rays, 0, progress);
    std::vector<LobeProbe> probes;
    for (std::size_t i = 0; i < count; ++i)
        probes.push_back(readProbe(tracer, mirrorOf(i), std::span(rays).subspan(i * kProbeRays, kProbeRays),
                                   std::span(hits).subspan(i * kProbeRays, kProbeRays), label, sky));
    return fitLobe(probes);
}

}  // namespace

SegmentReflections estimateReflectance(const Scene& scene, const Surface& front, const Surface& back,
                                       AnalysisKernels::RayMarcher& marcher, const Image<std::uint8_t>& distant,
                                       const ContinuedSupports& continued, std::uint16_t label,
                                       const StepContext& context) {
    const Photo& photo = *scene.photo;
    const Camera& camera = photo.camera;
    const int mapHeight = std::clamp(scene.environment.height, 4, 2048);
    const float texelAngle = std::numbers::pi_v<float> / static_cast<float>(mapHeight);
    const int width = front.depth.width();
    const int height = front.depth.height();
    std::vector<bool> glossy(65536, false);
    for (const Segment& segment : scene.segments) glossy[segment.label] = segment.glossy;
    const Tracer tracer{scene, front, back, glossy, distant, continued};

    // Outlines mix two objects; a segment that is nothing but outline is used whole.
    std::vector<std::array<int, 2>> pixels;
    std::vector<std::array<int, 2>> interior;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (photo.labels(x, y) != label || front.depth(x, y) <= 0) continue;
            pixels.push_back({x, y});
            center += 0.5 * (front.position(x, y) + back.position(x, y)).cast<double>();
            if (isInterior(photo.labels, front.depth, x, y)) interior.push_back({x, y});
        }
    }
    SegmentReflections result;
    Reflectance& estimate = result.estimate;
    estimate.label = label;
    DirectionalAccumulator reflected(mapHeight);
    DirectionalAccumulator missed(mapHeight);
    DirectionalAccumulator overSupport(mapHeight);
    std::array<DirectionalAccumulator, 2> missedHalves{missed, missed};  // of alternate blocks of pixels
    DirectionalAccumulator incident(mapHeight);
    DirectionalAccumulator guessedIncident(mapHeight);
    DirectionalAccumulator pairReflected(mapHeight);
    DirectionalAccumulator pairIncident(mapHeight);
    std::vector<Mirror> mirrors;

    if (!pixels.empty()) {
        center /= static_cast<double>(pixels.size());
        result.view = center.normalized().cast<float>();
        const auto& used = interior.empty() ? pixels : interior;
        const std::size_t stride = used.size() / kMaxTracedPixels + 1;
        mirrors.resize(used.size() / stride);
        constexpr std::size_t kChunk = 512;
        const auto forEachMirror = [&](const auto& visit, float begin, float end) {
            parallelFor(context.progress.part(begin, end), static_cast<int>((mirrors.size() + kChunk - 1) / kChunk),
                        [&](int chunk) {
                            const std::size_t first = static_cast<std::size_t>(chunk) * kChunk;
                            for (std::size_t i = first; i < std::min(mirrors.size(), first + kChunk); ++i) visit(i);
                        });
        };
        std::vector<MarchRay> mirrored(mirrors.size());
        forEachMirror(
            [&](std::size_t i) {
                Mirror& mirror = mirrors[i];
                mirror.x = used[i * stride][0];
                mirror.y = used[i * stride][1];
                const auto direction = mirroredDirection(front, mirror.x, mirror.y);
                if (!direction) return;
                mirror.direction = *direction;
                const Vector3f& p = front.position(mirror.x, mirror.y);
                mirror.origin = p + marchBias(camera, p.z()) * front.normal(mirror.x, mirror.y);
                mirrored[i] = {mirror.origin, mirror.direction};
            },
            0, 0.05f);
        const auto hits = marcher.march(mirrored, 0, context.progress.part(0.05f, 0.35f));
        std::vector<float> weights(mirrors.size(), 1.0f);
        const int block = std::max(kMinBlock, static_cast<int>(std::sqrt(static_cast<double>(pixels.size())) / 8));
        forEachMirror(
            [&](std::size_t i) {
                Mirror& mirror = mirrors[i];
                if (mirror.direction.isZero(0)) return;
                mirror.ending = tracer.endingOf(hits[i], mirrored[i], label);
                weights[i] = sharpness(photo.labels, front, mirror, texelAngle);
            },
            0.35f, 0.4f);
        for (std::size_t i = 0; i < mirrors.size(); ++i) {
            const Mirror& mirror = mirrors[i];
            const Ending& ending = mirror.ending;
            if (ending.kind == Ending::None || ending.kind == Ending::Itself) continue;
            const Vector3f& color = front.color(mirror.x, mirror.y);
            const unsigned clipped = tracer.clipped(mirror.x, mirror.y);
            reflected.add(mirror.direction, color, weights[i], clipped);
            if (showsLight(ending)) {
                missed.add(mirror.direction, color, weights[i], clipped);
                const int half = (mirror.x / block + mirror.y / block) % 2;
                missedHalves[static_cast<std::size_t>(half)].add(mirror.direction, color, weights[i]);
            }
            if (ending.kind == Ending::OverSupport) overSupport.add(mirror.direction, color, weights[i], clipped);
            if (clipped == 0 && (ending.kind == Ending::Known || ending.kind == Ending::Distant)) {
                pairReflected.add(mirror.direction, color);
                pairIncident.add(mirror.direction, ending.color);
            }
        }

        if (stride == 1) addBetween(tracer, mirrors, weights, texelAngle, missed, overSupport);

        // What arrives at the centre, with the segment itself taken away.
        std::vector<MarchRay> rays;
        for (int i = 0; i < kIncidentRays; ++i)
            rays.push_back({center.cast<float>(), fibonacciDirection(i, kIncidentRays)});
        const auto ends = marcher.march(rays, label, context.progress.part(0.4f, 0.6f));
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ending ray = tracer.endingOf(ends[i], rays[i], label);
            if (ray.kind == Ending::Known || ray.kind == Ending::Distant) incident.add(ray.direction, ray.color);
            if (ray.kind == Ending::Guessed) guessedIncident.add(ray.direction, ray.color);
        }
    }

    estimate.reflected = reflected.map();
    estimate.incident = incident.map();
    result.missed = missed.map();
    result.overSupport = addUnseen(overSupport.map(), result.missed);
    if (const float sigma = agreementWidth(missedHalves[0].map(), missedHalves[1].map()); sigma > 0)
        smoothDirections(result.missed, sigma);
    const CommonRatio pairs = commonRatio(pairReflected.map(), pairIncident.map());
    const CommonRatio maps = commonRatio(estimate.reflected, estimate.incident);
    const CommonRatio& better = pairs.solidAngle >= kMinCommonSolidAngle ? pairs : maps;
    estimate.commonSolidAngle = better.solidAngle;
    estimate.reliable = better.solidAngle >= kMinCommonSolidAngle;
    estimate.rho = better.rho;
    if (estimate.reliable) {
        const auto fit =
            probeAndFit(tracer, marcher, mirrors, label, result.missed, better.rho, context.progress.part(0.6f, 0.8f));
        if (fit && fit->reliable) {
            estimate.alpha = fit->alpha;
            estimate.alphaReliable = true;
            estimate.rho = fit->rho;
        }
    }

    // Guesses fill the gaps between what is known, but do not count as known.
    const DirectionalMap guesses = guessedIncident.map();
    DirectionalMap filled = estimate.incident;
    for (std::size_t i = 0; i < filled.radiance.size(); ++i) {
        if (filled.coverage[i] > 0 || guesses.coverage[i] <= 0) continue;
        filled.radiance[i] = guesses.radiance[i];
        filled.coverage[i] = guesses.coverage[i];
    }
    const Vector3f fallback = meanColor(photo.color);
    const EnvironmentFill fill = scene.environment.fill;
    fillDirections(filled, fill, fallback, context.part(0.8f, 0.9f));
    estimate.incident.radiance = std::move(filled.radiance);
    fillDirections(estimate.reflected, fill, fallback, context.part(0.9f, 1));

    if (!estimate.reliable) {
        const Vector3f below = estimate.incident.mean();
        const Vector3f above = estimate.reflected.mean();
        for (int c = 0; c < 3; ++c) estimate.rho[c] = below[c] > 0 ? above[c] / below[c] : 1.0f;
    }
    estimate.reliable = estimate.reliable && estimate.rho.maxCoeff() <= kMaxRho;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(estimate.rho[c])) estimate.rho[c] = 1;
        estimate.rho[c] = std::clamp(estimate.rho[c], kMinRho, 1.0f);
    }
    return result;
}

Step reflectanceStep() {
    Step step;
    step.task = Task::EstimateReflectance;
    step.reads = {Item::Photo, Item::Depth, Item::Front, Item::Back, Item::Layers};
    step.writes = Item::Reflectances;
    step.params = [](const Scene& scene, Hash& hash) {
        addParams(hash, Stage::Reflectance, scene);
        for (const Segment& segment : scene.segments)
            if (segment.glossy) addParams(hash.add(segment.label), Stage::Reflectance, segment);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Scene& scene = *board.scene;
        std::vector<const Segment*> glossy;
        for (const Segment& segment : scene.segments)
            if (segment.glossy) glossy.push_back(&segment);
        // Which surfaces are glossy decides what counts as known for all of them. A segment's own ρ and lobe width
        // replace the estimate below and stay out of the key.
        Hash hash;
        addParams(hash.add(board.layersKey), Stage::Reflectance, scene);
        for (const Segment* segment : glossy) hash.add(segment->label);

        const auto marcher = context.kernels.rayMarcher(*board.layers);
        const ContinuedSupports continued(scene.photo->camera, scene.photo->labels, *board.front);
        std::vector<std::shared_ptr<const Reflectance>> results;
        std::vector<std::shared_ptr<const SegmentReflections>> reflections;
        for (std::size_t i = 0; i < glossy.size(); ++i) {
            const std::uint16_t label = glossy[i]->label;
            CachedReflectance& cached = board.reflectanceCache[label];
            if (!cached.reflections || cached.key != hash.value()) {
                const auto count = static_cast<float>(glossy.size());
                cached.reflections = std::make_shared<SegmentReflections>(estimateReflectance(
                    scene, *board.front, board.back->surface, *marcher, board.depth->distant, continued, label,
                    context.part(static_cast<float>(i) / count, static_cast<float>(i + 1) / count)));
                cached.key = hash.value();
            }
            auto result = std::make_shared<Reflectance>(cached.reflections->estimate);
            if (glossy[i]->reflectance) result->rho = *glossy[i]->reflectance;
            if (glossy[i]->lobeWidth) result->alpha = *glossy[i]->lobeWidth;
            results.push_back(std::move(result));
            reflections.push_back(cached.reflections);
        }
        std::erase_if(board.reflectanceCache, [&](const auto& entry) {
            return std::ranges::none_of(glossy, [&](const Segment* s) { return s->label == entry.first; });
        });
        board.reflectances = std::move(results);
        board.reflections = std::move(reflections);
    };
    return step;
}

}  // namespace core::analysis
