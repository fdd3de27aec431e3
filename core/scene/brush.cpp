// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/brush.h"

#include <algorithm>
#include <cmath>

namespace core {

BrushStroke::BrushStroke(const Mask& before, const Brush& brush, const LabelImage& labels, std::uint16_t label)
    : before_(before),
      coverage_(before.width(), before.height()),
      mask_(before),
      brush_(brush),
      labels_(&labels),
      label_(label) {
    CORE_ASSERT(labels.width() == before.width() && labels.height() == before.height(), "labels of the mask's size");
}

void BrushStroke::moveTo(float x, float y) {
    const Vector2f to(x, y);
    const Vector2f from = begun_ ? last_ : to;
    begun_ = true;
    last_ = to;
    const Vector2f along = to - from;
    const float length = std::max(along.squaredNorm(), 1e-12f);
    const float radius = std::max(brush_.radius, 0.5f);
    const float full = radius * std::clamp(brush_.hardness, 0.0f, 1.0f);
    // At least a pixel of slope, so that a hard brush has no stairs.
    const float slope = std::max(radius - full, 1.0f);
    // Clamped before the conversion: the pointer may be far outside the picture.
    const auto pixel = [](float v, int size) {
        return static_cast<int>(std::floor(std::clamp(v, -1.0f, static_cast<float>(size))));
    };
    const int x0 = pixel(std::min(from.x(), to.x()) - radius - 1, mask_.width());
    const int x1 = pixel(std::max(from.x(), to.x()) + radius + 1, mask_.width());
    const int y0 = pixel(std::min(from.y(), to.y()) - radius - 1, mask_.height());
    const int y1 = pixel(std::max(from.y(), to.y()) + radius + 1, mask_.height());
    const auto falloff = [&](int px, int py) {
        const Vector2f p(static_cast<float>(px) + 0.5f, static_cast<float>(py) + 0.5f);
        const float t = std::clamp((p - from).dot(along) / length, 0.0f, 1.0f);
        const float distance = (p - from - t * along).norm();
        const float s = std::clamp((full + slope - distance) / slope, 0.0f, 1.0f);
        return s * s * (3 - 2 * s);
    };
    coverage_.change(x0, y0, x1, y1, [&](int px, int py, float old) {
        return (*labels_)(px, py) == label_ ? std::max(old, falloff(px, py)) : old;
    });
    const float target = brush_.erase ? 0.0f : 1.0f;
    mask_.change(x0, y0, x1, y1, [&](int px, int py, float) {
        const float before = before_.value(px, py);
        return before + (target - before) * std::clamp(brush_.strength, 0.0f, 1.0f) * coverage_.value(px, py);
    });
}

}  // namespace core
