// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/deconvolve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/analysis/light/fill_directions.h"
#include "core/analysis/light/lobe.h"

namespace core::analysis {
namespace {

constexpr int kMaxRows = 512;
constexpr int kFactorIterations = 3;
constexpr int kLobeSamples = 24;  // of a lobe
constexpr float kMaxStep = 4.0f;  // largest factor of one iteration

// Highlights the camera clipped.
constexpr int kHighlightSamples = 512;      // their tails matter
constexpr int kHighlightPasses = 3;         // each starts from surroundings with less of the tails in them
constexpr float kReach = 4;                 // half vectors up to this many α from a clipped texel show its tails
constexpr std::size_t kMaxHighlights = 16;  // the largest ones
constexpr int kMinConstraints = 8;          // unclipped observations that see a highlight

Vector3f texelCentre(std::size_t i, int width, int height) {
    const auto w = static_cast<std::size_t>(width);
    return DirectionalMap::directionFromTexel({static_cast<float>(i % w) + 0.5f, static_cast<float>(i / w) + 0.5f},
                                              width, height);
}

/// The texels that light at texel `i` of a source's map comes from, `samples` of equal weight (with repetitions).
void lobeTexels(const LobeObservations& source, std::span<const Vector2f> offsets, std::size_t i,
                std::vector<std::uint32_t>& texels) {
    const int width = source.map.radiance.width();
    const int height = source.map.radiance.height();
    const auto x = static_cast<float>(i % static_cast<std::size_t>(width));
    const auto y = static_cast<float>(i / static_cast<std::size_t>(width));
    const float turn = 2.399963f * static_cast<float>(i % 4096);  // another one for every texel
    texels.clear();
    for (std::size_t k = 0; k < offsets.size(); ++k) {
        // Spread over the texel as well as over the lobe.
        const float jx = std::fmod(0.5f + static_cast<float>(k) * 0.7548777f, 1.0f);
        const float jy = std::fmod(0.5f + static_cast<float>(k) * 0.5698403f, 1.0f);
        const Vector3f mirrored = DirectionalMap::directionFromTexel({x + jx, y + jy}, width, height);
        const Vector3f difference = mirrored - source.view;
        Vector3f d = mirrored;
        if (difference.squaredNorm() > 1e-6f) {
            const Vector3f n = difference.normalized();
            const Vector3f tangent = n.unitOrthogonal();
            const Vector3f bitangent = n.cross(tangent);
            const float along = std::cos(turn) * offsets[k].x() - std::sin(turn) * offsets[k].y();
            const float across = std::sin(turn) * offsets[k].x() + std::cos(turn) * offsets[k].y();
            const Vector3f half = (n + along * tangent + across * bitangent).normalized();
            d = source.view - 2 * source.view.dot(half) * half;
            if (d.dot(n) <= 0) d = mirrored;
        }
        const Vector2f texel = DirectionalMap::texelFromDirection(d, width, height);
        const int tx = std::clamp(static_cast<int>(texel.x()), 0, width - 1);
        const int ty = std::clamp(static_cast<int>(texel.y()), 0, height - 1);
        texels.push_back(static_cast<std::uint32_t>(source.map.radiance.index(tx, ty)));
    }
}

/// Observations of one source, each a weighted mean of texels of light.
struct System {
    struct Row {
        std::size_t end;  ///< of its entries; they begin where those of the row before end
        float weight;
        Vector3f observed;
        unsigned clipped;  ///< bit c: channel c is a lower bound
    };
    struct Entry {
        std::uint32_t texel;
        float weight;
    };
    std::vector<Row> rows;
    std::vector<Entry> entries;

