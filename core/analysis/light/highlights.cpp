// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/highlights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/analysis/light/directional_accumulator.h"
#include "core/analysis/light/fill_directions.h"

namespace core::analysis {
namespace {

/// Half vectors per lobe; many, because the tails matter.
constexpr int kHighlightSamples = 512;
/// Half vectors up to this many α from a clipped texel show its tails.
constexpr float kReach = 4;
/// Number of highlights that are raised, the largest ones.
constexpr std::size_t kMaxHighlights = 16;
/// Minimum number of unclipped observations that see a highlight.
constexpr int kMinConstraints = 8;

Vector3f texelCenter(std::size_t i, int width, int height) {
    const auto w = static_cast<std::size_t>(width);
    return DirectionalMap::directionFromTexel({static_cast<float>(i % w) + 0.5f, static_cast<float>(i / w) + 0.5f},
                                              width, height);
}

/// Texels clipped in some channel that touch each other.
struct Highlight {
    std::vector<std::uint32_t> texels;
    std::vector<float> depth;  ///< per texel: its distance to the outline over the deepest one's, (0, 1]
};

/// The four neighbours of a texel, wrapping around in x; −1 beyond a pole.
std::array<std::int64_t, 4> neighborTexels(const Image<std::uint8_t>& map, std::uint32_t i) {
    const int width = map.width();
    const int x = static_cast<int>(i) % width;
    const int y = static_cast<int>(i) / width;
    const auto index = [&](int nx, int ny) { return static_cast<std::int64_t>(map.index(nx, ny)); };
    return {index((x + 1) % width, y), index((x + width - 1) % width, y), y > 0 ? index(x, y - 1) : -1,
            y + 1 < map.height() ? index(x, y + 1) : -1};
}

/// All clipped texels connected to `start`; marks them as visited.
std::vector<std::uint32_t> connectedTexels(const Image<std::uint8_t>& clipped, std::uint32_t start,
                                           Image<std::uint8_t>& visited) {
    std::vector<std::uint32_t> texels{start};
    visited[start] = 1;
    for (std::size_t k = 0; k < texels.size(); ++k) {
        for (const std::int64_t n : neighborTexels(clipped, texels[k])) {
            if (n < 0) continue;
            const auto next = static_cast<std::size_t>(n);
            if (clipped[next] == 0 || visited[next] != 0) continue;
            visited[next] = 1;
            texels.push_back(static_cast<std::uint32_t>(next));
        }
    }
    return texels;
}

/// Highlight::depth of connected texels. `distance` is 0 at all of them, and left as the number of texels to the
/// outline.
std::vector<float> relativeDepth(const Image<std::uint8_t>& clipped, std::span<const std::uint32_t> texels,
                                 ImageF& distance) {
    std::vector<std::uint32_t> front;
    for (const std::uint32_t i : texels) {
        const bool outline = std::ranges::any_of(neighborTexels(clipped, i), [&](std::int64_t n) {
            return n >= 0 && clipped[static_cast<std::size_t>(n)] == 0;
        });
        if (!outline) continue;
        distance[i] = 1;
        front.push_back(i);
    }
    float deepest = 1;
    for (std::size_t k = 0; k < front.size(); ++k) {
        for (const std::int64_t n : neighborTexels(clipped, front[k])) {
            if (n < 0) continue;
            const auto next = static_cast<std::size_t>(n);
            if (clipped[next] == 0 || distance[next] > 0) continue;
            distance[next] = distance[front[k]] + 1;
            deepest = std::max(deepest, distance[next]);
            front.push_back(static_cast<std::uint32_t>(next));
        }
    }
    std::vector<float> depth;
    for (const std::uint32_t i : texels) depth.push_back(distance[i] / deepest);
    return depth;
}

/// The largest highlights, in descending order of size.
std::vector<Highlight> findHighlights(const Image<std::uint8_t>& clipped) {
    std::vector<Highlight> highlights;
    ImageF distance(clipped.width(), clipped.height(), 0.0f);
    Image<std::uint8_t> visited(clipped.width(), clipped.height(), 0);
    for (std::size_t start = 0; start < clipped.size(); ++start) {
        if (clipped[start] == 0 || visited[start] != 0) continue;
        Highlight highlight;
        highlight.texels = connectedTexels(clipped, static_cast<std::uint32_t>(start), visited);
        highlight.depth = relativeDepth(clipped, highlight.texels, distance);
        highlights.push_back(std::move(highlight));
    }
    std::ranges::stable_sort(highlights, std::greater<>(), [](const Highlight& h) { return h.texels.size(); });
    highlights.resize(std::min(highlights.size(), kMaxHighlights));
    return highlights;
}

/// Texels within `reach` [rad] of a highlight.
std::vector<std::uint32_t> texelsNear(const Highlight& highlight, int width, int height, float reach) {
    Vector3f middle = Vector3f::Zero();
    std::vector<Vector3f> directions;
    for (const std::uint32_t i : highlight.texels) {
        directions.push_back(texelCenter(i, width, height));
        middle += directions.back();
    }
    middle.normalize();
    float radius = 0;
    for (const Vector3f& d : directions) radius = std::max(radius, (d - middle).norm());
    std::vector<std::uint32_t> texels;
    const float chord = 2 * std::sin(0.5f * std::min(reach, 3.0f));
    for (std::size_t i = 0; i < static_cast<std::size_t>(width) * static_cast<std::size_t>(height); ++i) {
        const Vector3f d = texelCenter(i, width, height);
        if ((d - middle).norm() > radius + chord) continue;
        if (std::ranges::any_of(directions, [&](const Vector3f& c) { return (c - d).squaredNorm() < chord * chord; }))
            texels.push_back(static_cast<std::uint32_t>(i));
    }
    return texels;
}

/// Distributions of the missing light in a highlight: depth to this power, from a window to a lamp in its middle.
constexpr std::array<float, 3> kProfiles{0, 2, 8};

/// Least-squares fit of one profile to all unclipped observations around a highlight, per channel.
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
    /// The part of the squared excess that this radiance explains.
    [[nodiscard]] double explained() const {
        double sum = 0;
        for (int c = 0; c < 3; ++c)
            if (missing()[c] > 0) sum += product[c] * product[c] / square[c];
        return sum;
    }
};

/// An observation around a highlight.
struct Constraint {
    std::uint32_t texel;
    std::array<float, kProfiles.size()> seen;  ///< radiance it would show per unit of each profile's peak
};

/// One highlight and its surroundings.
struct HighlightFit {
    std::vector<std::uint32_t> near;  ///< texels its tails reach
    ImageRgb ground;                  ///< the light without the highlight's tails and without what was clipped
    ImageF depth;                     ///< Highlight::depth, 0 outside
    std::vector<Constraint> constraints;
    std::array<ProfileFit, kProfiles.size()> profiles;
};

/// The surroundings without the highlight: a membrane over the texels that its tails reach.
HighlightFit surroundingsOf(const Highlight& highlight, const DirectionalMap& light,
                            std::span<const LobeObservations> sources, const StepContext& context) {
    const int width = light.radiance.width();
    const int height = light.radiance.height();
    float alpha = 0;
    for (const LobeObservations& source : sources) alpha = std::max(alpha, source.alpha);
    HighlightFit fit;
    fit.near = texelsNear(highlight, width, height, 2 * kReach * alpha + 1.5f * texelAngle(height));
    DirectionalMap ground{light.radiance, light.coverage};
    for (const std::uint32_t i : fit.near) ground.coverage[i] = 0;
    fillDirections(ground, EnvironmentFill::Membrane, Vector3f::Zero(), context);
    fit.ground = std::move(ground.radiance);
    fit.depth = ImageF(width, height, 0.0f);
    for (std::size_t k = 0; k < highlight.texels.size(); ++k) {
        const std::uint32_t i = highlight.texels[k];
        fit.depth[i] = highlight.depth[k];
        fit.ground[i] = light.radiance[i];  // the lower bound that was observed
    }
    return fit;
}

/// Adds one observation to the fits of all profiles.
void addConstraint(const LobeSystem::Row& row, std::uint32_t texel, std::span<const LobeSystem::Entry> entries,
                   HighlightFit& fit) {
    Vector3f expected = Vector3f::Zero();
    Constraint constraint{texel, {}};
    for (const auto& [other, weight] : entries) {
        expected += weight * fit.ground[other];
        if (!(fit.depth[other] > 0)) continue;
        for (std::size_t p = 0; p < kProfiles.size(); ++p)
            constraint.seen[p] += weight * std::pow(fit.depth[other], kProfiles[p]);
    }
    fit.constraints.push_back(constraint);
    const Vector3f excess = row.observed - expected;
    for (std::size_t p = 0; p < kProfiles.size(); ++p) {
        if (!(constraint.seen[p] > 0)) continue;
        for (int c = 0; c < 3; ++c) {
            if ((row.clipped >> c & 1u) != 0) continue;
            // Relative errors: the far tails determine the energy, the near ones rather the shape.
            const float w = row.weight / std::max(row.observed[c] * row.observed[c], 1e-12f);
            fit.profiles[p].product[c] += static_cast<double>(w * constraint.seen[p] * excess[c]);
            fit.profiles[p].square[c] += static_cast<double>(w * constraint.seen[p] * constraint.seen[p]);
            ++fit.profiles[p].count[c];
        }
    }
}

void fitProfiles(std::span<const LobeObservations> sources, HighlightFit& fit, const Progress& progress) {
    for (std::size_t s = 0; s < sources.size(); ++s) {
        progress.checkpoint(static_cast<float>(s) / static_cast<float>(sources.size()));
        const LobeObservations& source = sources[s];
        if (!source.isBlurred()) continue;
        std::vector<std::uint32_t> texels;
        for (const std::uint32_t i : fit.near)
            if (source.map.coverage[i] > 0) texels.push_back(i);
        const LobeSystem system(source, texels, kHighlightSamples);
        for (std::size_t r = 0; r < texels.size(); ++r)
            addConstraint(system.rows[r], texels[r], system.entriesOf(r), fit);
    }
}

/// Raises the highlight by the best profile, and takes its tails out of the light around.
void applyBestProfile(const Highlight& highlight, const HighlightFit& fit, DirectionalMap& light) {
    const auto best = static_cast<std::size_t>(
        std::ranges::max_element(fit.profiles, {}, [](const ProfileFit& p) { return p.explained(); }) -
        fit.profiles.begin());
    const Vector3f missing = fit.profiles[best].missing();
    for (std::size_t k = 0; k < highlight.texels.size(); ++k) {
        const std::uint32_t i = highlight.texels[k];
        for (int c = 0; c < 3; ++c)
            if ((light.clipped[i] >> c & 1u) != 0)
                light.radiance[i][c] += missing[c] * std::pow(highlight.depth[k], kProfiles[best]);
    }
    for (const Constraint& constraint : fit.constraints) {
        const std::uint32_t i = constraint.texel;
        for (int c = 0; c < 3; ++c)
            if ((light.clipped[i] >> c & 1u) == 0)
                light.radiance[i][c] = std::max(std::min(light.radiance[i][c], fit.ground[i][c]),
                                                light.radiance[i][c] - missing[c] * constraint.seen[best]);
    }
}

}  // namespace

void recoverHighlights(DirectionalMap& light, std::span<const LobeObservations> sources, const StepContext& context) {
    const std::vector<Highlight> highlights = findHighlights(light.clipped);
    const auto count = static_cast<float>(highlights.size());
    for (std::size_t k = 0; k < highlights.size(); ++k) {
        const StepContext part = context.part(static_cast<float>(k) / count, static_cast<float>(k + 1) / count);
        HighlightFit fit = surroundingsOf(highlights[k], light, sources, part.part(0, 0.5f));
        fitProfiles(sources, fit, part.progress.part(0.5f, 1));
        applyBestProfile(highlights[k], fit, light);
    }
}

}  // namespace core::analysis
