// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace ui {

/// Dark, neutral grey everywhere: a coloured or bright surround changes how a photograph is seen. The mouse wheel
/// scrolls panels and changes no value in them (see WheelGuard).
void applyStyle(QApplication& application);

}  // namespace ui