    /// `wanted`: texels of the map to take, by index.
    System(const LobeObservations& source, std::span<const std::uint32_t> wanted, int samples, float texelAngle) {
        const DirectionalMap& map = source.map;
        // Narrower than a texel: its own texel alone.
        const bool sharp = 2 * source.alpha < 0.5f * texelAngle;
        const std::vector<Vector2f> offsets = lobeOffsets(source.alpha, samples);
        std::vector<std::uint32_t> texels;
        for (const std::uint32_t i : wanted) {
            if (sharp) {
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

    /// Adds what every row says to the factor that each of its texels should get, and to its weight.
    void vote(const ImageRgb& light, ImageRgb& factor, ImageRgb& weight) const {
        std::size_t begin = 0;
        for (const Row& row : rows) {
            const std::span<const Entry> mine(entries.data() + begin, row.end - begin);
            begin = row.end;
            Vector3f predicted = Vector3f::Zero();
            for (const Entry& entry : mine) predicted += entry.weight * light[entry.texel];
            Vector3f ratio = row.observed.cwiseQuotient(predicted).cwiseMax(1 / kMaxStep).cwiseMin(kMaxStep);
            Vector3f certain = Vector3f::Constant(row.weight);
            for (int c = 0; c < 3; ++c)
                if ((row.clipped >> c & 1u) != 0 && ratio[c] <= 1) certain[c] = 0;  // fulfilled: says nothing
            ratio = ratio.cwiseProduct(certain);
            for (const Entry& entry : mine) {
                factor[entry.texel] += entry.weight * ratio;
                weight[entry.texel] += entry.weight * certain;
            }
        }
    }
};

std::vector<std::uint32_t> observedTexels(const LobeObservations& source) {
    std::vector<std::uint32_t> texels;
    for (std::size_t i = 0; i < source.map.coverage.size(); ++i)
        if (source.map.coverage[i] > 0) texels.push_back(static_cast<std::uint32_t>(i));
    return texels;
}

/// Texels clipped in some channel that touch each other: one highlight.
struct Highlight {
    std::vector<std::uint32_t> texels;
    std::vector<float> depth;  ///< of each: texels to the outline over the deepest one's, (0, 1]
};

std::vector<Highlight> findHighlights(const Image<std::uint8_t>& clipped) {
    const int width = clipped.width();
    const int height = clipped.height();
    const auto neighbors = [&](std::uint32_t i) {
        const int x = static_cast<int>(i) % width;
        const int y = static_cast<int>(i) / width;
        std::array<std::int64_t, 4> result{};
        result[0] = static_cast<std::int64_t>(clipped.index((x + 1) % width, y));
        result[1] = static_cast<std::int64_t>(clipped.index((x + width - 1) % width, y));
        result[2] = y > 0 ? static_cast<std::int64_t>(clipped.index(x, y - 1)) : -1;
        result[3] = y + 1 < height ? static_cast<std::int64_t>(clipped.index(x, y + 1)) : -1;
        return result;
    };
    std::vector<Highlight> highlights;
    ImageF distance(width, height, 0.0f);  // texels to the outline; 0 = not visited
    Image<std::uint8_t> visited(width, height, 0);
    for (std::size_t start = 0; start < clipped.size(); ++start) {
        if (clipped[start] == 0 || visited[start] != 0) continue;
        Highlight highlight;
        highlight.texels.push_back(static_cast<std::uint32_t>(start));
        visited[start] = 1;
        std::vector<std::uint32_t> front;
        for (std::size_t k = 0; k < highlight.texels.size(); ++k) {
            const std::uint32_t i = highlight.texels[k];
            bool outline = false;
            for (const std::int64_t n : neighbors(i)) {
                if (n < 0) continue;
                const auto next = static_cast<std::size_t>(n);
                if (clipped[next] == 0) {
                    outline = true;
                } else if (visited[next] == 0) {
                    visited[next] = 1;
                    highlight.texels.push_back(static_cast<std::uint32_t>(next));
                }
            }
            if (!outline) continue;
            distance[i] = 1;
            front.push_back(i);
        }
        float deepest = 1;
        for (std::size_t k = 0; k < front.size(); ++k) {
            for (const std::int64_t n : neighbors(front[k])) {
                if (n < 0) continue;
                const auto next = static_cast<std::size_t>(n);
                if (clipped[next] == 0 || distance[next] > 0) continue;
                distance[next] = distance[front[k]] + 1;
                deepest = std::max(deepest, distance[next]);
                front.push_back(static_cast<std::uint32_t>(next));
            }
        }
        for (const std::uint32_t i : highlight.texels) highlight.depth.push_back(distance[i] / deepest);
        highlights.push_back(std::move(highlight));
    }
    return highlights;
}

/// Texels within `reach` [rad] of a highlight.
std::vector<std::uint32_t> texelsNear(const Highlight& highlight, int width, int height, float reach) {
    Vector3f middle = Vector3f::Zero();
    std::vector<Vector3f> directions;
    for (const std::uint32_t i : highlight.texels) {
        directions.push_back(texelCentre(i, width, height));
        middle += directions.back();
    }
    middle.normalize();
    float radius = 0;
    for (const Vector3f& d : directions) radius = std::max(radius, (d - middle).norm());
    std::vector<std::uint32_t> texels;
    const float chord = 2 * std::sin(0.5f * std::min(reach, 3.0f));
    for (std::size_t i = 0; i < static_cast<std::size_t>(width) * static_cast<std::size_t>(height); ++i) {
        const Vector3f d = texelCentre(i, width, height);
        if ((d - middle).norm() > radius + chord) continue;
        if (std::ranges::any_of(directions, [&](const Vector3f& c) { return (c - d).squaredNorm() < chord * chord; }))
            texels.push_back(static_cast<std::uint32_t>(i));
    }
    return texels;
}

/// How the light that is missing may lie in a highlight: depth to this power, from a window to a lamp in its middle.
constexpr std::array<float, 3> kProfiles{0, 2, 8};

/// What all unclipped observations around a highlight say about one profile, per channel.
struct ProfileFit {
    Eigen::Vector3d product = Eigen::Vector3d::Zero();  ///< Σ w·seen·excess
    Eigen::Vector3d square = Eigen::Vector3d::Zero();   ///< Σ w·seen²
    Eigen::Vector3i count = Eigen::Vector3i::Zero();

    /// Radiance of the profile's peak that explains the excess best.
    [[nodiscard]] Vector3f missing() const {
        Vector3f result = Vector3f::Zero();
        for (int c = 0; c < 3; ++c)
            if (count[c] >= kMinConstraints && square[c] > 0 && product[c] > 0)
                result[c] = static_cast<float>(product[c] / square[c]);
        return result;
    }
    /// How much of the squared excess that explains.
    [[nodiscard]] double explained() const {
        double sum = 0;
        for (int c = 0; c < 3; ++c)
            if (missing()[c] > 0) sum += product[c] * product[c] / square[c];
        return sum;
    }
};

/// Raises one highlight by the profile and radiance whose tails explain, in the least squares sense, what the unclipped
/// observations around show more than their surroundings do; and takes the tails out of the light there.
void recoverHighlight(DirectionalMap& light, const Highlight& highlight, std::span<const LobeObservations> sources,
                      float texelAngle, const StepContext& context) {
    const int width = light.radiance.width();
    const int height = light.radiance.height();
    float alpha = 0;
    for (const LobeObservations& source : sources) alpha = std::max(alpha, source.alpha);
    const std::vector<std::uint32_t> near =
        texelsNear(highlight, width, height, 2 * kReach * alpha + 1.5f * texelAngle);

    // The surroundings without the highlight: a membrane over where its tails are.
    DirectionalMap ground{light.radiance, light.coverage};
    for (const std::uint32_t i : near) ground.coverage[i] = 0;
    fillDirections(ground, EnvironmentFill::Membrane, Vector3f::Zero(), context);
    ImageF depth(width, height, 0.0f);
    for (std::size_t k = 0; k < highlight.texels.size(); ++k) {
        depth[highlight.texels[k]] = highlight.depth[k];
        ground.radiance[highlight.texels[k]] = light.radiance[highlight.texels[k]];  // at least what was seen
    }

    struct Constraint {
        std::uint32_t texel;
        std::array<float, kProfiles.size()> seen;
    };
    std::vector<Constraint> constraints;
    std::array<ProfileFit, kProfiles.size()> fits;
    for (const LobeObservations& source : sources) {
        if (2 * source.alpha < 0.5f * texelAngle) continue;
        std::vector<std::uint32_t> rows;
        for (const std::uint32_t i : near)
            if (source.map.coverage[i] > 0) rows.push_back(i);
        const System system(source, rows, kHighlightSamples, texelAngle);
        std::size_t begin = 0;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const System::Row& row = system.rows[r];
            Vector3f expected = Vector3f::Zero();
            Constraint constraint{rows[r], {}};
            for (std::size_t k = begin; k < row.end; ++k) {
                const auto& [texel, weight] = system.entries[k];
                expected += weight * ground.radiance[texel];
                if (!(depth[texel] > 0)) continue;
                for (std::size_t p = 0; p < kProfiles.size(); ++p)
                    constraint.seen[p] += weight * std::pow(depth[texel], kProfiles[p]);
            }
            begin = row.end;
            constraints.push_back(constraint);
            const Vector3f excess = row.observed - expected;
            for (std::size_t p = 0; p < kProfiles.size(); ++p) {
                if (!(constraint.seen[p] > 0)) continue;
                for (int c = 0; c < 3; ++c) {
                    if ((row.clipped >> c & 1u) != 0) continue;
                    // Relative errors: the far tails tell the energy, the near ones rather the shape.
                    const float w = row.weight / std::max(row.observed[c] * row.observed[c], 1e-12f);
                    fits[p].product[c] += static_cast<double>(w * constraint.seen[p] * excess[c]);
                    fits[p].square[c] += static_cast<double>(w * constraint.seen[p] * constraint.seen[p]);
                    ++fits[p].count[c];
                }
            }
        }
    }
    const auto best = static_cast<std::size_t>(
        std::ranges::max_element(fits, {}, [](const ProfileFit& fit) { return fit.explained(); }) - fits.begin());
    const Vector3f missing = fits[best].missing();
    for (std::size_t k = 0; k < highlight.texels.size(); ++k) {
        const std::uint32_t i = highlight.texels[k];
        for (int c = 0; c < 3; ++c)
            if ((light.clipped[i] >> c & 1u) != 0)
                light.radiance[i][c] += missing[c] * std::pow(highlight.depth[k], kProfiles[best]);
    }
    for (const Constraint& constraint : constraints) {
        const std::uint32_t i = constraint.texel;
        for (int c = 0; c < 3; ++c)
            if ((light.clipped[i] >> c & 1u) == 0)
                light.radiance[i][c] = std::max(std::min(light.radiance[i][c], ground.radiance[i][c]),
                                                light.radiance[i][c] - missing[c] * constraint.seen[best]);
    }
}

}  // namespace

void deconvolve(DirectionalMap& light, std::span<const LobeObservations> sources, const StepContext& context) {
    const int width = light.radiance.width();
    const int height = light.radiance.height();
    const float texelAngle = std::numbers::pi_v<float> / static_cast<float>(height);
    const bool blurred = std::ranges::any_of(
        sources, [&](const LobeObservations& source) { return 2 * source.alpha >= 0.5f * texelAngle; });
    if (!blurred || height > kMaxRows) return;
    const float least = std::max(1e-9f, 1e-4f * light.mean().mean());
    for (Vector3f& value : light.radiance.pixels()) value = value.cwiseMax(least);

    std::vector<System> systems;
    for (const LobeObservations& source : sources) {
        context.progress.checkpoint(0);
        systems.emplace_back(source, observedTexels(source), kLobeSamples, texelAngle);
    }
    ImageRgb factor(width, height);
    ImageRgb weight(width, height);
    const float middle = light.clipped.empty() ? 1.0f : 0.5f;
    for (int iteration = 0; iteration < kFactorIterations; ++iteration) {
        context.progress.checkpoint(middle * static_cast<float>(iteration) / kFactorIterations);
        std::ranges::fill(factor.pixels(), Vector3f::Zero());
        std::ranges::fill(weight.pixels(), Vector3f::Zero());
        for (const System& system : systems) system.vote(light.radiance, factor, weight);
        for (std::size_t i = 0; i < light.radiance.size(); ++i)
            for (int c = 0; c < 3; ++c)
                if (light.coverage[i] > 0 && weight[i][c] > 0) light.radiance[i][c] *= factor[i][c] / weight[i][c];
    }
    if (light.clipped.empty()) return;
    std::vector<Highlight> highlights = findHighlights(light.clipped);
    std::ranges::stable_sort(highlights, std::greater<>(), [](const Highlight& h) { return h.texels.size(); });
    highlights.resize(std::min(highlights.size(), kMaxHighlights));
    for (std::size_t k = 0; k < highlights.size(); ++k) {
        const float fraction = middle + (1 - middle) * static_cast<float>(k) / static_cast<float>(highlights.size());
        recoverHighlight(light, highlights[k], sources, texelAngle, context.part(fraction, fraction));
    }
}

}  // namespace core::analysis
