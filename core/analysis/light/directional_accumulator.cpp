// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/directional_accumulator.h"

#include <algorithm>
#include <cmath>

namespace core::analysis {

DirectionalAccumulator::DirectionalAccumulator(int rows)
    : sum_(2 * rows, rows, Vector3f::Zero()),
      weight_(2 * rows, rows, Vector3f::Zero()),
      total_(2 * rows, rows, 0.0f),
      clipped_(2 * rows, rows, 7) {}

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

}  // namespace core::analysis
