// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/fill_directions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/kernels.h"
#include "core/analysis/light/shepard.h"
#include "core/analysis/light/sphere_membrane.h"

namespace core::analysis {
namespace {

/// Laplace's equation, or with `screen` > 0 [rad] the screened one, Δu = u/screen², on the sphere of the map's texels:
/// u is given where coverage > 0. From coarse to fine, so that every level only has to settle its own detail.
void solveMembrane(const ImageF& coverage, ImageRgb& values, float screen, const StepContext& context) {
    const int width = values.width();
    const int height = values.height();
    if (height >= 16 && height % 2 == 0) {
        ImageF coarseCoverage(width / 2, height / 2, 0.0f);
        ImageRgb coarse(width / 2, height / 2, Vector3f::Zero());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (!(coverage(x, y) > 0)) continue;
                coarse(x / 2, y / 2) += values(x, y);
                coarseCoverage(x / 2, y / 2) += 1;
            }
        }
        for (std::size_t i = 0; i < coarse.size(); ++i)
            if (coarseCoverage[i] > 0) coarse[i] /= coarseCoverage[i];
        solveMembrane(coarseCoverage, coarse, screen, context);
        const DirectionalMap guess{std::move(coarse), {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (!(coverage(x, y) > 0))
                    values(x, y) = guess.lookupTexel(
                        {0.5f * (static_cast<float>(x) + 0.5f), 0.5f * (static_cast<float>(y) + 0.5f)});
    }

    context.kernels.relaxMembrane(coverage, membraneRows(height, screen), values, context.progress.part(0, 0));
}

void fillMembrane(DirectionalMap& map, const StepContext& context) {
    // Logarithms need a floor: a thousandth of the mean of what was observed.
    const Vector3f floor = (map.mean(std::numeric_limits<float>::min()) * 1e-3f).cwiseMax(1e-9f);
    DirectionalMap logarithms{ImageRgb(map.radiance.width(), map.radiance.height(), Vector3f::Zero()), map.coverage};
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (map.coverage[i] > 0) logarithms.radiance[i] = map.radiance[i].cwiseMax(floor).array().log();
    solveMembrane(map.coverage, logarithms.radiance, 0, context);
    for (std::size_t i = 0; i < map.radiance.size(); ++i)
        if (!(map.coverage[i] > 0)) map.radiance[i] = logarithms.radiance[i].array().exp();
}

}  // namespace

DirectionalAccumulator::DirectionalAccumulator(int height)
    : sum_(2 * height, height, Vector3f::Zero()),
      weight_(2 * height, height, Vector3f::Zero()),
      total_(2 * height, height, 0.0f),
      clipped_(2 * height, height, 7) {}

void DirectionalAccumulator::add(const Vector3f& direction, const Vector3f& radiance, float weight, unsigned clipped) {
    const Vector2f texel = DirectionalMap::texelFromDirection(direction, sum_.width(), sum_.height());
    const int x = static_cast<int>(std::floor(texel.x()));
    const int y = std::clamp(static_cast<int>(texel.y()), 0, sum_.height() - 1);
    const std::size_t i = sum_.index((x % sum_.width() + sum_.width()) % sum_.width(), y);
    total_[i] += weight;
    for (int c = 0; c < 3; ++c) {
        const unsigned bit = 1u << c;
        const bool onlyClipped = (clipped_[i] & bit) != 0;
        if ((clipped & bit) != 0 && !onlyClipped) continue;
        if ((clipped & bit) == 0 && onlyClipped) {
            sum_[i][c] = weight_[i][c] = 0;
            clipped_[i] = static_cast<std::uint8_t>(clipped_[i] & ~bit);
        }
        sum_[i][c] += weight * radiance[c];
        weight_[i][c] += weight;
    }
}

DirectionalMap DirectionalAccumulator::map() const {
    DirectionalMap result{sum_, total_};
    Image<std::uint8_t> clipped(sum_.width(), sum_.height(), 0);
    bool any = false;
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        if (!(total_[i] > 0)) continue;
        result.radiance[i] = sum_[i].cwiseQuotient(weight_[i]);
        clipped[i] = clipped_[i];
        any = any || clipped_[i] != 0;
    }
    if (any) result.clipped = std::move(clipped);
    return result;
}

void fillDirections(DirectionalMap& map, EnvironmentFill method, const Vector3f& fallback, const StepContext& context) {
    if (std::ranges::none_of(map.coverage.pixels(), [](float c) { return c > 0; })) {
        std::ranges::fill(map.radiance.pixels(), fallback);
    } else if (method == EnvironmentFill::Shepard) {
        context.kernels.fillShepard(DirectionTree(map), map, context.progress);
    } else {
        fillMembrane(map, context.part(0.5f, 0.5f));
    }
}

void completeDirections(DirectionalMap& map, const ImageRgb& user, const StepContext& context) {
    CORE_ASSERT(map.radiance.sameSize(user), "maps of one size");
    constexpr float kBlend = 0.06f;  // [rad]: the difference falls to a twentieth within ten degrees
    ImageRgb difference(user.width(), user.height(), Vector3f::Zero());
    for (std::size_t i = 0; i < user.size(); ++i)
        if (map.coverage[i] > 0) difference[i] = map.radiance[i] - user[i];
    solveMembrane(map.coverage, difference, kBlend, context);
    for (std::size_t i = 0; i < user.size(); ++i)
        if (!(map.coverage[i] > 0)) map.radiance[i] = (user[i] + difference[i]).cwiseMax(0.0f);
}

}  // namespace core::analysis
