// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/navigate_tool.h"

namespace ui {

QString NavigateTool::hint() const {
    return session().workspace().scene().segments.empty()
               ? tr("Nothing can be edited yet: choose Smart select and click an object.")
               : tr("Click a segment to edit it. Drag moves the picture, the wheel zooms.");
}

}  // namespace ui
