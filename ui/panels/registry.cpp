// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/registry.h"

#include <QCoreApplication>

#include "ui/panels/back_side_panel.h"
#include "ui/panels/environment_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/render_panel.h"
#include "ui/panels/segments_panel.h"

namespace ui {

namespace {
template <class T>
Panel* makePanel(Workspace& workspace, QWidget* parent) {
    return new T(workspace, parent);
}
}  // namespace

QString PanelEntry::translatedTitle() const { return QCoreApplication::translate("PanelRegistry", title); }

const std::vector<PanelEntry>& panelRegistry() {
    static const std::vector<PanelEntry> kPanels = {
        {"segments", QT_TRANSLATE_NOOP("PanelRegistry", "Segments"), Qt::LeftDockWidgetArea, false,
         makePanel<SegmentsPanel>},
        {"environment", QT_TRANSLATE_NOOP("PanelRegistry", "Light"), Qt::LeftDockWidgetArea, false,
         makePanel<EnvironmentPanel>},
        {"material", QT_TRANSLATE_NOOP("PanelRegistry", "Material"), Qt::RightDockWidgetArea, false,
         makePanel<MaterialPanel>},
        {"backSide", QT_TRANSLATE_NOOP("PanelRegistry", "Back side"), Qt::RightDockWidgetArea, true,
         makePanel<BackSidePanel>},
        {"render", QT_TRANSLATE_NOOP("PanelRegistry", "Rendering"), Qt::RightDockWidgetArea, true,
         makePanel<RenderPanel>},
    };
    return kPanels;
}

}  // namespace ui
