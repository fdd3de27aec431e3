// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/camera.h"

#include <cmath>

core::Camera core::Camera::fromHorizontalFov(int width, int height, float hfov) {
    const float f = 0.5f * static_cast<float>(width) / std::tan(0.5f * hfov);
    return {width, height, f, f, 0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)};
}
