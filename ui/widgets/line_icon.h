// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QRectF>

class QPainter;

namespace ui {

// Pictograms of one line width, written as text on a grid of 16 x 16: "M x y" moves, "L x y" draws a line, "Q cx cy x
// y" a quadratic curve, "O x y r" a circle, "R x y w h" a rectangle, "Z" closes a figure.
namespace icons {
inline constexpr const char* kRename = "M 3 13 L 3 10 L 10 3 L 13 6 L 6 13 Z M 8 5 L 11 8";
inline constexpr const char* kDuplicate = "R 2.5 5.5 8 8 M 5.5 5.5 L 5.5 2.5 L 13.5 2.5 L 13.5 10.5 L 10.5 10.5";
inline constexpr const char* kMerge = "M 8 4.4 Q 2 0.5 2 8 Q 2 15.5 8 11.6 Q 14 15.5 14 8 Q 14 0.5 8 4.4";
inline constexpr const char* kSplit = "O 4.5 8 2.8 O 11.5 8 2.8 M 8 1.5 L 8 4 M 8 6.5 L 8 9.5 M 8 12 L 8 14.5";
inline constexpr const char* kDelete =
    "M 2.5 4.5 L 13.5 4.5 M 6 4.5 L 6 2.5 L 10 2.5 L 10 4.5 M 4 4.5 L 4.7 13.5 L 11.3 13.5 L 12 4.5 M 6.6 7 L 6.8 11 "
    "M 9.4 7 L 9.2 11";
inline constexpr const char* kSelectPixels =
    "M 2.5 5 L 2.5 2.5 L 5 2.5 M 7 2.5 L 9 2.5 M 11 2.5 L 13.5 2.5 L 13.5 5 M 13.5 7 L 13.5 9 M 13.5 11 L 13.5 13.5 L "
    "11 "
    "13.5 M 9 13.5 L 7 13.5 M 5 13.5 L 2.5 13.5 L 2.5 11 M 2.5 9 L 2.5 7";
inline constexpr const char* kSelectEdited = "O 4 4 1.5 M 8 4 L 14 4 O 4 8 1.5 M 8 8 L 14 8 O 4 12 1.5 M 8 12 L 14 12";
inline constexpr const char* kGlossy = "O 8 8 6 M 4.6 7.4 Q 4.8 4.8 7.4 4.6";
inline constexpr const char* kChecked = "R 2.5 2.5 11 11 M 5 8 L 7.2 10.5 L 11 5.5";
inline constexpr const char* kUnchecked = "R 2.5 2.5 11 11";
inline constexpr const char* kLocked = "R 3.5 7.5 9 6 M 5.5 7.5 L 5.5 5 Q 5.5 2.5 8 2.5 Q 10.5 2.5 10.5 5 L 10.5 7.5";
inline constexpr const char* kUnlocked = "R 3.5 7.5 9 6 M 5.5 7.5 L 5.5 5 Q 5.5 2.5 8 2.5 Q 10.2 2.5 10.5 4.5";
inline constexpr const char* kShown = "M 1.5 8 Q 4 3.5 8 3.5 Q 12 3.5 14.5 8 Q 12 12.5 8 12.5 Q 4 12.5 1.5 8 O 8 8 2.2";
inline constexpr const char* kHidden =
    "M 1.5 8 Q 4 3.5 8 3.5 Q 12 3.5 14.5 8 Q 12 12.5 8 12.5 Q 4 12.5 1.5 8 M 3 13.5 L 13 2.5";
inline constexpr const char* kImport =
    "M 8 2 L 8 10 M 4.5 6.5 L 8 10 L 11.5 6.5 M 2.5 10.5 L 2.5 13.5 L 13.5 13.5 L 13.5 10.5";
inline constexpr const char* kExport =
    "M 8 10 L 8 2 M 4.5 5.5 L 8 2 L 11.5 5.5 M 2.5 10.5 L 2.5 13.5 L 13.5 13.5 L 13.5 10.5";
}  // namespace icons

/// Draws a pictogram into a rectangle of any size.
void paintLineIcon(QPainter& painter, const char* icon, const QRectF& place, const QColor& color);
/// In the colours of the application's palette, with a disabled state.
[[nodiscard]] QIcon lineIcon(const char* icon);

}  // namespace ui
