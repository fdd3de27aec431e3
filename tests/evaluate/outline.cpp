// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace evaluate {

Outline ellipseOutline(const core::Vector2f& center, const core::Vector2f& radii) {
    constexpr int kCorners = 128;
    Outline outline;
    for (int i = 0; i < kCorners; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kCorners;
        outline.push_back(center + radii.cwiseProduct(core::Vector2f(std::cos(angle), std::sin(angle))));
    }
    return outline;
}

Outline curveOutline(const Outline& points) {
    constexpr int kPieces = 8;
    const std::size_t n = points.size();
    Outline outline;
    for (std::size_t i = 0; i < n; ++i) {
        const core::Vector2f& before = points[(i + n - 1) % n];
        const core::Vector2f& from = points[i];
        const core::Vector2f& to = points[(i + 1) % n];
        const core::Vector2f& after = points[(i + 2) % n];
        for (int piece = 0; piece < kPieces; ++piece) {
            const float t = static_cast<float>(piece) / kPieces;
            outline.push_back(0.5f * (2 * from + t * (to - before) + t * t * (2 * before - 5 * from + 4 * to - after) +
                                      t * t * t * (3 * from - before - 3 * to + after)));
        }
    }
    return outline;
}

void fillOutlines(core::LabelImage& labels, const std::vector<Outline>& outlines, std::uint16_t label,
                  const core::ImageF* mask) {
    std::vector<float> crossings;
    for (int y = 0; y < labels.height(); ++y) {
        const float line = static_cast<float>(y) + 0.5f;
        crossings.clear();
        for (const Outline& outline : outlines) {
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const core::Vector2f& a = outline[i];
                const core::Vector2f& b = outline[(i + 1) % outline.size()];
                if ((a.y() <= line) == (b.y() <= line)) continue;
                crossings.push_back(a.x() + (line - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int x0 = std::max(static_cast<int>(std::ceil(crossings[i] - 0.5f)), 0);
            const int x1 = std::min(static_cast<int>(std::ceil(crossings[i + 1] - 0.5f)), labels.width());
            for (int x = x0; x < x1; ++x)
                if (mask == nullptr || (*mask)(x, y) > 0) labels(x, y) = label;
        }
    }
}

}  // namespace evaluate
