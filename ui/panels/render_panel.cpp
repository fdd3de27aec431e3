// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/render_panel.h"

#include <QGroupBox>
#include <QVBoxLayout>

#include "ui/widgets/param_control.h"

namespace ui {

RenderPanel::RenderPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    for (const auto& [group, title] : {std::pair(core::ParamGroup::Picture, tr("Picture")),
                                       std::pair(core::ParamGroup::Translucency, tr("Translucency")),
                                       std::pair(core::ParamGroup::Depth, tr("Depth"))}) {
        auto* box = new QGroupBox(title, this);
        addControls(group, new QVBoxLayout(box));
        layout->addWidget(box);
    }
    layout->addStretch(1);
    connect(&workspace, &Workspace::sceneChanged, this, &RenderPanel::refresh);
    refresh();
}

void RenderPanel::refresh() {
    setEnabled(workspace().hasPhoto());
    refreshControls();
    const core::DepthFilterParams& depth = workspace().scene().depthFilter;
    control("depth_filter.automatic")->setEnabled(depth.enabled);
    for (const char* key : {"depth_filter.spatial_sigma", "depth_filter.color_sigma", "depth_filter.depth_sigma"})
        control(key)->setEnabled(depth.enabled && !depth.automatic);
}

}  // namespace ui
