// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/image.h"

namespace core::analysis {

/// The lobe of a glossy surface is a GGX one: half vectors h about the normal n with tan²θ_h = α²·u/(1 − u), u uniform;
/// a fraction t²/(t² + α²) of them is nearer to n than tan θ_h = t. The rings below are a grid of t that all widths
/// share: what a ring shows is traced once, a width only changes the weights.
inline constexpr int kLobeRings = 12;
inline constexpr int kRaysPerRing = 6;
inline constexpr float kInnerRing = 0.004f;  ///< tan θ_h inside of which a lobe is its mirrored ray
inline constexpr float kOuterRing = 0.9f;
/// Widths that are told apart.
inline constexpr float kMinLobeWidth = 0.008f;
inline constexpr float kMaxLobeWidth = 0.5f;

/// Part of a lobe of width `alpha` that lies in ring `i`; 0 is the mirrored ray's own disc, the last ring takes the
/// rest. The weights of rings 0 to kLobeRings add up to 1.
[[nodiscard]] float ringWeight(int i, float alpha);

/// tan θ_h in the middle of ring `i` (0 for the innermost).
[[nodiscard]] float ringTangent(int i);

/// One pixel of a glossy segment: what it shows, and what each ring of its lobe meets.
struct LobeProbe {
    LobeProbe() { incident.fill(Vector3f::Zero()); }

    Vector3f color{0, 0, 0};
    std::array<Vector3f, kLobeRings + 1> incident;  ///< mean radiance of the known rays of the ring
    std::array<float, kLobeRings + 1> known{};      ///< fraction of the ring's rays whose radiance is known
};

struct LobeFit {
    float alpha = 0;         ///< GGX width
    bool reliable = false;   ///< what is reflected has enough detail to tell widths apart
    Vector3f rho{1, 1, 1};   ///< reflected over incident for that width
    std::size_t probes = 0;  ///< how many could be used
};

/// Width and reflectance of the lobe that explain the probes: the α for which |color − ρ·Σ weight·incident| is least
/// (sum of absolute values: outliers do not pull), ρ by trimmed ratio of sums. nullopt with fewer than 50 usable
/// probes.
[[nodiscard]] std::optional<LobeFit> fitLobe(std::span<const LobeProbe> probes);

/// Offsets of a lobe's half vectors in the tangent plane of the normal, (tan θ_h cos φ, tan θ_h sin φ): `count` of
/// equal weight.
[[nodiscard]] std::vector<Vector2f> lobeOffsets(float alpha, int count);

}  // namespace core::analysis
