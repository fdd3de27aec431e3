// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "ui/panels/panel.h"

namespace ui {

/// One dock of the main window.
struct PanelEntry {
    const char* key;    ///< object name of the panel; its dock is `<key>Dock`
    const char* title;  ///< untranslated, context "PanelRegistry"
    Qt::DockWidgetArea area;
    bool tabbed;  ///< shares its place with the entry before it
    Panel* (*make)(Workspace&, QWidget* parent);

    [[nodiscard]] QString translatedTitle() const;
};

/// All panels, in the order of the docks. A new panel is one file and one line in registry.cpp.
[[nodiscard]] const std::vector<PanelEntry>& panelRegistry();

}  // namespace ui
