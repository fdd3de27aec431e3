// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/fill_directions.h"

#include <algorithm>
#include <limits>

#include "core/analysis/kernels.h"
#include "core/analysis/light/shepard.h"
#include "core/analysis/light/sphere_membrane.h"

namespace core::analysis {
namespace {

void fillMembrane(DirectionalMap& map, const StepContext& context) {
    // Logarithms need a lower bound: a thousandth of the mean of the observations.
    const Vector3f floor = (map.mean(std::numeric_limits<float>::min()) * 1e-3f).cwiseMax(1e-9f);
    DirectionalMap logarithms{ImageRgb(map.radiance.width(), map.radiance.height(), Vector3f::Zero()), map.coverage};
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (map.coverage[i] > 0) logarithms.radiance[i] = map.radiance[i].cwiseMax(floor).array().log();
    solveSphereMembrane(map.coverage, logarithms.radiance, 0, context);
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (!(map.coverage[i] > 0)) map.radiance[i] = logarithms.radiance[i].array().exp();
}

}  // namespace

void fillDirections(DirectionalMap& map, EnvironmentFill method, const Vector3f& fallback, const StepContext& context) {
    if (std::ranges::none_of(map.coverage.pixels(), [](float c) { return c > 0; })) {
        std::ranges::fill(map.radiance.pixels(), fallback);
    } else if (method == EnvironmentFill::Shepard) {
        context.kernels.fillShepard(DirectionTree(map), map, context.progress);
    } else {
        fillMembrane(map, context);
    }
}

void completeDirections(DirectionalMap& map, const ImageRgb& user, const StepContext& context) {
    CORE_ASSERT(map.radiance.sameSize(user), "maps of one size");
    // [rad] The difference falls to a twentieth within ten degrees.
    constexpr float kBlend = 0.06f;
    ImageRgb difference(user.width(), user.height(), Vector3f::Zero());
    for (std::size_t i = 0; i < user.size(); ++i)
        if (map.coverage[i] > 0) difference[i] = map.radiance[i] - user[i];
    solveSphereMembrane(map.coverage, difference, kBlend, context);
    for (std::size_t i = 0; i < user.size(); ++i)
        if (!(map.coverage[i] > 0)) map.radiance[i] = (user[i] + difference[i]).cwiseMax(0.0f);
}

}  // namespace core::analysis
