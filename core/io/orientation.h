// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/image.h"

namespace core {

/// Turns a stored raster into the displayed one. `orientation` is the EXIF tag: 1 = as stored, 2..8 = mirrored and
/// rotated; 5..8 exchange width and height.
template <class T>
[[nodiscard]] Image<T> applyOrientation(Image<T> stored, int orientation) {
    if (orientation <= 1 || orientation > 8) return stored;
    const int w = stored.width();
    const int h = stored.height();
    const bool transposed = orientation >= 5;
    const bool mirrorX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool mirrorY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image<T> displayed(transposed ? h : w, transposed ? w : h);
    for (int y = 0; y < displayed.height(); ++y)
        for (int x = 0; x < displayed.width(); ++x) {
            const int u = transposed ? y : x;
            const int v = transposed ? x : y;
            displayed(x, y) = stored(mirrorX ? w - 1 - u : u, mirrorY ? h - 1 - v : v);
        }
    return displayed;
}

/// The camera of the displayed raster, from that of the stored one.
[[nodiscard]] inline Camera orientCamera(const Camera& stored, int orientation) {
    if (orientation <= 1 || orientation > 8) return stored;
    const bool mirrorX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool mirrorY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Camera turned = stored;
    if (mirrorX) turned.cx = static_cast<float>(stored.width) - stored.cx;
    if (mirrorY) turned.cy = static_cast<float>(stored.height) - stored.cy;
    if (orientation < 5) return turned;
    return {turned.height, turned.width, turned.fy, turned.fx, turned.cy, turned.cx};
}

}  // namespace core
