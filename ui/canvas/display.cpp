// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/display.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/color.h"

namespace ui {

float encodeSrgb(float linear) { return core::srgbEncode(std::clamp(linear, 0.0f, 1.0f)); }

float decodeSrgb(float encoded) { return core::srgbDecode(std::clamp(encoded, 0.0f, 1.0f)); }

QColor displayColor(const core::Vector3f& linear) {
    return QColor::fromRgbF(encodeSrgb(linear.x()), encodeSrgb(linear.y()), encodeSrgb(linear.z()));
}

core::Vector3f linearColor(const QColor& color) {
    return {decodeSrgb(color.redF()), decodeSrgb(color.greenF()), decodeSrgb(color.blueF())};
}

QImage displayImage(const core::ImageRgb& linear, float exposureStops) {
    QImage image(linear.width(), linear.height(), QImage::Format_RGB32);
    const float gain = std::exp2(exposureStops);
    for (int y = 0; y < linear.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < linear.width(); ++x) row[x] = displayColor(linear(x, y) * gain).rgb();
    }
    return image;
}

core::Vector3f segmentColor(std::uint16_t label) {
    if (label == 0) return {0.13f, 0.13f, 0.13f};
    constexpr float kGoldenRatio = 0.618034f;
    const float turns = static_cast<float>(label) * kGoldenRatio;
    const float hue = turns - std::floor(turns);
    const float saturation = label % 2 == 0 ? 0.55f : 0.72f;
    const QColor color = QColor::fromHsvF(hue, saturation, 0.92f);
    return {color.redF(), color.greenF(), color.blueF()};
}

core::Vector3f rampColor(float t) {
    // Control points of matplotlib's viridis (CC0).
    static constexpr std::array<std::array<float, 3>, 6> kPoints = {{{0.267f, 0.005f, 0.329f},
                                                                     {0.254f, 0.265f, 0.530f},
                                                                     {0.164f, 0.471f, 0.558f},
                                                                     {0.135f, 0.659f, 0.518f},
                                                                     {0.478f, 0.821f, 0.318f},
                                                                     {0.993f, 0.906f, 0.144f}}};
    const float position = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(kPoints.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(position), kPoints.size() - 2);
    const float f = position - static_cast<float>(i);
    const core::Vector3f a(kPoints[i].data());
    const core::Vector3f b(kPoints[i + 1].data());
    return a + (b - a) * f;
}

}  // namespace ui
