// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include <algorithm>
#include <cmath>

namespace ui {

core::Pixel Tool::pixelAt(const QPointF& position) {
    // Farther positions lie outside every picture.
    constexpr double kFar = 1e6;
    return {static_cast<int>(std::floor(std::clamp(position.x(), -kFar, kFar))),
            static_cast<int>(std::floor(std::clamp(position.y(), -kFar, kFar)))};
}

bool Tool::inPicture(const core::Pixel& pixel) const {
    return session_.photo() != nullptr && session_.photo()->color.contains(pixel.x, pixel.y);
}

}  // namespace ui
