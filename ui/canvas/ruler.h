// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

namespace ui {

/// A length to be drawn beside a picture.
struct Ruler {
    double millimetres = 0;  ///< 1, 2 or 5 times a power of ten
    double pixels = 0;       ///< device pixels
    bool operator==(const Ruler&) const = default;
};

/// The longest round length of at most 200, and thus at least 80, logical pixels. `millimetresPerPixel` [mm per device
/// pixel]; no length unless it is finite and > 0.
[[nodiscard]] Ruler roundRuler(double millimetresPerPixel, double devicePixelRatio);

/// "5 mm", "2 cm", "0.1 mm", "1 m".
[[nodiscard]] QString rulerText(double millimetres);

/// The ruler with its text, white with a dark rim on nothing, premultiplied RGBA8888 of device pixels.
[[nodiscard]] QImage rulerImage(const Ruler& ruler, double devicePixelRatio);

}  // namespace ui
