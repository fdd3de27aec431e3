// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace ui {

/// Dark, neutral grey everywhere: a coloured or bright surround changes how a photograph is seen.
void applyStyle(QApplication& application);

}  // namespace ui
